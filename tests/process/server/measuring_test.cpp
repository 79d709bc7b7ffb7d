// Light that CUI lets a server measure, and gives up.
#include "process/server/live_server.h"

#include <chrono>
#include <csignal>
#include <filesystem>
#include <functional>
#include <thread>

namespace {

using namespace test;
namespace fs = std::filesystem;
using namespace std::chrono_literals;

class MeasuringLight : public LiveServer {
  protected:
    void SetUp() override {
        LiveServer::SetUp();
        writeText(folder() / "room.scn", "version = 2\nmodel = 'room.obj'\nmetresPerUnit = 1\n[sky]\n");
        start({}, "room.scn");
        ask({"camera", "set", "0", "2", "-8", "0", "-0.5", "1"}); // above the floor
    }
    static bool comes(const std::function<bool()>& what) {
        for (int i = 0; i < 200; ++i) {
            if (what()) return true;
            std::this_thread::sleep_for(50ms);
        }
        return false;
    }
    /// A grid that takes long.
    void startGrid(std::optional<RunningProgram>& measurer) {
        measurer.emplace(
            programPath("CUI"),
            Names{"--instance=" + instance.name(), "measure", "light", "grid", "fine.csv", "0.1", "0.25"},
            ProgramSettings{.folder = folder().path()});
        ASSERT_TRUE(comes([&] { return ask({"measure", "progress"}).starts_with("on "); }));
    }
};

TEST_F(MeasuringLight, IsPrintedAndWritten) {
    const std::string light = ask({"measure", "light", "0.5", "0.9"});
    EXPECT_TRUE(light.starts_with("illuminance ")) << light;
    EXPECT_NE(light.find("\nluminance "), std::string::npos) << light;
    EXPECT_EQ(ask({"measure", "light", "0.5", "0.9"}), light) << "it is the same again";
    EXPECT_NE(ask({"measure", "light", "grid", "a.csv", "0.1", "5"}).find(" points, mean "),
              std::string::npos);
    EXPECT_TRUE(bytes("a.csv").starts_with("x,y,z,lux,standard_error\n"));
    refused({"measure", "light", "grid", "none/a.csv", "0.1", "5"}, 73, "none");
    EXPECT_EQ(ask({"measure", "progress"}), "off\n");
}

TEST_F(MeasuringLight, IsGivenUpAndOthersAreAnsweredMeanwhile) {
    std::optional<RunningProgram> measurer;
    ASSERT_NO_FATAL_FAILURE(startGrid(measurer));
    EXPECT_EQ(ask({"get", "bloom"}), "0\n");
    refused({"measure", "light", "0.5", "0.9"}, 75, "is being measured already");
    ask({"measure", "stop"});
    EXPECT_EQ(measurer->wait().exitCode, 130);
    for (const int signal : {SIGINT, SIGKILL}) {
        ASSERT_NO_FATAL_FAILURE(startGrid(measurer));
        measurer->send(signal);
        EXPECT_EQ(measurer->wait().exitCode, signal == SIGINT ? 130 : -1);
        EXPECT_TRUE(comes([&] { return ask({"measure", "progress"}) == "off\n"; }));
    }
    ASSERT_NO_FATAL_FAILURE(startGrid(measurer));
    EXPECT_EQ(end(SIGTERM).exitCode, 143);
    EXPECT_EQ(measurer->wait().exitCode, 75);
    EXPECT_FALSE(fs::exists(folder() / "fine.csv"));
}

} // namespace
