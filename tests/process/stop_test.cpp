/// Ctrl-C and its kin: the program ends soon, with the signal's exit code, and leaves nothing behind.
#include "process/sample_scene.h"

#include <gtest/gtest.h>

namespace {

using Names = std::vector<std::string>;

class Stopping : public testing::Test {
  protected:
    void SetUp() override { test::writeRoom(folder / "room.obj"); }

    // A rendering of many minutes, stopped as soon as it is under way.
    test::ProgramResult stopRenderer(const std::vector<int>& signals, Names extra = {}) {
        Names arguments{"room.obj", "-w", "3000", "-h", "3000", "-a", "16", "-o", "a.png", "--progress=json"};
        arguments.insert(arguments.end(), extra.begin(), extra.end());
        test::RunningProgram program(test::programPath("Renderer"), arguments, {.folder = folder.path()});
        EXPECT_TRUE(program.waitForError("\"rendering\""));
        for (const int signal : signals) program.send(signal);
        return program.wait();
    }

    test::TemporaryFolder folder;
};

TEST_F(Stopping, ControlC) {
    const test::ProgramResult result = stopRenderer({SIGINT});
    EXPECT_EQ(result.exitCode, 130) << result.error;
    EXPECT_FALSE(result.timedOut);
    EXPECT_EQ(test::filesIn(folder.path()), Names{"room.obj"});
}

TEST_F(Stopping, Terminate) {
    EXPECT_EQ(stopRenderer({SIGTERM}).exitCode, 143);
    EXPECT_EQ(test::filesIn(folder.path()), Names{"room.obj"});
}

TEST_F(Stopping, TheTerminalIsClosed) {
    EXPECT_EQ(stopRenderer({SIGHUP}).exitCode, 129);
    EXPECT_EQ(test::filesIn(folder.path()), Names{"room.obj"});
}

TEST_F(Stopping, TheOldPictureStays) {
    test::writeText(folder / "a.png", "old");
    EXPECT_EQ(stopRenderer({SIGINT}).exitCode, 130);
    EXPECT_EQ(test::readBytes(folder / "a.png"), "old");
}

TEST_F(Stopping, ASecondSignalEndsAtOnce) {
    const test::ProgramResult result = stopRenderer({SIGINT, SIGINT, SIGINT});
    EXPECT_EQ(result.exitCode, 130) << result.error;
    EXPECT_EQ(test::filesIn(folder.path()), Names{"room.obj"});
}

TEST_F(Stopping, FinishedFramesOfAListStay) {
    test::writeCamera(folder / "quick.cam", 0, "width = 8\nheight = 8\nantialiasing = 1\n");
    test::writeCamera(folder / "slow.cam", 0, "width = 3000\nheight = 3000\nantialiasing = 16\n");
    test::writeText(folder / "film.lst", "quick.cam\nslow.cam\nquick.cam\n");
    test::RunningProgram program(test::programPath("Renderer"),
                                 {"room.obj", "-l", "film.lst", "-o", "f#.png", "--progress=json"},
                                 {.folder = folder.path()});
    ASSERT_TRUE(program.waitForError("\"frame\":2"));
    program.send(SIGINT);
    EXPECT_EQ(program.wait().exitCode, 130);
    EXPECT_EQ(test::filesIn(folder.path()),
              (Names{"f1.png", "film.lst", "quick.cam", "room.obj", "slow.cam"}));
}

TEST_F(Stopping, BuilderWhileItBuilds) {
    test::writeWaves(folder / "waves.obj", 500);
    for (const char* phase : {"importing", "building"}) {
        test::RunningProgram program(test::programPath("BSPBuilder"),
                                     {"waves.obj", "waves.bsp", "--threads=1", "--progress=json"},
                                     {.folder = folder.path()});
        ASSERT_TRUE(program.waitForError(phase));
        program.send(SIGINT);
        const test::ProgramResult result = program.wait();
        EXPECT_EQ(result.exitCode, 130) << phase << "\n" << result.error;
        EXPECT_EQ(test::filesIn(folder.path()), (Names{"room.obj", "waves.obj"})) << phase;
    }
}

} // namespace
