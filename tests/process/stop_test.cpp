/// Ctrl-C and its kin: the program ends soon, with the signal's exit code, and leaves nothing behind.
#include "process/sample_scene.h"

#include <gtest/gtest.h>

#include <chrono>
#include <filesystem>
#include <fstream>
#include <string>
#include <thread>

#include <sys/stat.h>
#include <unistd.h>

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

// The file that the program reads or writes may be a pipe whose partner says nothing.
class StoppingAtAPipe : public Stopping {
  protected:
    void SetUp() override {
        Stopping::SetUp();
        ASSERT_EQ(::mkfifo((folder / "pipe").c_str(), 0600), 0);
        ASSERT_EQ(::mkfifo((folder / "pipe.ppm").c_str(), 0600), 0);
    }
    /// A writer of the pipe, which can be opened only once the program reads it: it has begun its work.
    /// Nothing is open before the program is started, so nothing of this process is taken for it.
    int writerOnceRead(const std::string& name) const {
        for (int i = 0; i < 4000; ++i) {
            const int writer = ::open((folder / name).c_str(), O_WRONLY | O_NONBLOCK | O_CLOEXEC);
            if (writer >= 0) return writer;
            std::this_thread::sleep_for(std::chrono::milliseconds(5));
        }
        return -1;
    }
    /// Waits until the program handles SIGTERM itself: its own work begins after that.
    static void waitUntilItHandlesTermination(const test::RunningProgram& program) {
        const std::string status = "/proc/" + std::to_string(program.process()) + "/status";
        for (int i = 0; i < 4000; ++i) {
            std::ifstream lines(status);
            for (std::string line; std::getline(lines, line);)
                if (line.starts_with("SigCgt:") &&
                    (std::stoull(line.substr(7), nullptr, 16) >> (SIGTERM - 1) & 1) != 0)
                    return;
            std::this_thread::sleep_for(std::chrono::milliseconds(5));
        }
    }
    // Exit code after one SIGTERM, sent when it has nothing else to do.
    int stopped(const Names& arguments) {
        const test::ProgramSettings settings{.folder = folder.path(), .timeoutSeconds = 20};
        test::RunningProgram program(test::programPath("Renderer"), arguments, settings);
        waitUntilItHandlesTermination(program);
        std::this_thread::sleep_for(std::chrono::milliseconds(700));
        program.send(SIGTERM);
        return program.wait().exitCode;
    }
};

TEST_F(StoppingAtAPipe, OneSignalIsEnough) {
    EXPECT_EQ(stopped({"room.obj", "--camera=pipe", "-o", "a.png"}), 143) << "nobody writes";
    EXPECT_EQ(stopped({"room.obj", "-w", "8", "-h", "8", "-o", "pipe.ppm"}), 143) << "nobody reads";
    const int partner = ::open((folder / "pipe").c_str(), O_RDWR | O_CLOEXEC);
    ASSERT_GE(partner, 0);
    ASSERT_EQ(::write(partner, "version = 1\n", 12), 12);
    EXPECT_EQ(stopped({"room.obj", "--set=pipe", "-o", "a.png"}), 143) << "the writer says no more";
    ::close(partner);
    EXPECT_EQ(test::filesIn(folder.path()), (Names{"pipe", "pipe.ppm", "room.obj"}));
}

// The instance is named: without a name it would ask for one among the servers of other tests, and end.
TEST_F(StoppingAtAPipe, AScriptThatSaysNothing) {
    test::RunningProgram program(test::programPath("CUI"), {"script", "pipe", "--instance=t-no-server"},
                                 {.folder = folder.path()});
    const int partner = writerOnceRead("pipe");
    ASSERT_GE(partner, 0) << "the script was never opened";
    program.send(SIGINT);
    EXPECT_EQ(program.wait().exitCode, 130);
    ::close(partner);
}

TEST_F(StoppingAtAPipe, AlsoWhereNobodyReadsStandardOutput) {
    const std::string command = "'" + test::programPath("Renderer").string() +
                                "' room.obj -o - -w 300 -h 300 --format=ppm & renderer=$!; sleep 0.7; "
                                "kill -TERM $renderer; wait $renderer; echo $? > code";
    test::runProgram("/bin/sh", {"-c", "{ " + command + "; } | sleep 3"}, {.folder = folder.path()});
    EXPECT_EQ(test::readBytes(folder / "code"), "143\n");
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
