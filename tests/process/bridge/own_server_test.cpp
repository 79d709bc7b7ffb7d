// RTBridge --start, with the real RTServer.
#include "process/sample_scene.h"
#include "support/child_process.h"
#include "support/ipc_instance.h"
#include "support/run_program.h"

#include <gtest/gtest.h>

namespace {

using namespace test;

class OwnServer : public testing::Test {
  protected:
    std::vector<std::string> words(const std::string& scene) const {
        return {"--start", (instance.folder() / scene).string(), "--instance=" + instance.name(),
                "--listen=127.0.0.1:0"};
    }
    const IpcInstance instance;
};

TEST_F(OwnServer, ThatCannotLoadItsSceneEndsTheBridge) {
    writeText(instance.folder() / "broken.scn", "version = 1\nmodell = 3\n");
    const ProgramResult result =
        runProgram(programPath("RTBridge"), words("broken.scn"), {.timeoutSeconds = 60});
    EXPECT_EQ(result.exitCode, 65) << result.error;
    EXPECT_NE(result.error.find("modell"), std::string::npos) << result.error;
    const std::size_t told = result.error.find("the server has ended");
    EXPECT_NE(told, std::string::npos) << result.error;
    EXPECT_EQ(told, result.error.rfind("the server has ended")) << result.error;
    EXPECT_TRUE(instance.segments().empty());
}

TEST_F(OwnServer, EndsWithTheBridgeHoweverThatEnds) {
    writeRoom(instance.folder() / "room.obj");
    for (const int signal : {SIGTERM, SIGKILL}) {
        ChildProcess bridge(programPath("RTBridge").string(), words("room.obj"),
                            {.outputFile = (instance.folder() / "links").string()});
        EXPECT_TRUE(eventually([&] { return instance.segments().size() >= 2; }, 30s)) << signal;
        bridge.send(signal);
        const int status = bridge.wait(20s);
        EXPECT_EQ(WIFEXITED(status) ? WEXITSTATUS(status) : 0, signal == SIGTERM ? 143 : 0);
        EXPECT_TRUE(eventually([&] { return instance.segments().empty(); }, 20s)) << signal;
    }
}

} // namespace
