/// Renderer --report: what a run made, for programs.
#include "process/sample_scene.h"

#include "rtcore/neural/net_files.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace {

using Names = std::vector<std::string>;
using Json = nlohmann::json;

class RunReport : public testing::Test {
  protected:
    RunReport() { test::writeRoom(folder / "room.obj"); }

    test::ProgramResult render(Names options) {
        options.insert(options.begin(), {"room.obj", "-w", "40", "-h", "30", "--report=run.json"});
        return test::renderer(options, {.folder = folder.path()});
    }
    Json report() const { return Json::parse(test::readBytes(folder / "run.json")); }
    Json onlyFrame() const { return report()["frames"].at(0); }

    test::TemporaryFolder folder;
};

TEST_F(RunReport, TellsWhatAFrameIsAndTook) {
    ASSERT_EQ(render({"-o", "a.png", "--setting=path.seed=7"}).exitCode, 0);
    EXPECT_EQ(report()["scene"], "room.obj");
    EXPECT_TRUE(report()["software"].get<std::string>().starts_with("rtsuite "));
    ASSERT_EQ(report()["frames"].size(), 1U);
    const Json frame = onlyFrame();
    EXPECT_EQ(frame["number"], 1);
    EXPECT_EQ(frame["outputs"], Json::array({"a.png"}));
    EXPECT_GT(frame["renderSeconds"], 0);
    EXPECT_GT(frame["finishSeconds"], 0);
    EXPECT_EQ(frame["rays"]["primary"], 40 * 30);
    EXPECT_GT(frame["rays"]["shadow"], 0);
    EXPECT_EQ(frame["settings"]["width"], 40);
    EXPECT_EQ(frame["settings"]["path.seed"], 7);
    EXPECT_EQ(frame["settings"]["integrator"], "whitted");
    EXPECT_FALSE(frame.contains("denoising"));
}

TEST_F(RunReport, HasTheFramesThatARunMadeBeforeItFailed) {
    test::writeCamera(folder / "1.cam", 0);
    test::writeText(folder / "2.cam", "no camera");
    test::writeText(folder / "film.lst", "1.cam\n2.cam\n1.cam\n");
    EXPECT_EQ(render({"-l", "film.lst", "-o", "f#.png"}).exitCode, 65);
    const Json frames = report()["frames"];
    ASSERT_EQ(frames.size(), 2U);
    EXPECT_EQ(frames[0]["number"], 1);
    EXPECT_EQ(frames[1]["number"], 3);
    EXPECT_EQ(frames[1]["outputs"], Json::array({"f3.png"}));
}

TEST_F(RunReport, HoldsNamesOfAnyBytes) {
    const std::string name = "a\xff\"{b}.png";
    ASSERT_EQ(render({"-o", name}).exitCode, 0);
    EXPECT_EQ(onlyFrame()["outputs"], Json::array({"a\xef\xbf\xbd\"{b}.png"}));
}

TEST_F(RunReport, DestroysNothingAndNeedsItsPlace) {
    EXPECT_EQ(render({"-o", "a.png", "--report=room.obj"}).exitCode, 2) << "no .json";
    EXPECT_EQ(render({"-o", "a.png", "--report=none/run.json"}).exitCode, 73);
    EXPECT_EQ(render({"--preview=p", "--stand-by"}).exitCode, 2);
    test::writeText(folder / "room.json", "{}");
    EXPECT_EQ(test::filesIn(folder.path()), (Names{"room.json", "room.obj"}));
}

TEST_F(RunReport, TellsTheErrorThatANetLeaves) {
    if (rtcore::findNet(rtcore::fileOf(rtcore::Net::Base), {}, test::programPath("Renderer").parent_path())
            .file.empty())
        GTEST_SKIP() << "skipped: there are no weights beside the build";
    const auto denoising = [&](const char* samples) {
        // Steady light has an error that the halves of the samples do not tell.
        EXPECT_EQ(render({"-o", "a.png", "--integrator=path", "--look=sky", "--denoise=automatic", samples,
                          "--setting=indirect.mode=off"})
                      .exitCode,
                  0);
        return onlyFrame()["denoising"];
    };
    const Json fewest = denoising("--samples=15");
    EXPECT_EQ(fewest["net"], "base");
    EXPECT_EQ(fewest["weights"], rtcore::fileOf(rtcore::Net::Base).sha256);
    EXPECT_FALSE(fewest.contains("error"));
    const Json few = denoising("--samples=16");
    EXPECT_EQ(few["mixed"], false);
    EXPECT_GT(few["error"], 0);
    EXPECT_GE(few["largestError"], few["error"]);
    EXPECT_GE(few["brightDots"], 0);
    const Json many = denoising("--samples=64");
    EXPECT_EQ(many["mixed"], true);
    EXPECT_LT(many["error"], few["error"]);
}

} // namespace
