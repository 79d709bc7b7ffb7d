/// Long lists: parts of them, what is missing of them, lists that grow, and a Renderer that is killed.
/// RT_LIST_FRAMES sets how long the long one is (200).
#include "process/sample_scene.h"

#include "rtcore/io/images/image_file.h"
#include "rtcore/io/recording/path_recorder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <memory>
#include <random>
#include <thread>

namespace {

using Names = std::vector<std::string>;

class LongLists : public testing::Test {
  protected:
    void SetUp() override {
        std::filesystem::create_directory(folder / "out");
        test::writeRoom(folder / "room.obj");
        test::writeCamera(folder / "a.cam", 0);
        setList(5);
    }
    void setList(int frames) {
        std::string text;
        for (int i = 0; i < frames; ++i) text += "a.cam\n";
        test::writeText(folder / "film.lst", text);
    }
    Names words(const Names& extra) const {
        Names all{"room.obj", "-l", "film.lst", "-w", "8", "-h", "6"};
        all.insert(all.end(), extra.begin(), extra.end());
        return all;
    }
    test::ProgramResult render(const Names& extra) {
        return test::renderer(words(extra), {.folder = folder.path()});
    }
    Names outputs() const { return test::filesIn(folder / "out"); }
    void truncate(const std::string& name, std::uintmax_t lost) {
        const auto path = folder.path() / "out" / name;
        std::filesystem::resize_file(path, std::filesystem::file_size(path) - lost);
    }

    test::TemporaryFolder folder;
};

TEST_F(LongLists, ChunksHoldEachFrameOnce) {
    EXPECT_EQ(render({"-o", "out/f#.png", "--chunk", "1/3"}).exitCode, 0);
    EXPECT_EQ(outputs(), Names{"f1.png"});
    EXPECT_EQ(render({"-o", "out/f#.png", "--chunk", "3/3"}).exitCode, 0);
    EXPECT_EQ(outputs(), (Names{"f1.png", "f4.png", "f5.png"}));
    const test::ProgramResult last = render({"-o", "out/f#.png", "--chunk", "2/3"});
    EXPECT_EQ(last.error.find("already"), std::string::npos) << last.error;
    EXPECT_EQ(outputs().size(), 5U);
    EXPECT_EQ(render({"-o", "out/g#.png", "--chunk", "1/9"}).exitCode, 0);
    EXPECT_EQ(outputs().size(), 5U);
}

TEST_F(LongLists, VerifyFindsWhatIsMissingOrBroken) {
    const Names patterns{"-o", "out/f#.png", "-o", "out/f#.jpg", "-o", "out/f#.hdr", "-o", "out/f#.bmp"};
    const auto verify = [&](Names extra = {}) {
        extra.insert(extra.begin(), patterns.begin(), patterns.end());
        extra.push_back("--verify");
        return render(extra);
    };
    ASSERT_EQ(render(patterns).exitCode, 0);
    const test::ProgramResult whole = verify();
    EXPECT_EQ(whole.exitCode, 0);
    EXPECT_EQ(whole.output, "");
    EXPECT_NE(whole.error.find("all 5 frames are there"), std::string::npos) << whole.error;

    truncate("f1.png", 1);
    truncate("f2.jpg", 2);
    truncate("f3.hdr", 1);
    truncate("f4.bmp", 1);
    std::filesystem::remove(folder.path() / "out" / "f5.png");
    const test::ProgramResult result = verify();
    EXPECT_EQ(result.exitCode, 1);
    for (const char* line :
         {"1\tout/f1.png\tbroken: damaged PNG", "2\tout/f2.jpg\tbroken: ", "3\tout/f3.hdr\tbroken: ",
          "4\tout/f4.bmp\tbroken: ", "5\tout/f5.png\tmissing\n"}) {
        EXPECT_NE(result.output.find(line), std::string::npos) << line << " in\n" << result.output;
    }
    EXPECT_NE(result.error.find("5 of 5 frames are missing or broken"), std::string::npos) << result.error;
    EXPECT_EQ(outputs().size(), 19U);
    EXPECT_EQ(verify({"--frames", "5-"}).exitCode, 1);
    // Whoever renders the list again gets all of it.
    EXPECT_EQ(render(patterns).exitCode, 0);
    EXPECT_EQ(verify().exitCode, 0);
}

TEST_F(LongLists, VerifyFindsTruncatedExr) {
    if (!rtcore::isWritableFormat("a.exr")) GTEST_SKIP() << "this build has no OpenEXR";
    ASSERT_EQ(render({"-o", "out/f#.exr"}).exitCode, 0);
    truncate("f2.exr", 1);
    const test::ProgramResult result = render({"-o", "out/f#.exr", "--verify"});
    EXPECT_EQ(result.exitCode, 1);
    EXPECT_EQ(result.output.rfind("2\tout/f2.exr\tbroken: ", 0), 0U) << result.output;
}

TEST_F(LongLists, VerifyTakesTheOutputOfTheScene) {
    test::writeText(folder / "s.scn", "version = 1\nmodel = \"missing.obj\"\noutput = \"out/s.png\"\n");
    const test::ProgramResult result =
        test::renderer({"s.scn", "-l", "film.lst", "--verify"}, {.folder = folder.path()});
    EXPECT_EQ(result.exitCode, 1) << result.error;
    EXPECT_NE(result.output.find("out/s_0005.png\tmissing"), std::string::npos) << result.output;
}

TEST_F(LongLists, RecordingsAreRenderedWhileTheyAreMade) {
    rtcore::CameraFile frame;
    frame.camera.eye = {0, 2, 6};
    frame.camera.forward = {0, -0.2F, -1};
    auto recorder = std::make_unique<rtcore::PathRecorder>(folder / "walk.lst");
    recorder->add(frame);
    test::RunningProgram program(test::programPath("Renderer"),
                                 {"room.obj", "-l", "walk.lst", "-w", "8", "-h", "6", "-o", "out/f#.png",
                                  "--follow", "--progress=plain"},
                                 {.folder = folder.path()});
    ASSERT_TRUE(program.waitForError("wrote out/f1.png"));
    recorder->add(frame);
    ASSERT_TRUE(program.waitForError("wrote out/f2.png"));
    recorder->add(frame);
    recorder.reset();
    const test::ProgramResult result = program.wait();
    EXPECT_EQ(result.exitCode, 0) << result.error;
    EXPECT_EQ(outputs(), (Names{"f1.png", "f2.png", "f3.png"}));
}

TEST_F(LongLists, FollowingEndsWhenNothingComes) {
    test::writeText(folder / "film.lst", "a.cam\na.cam\na.ca");
    const test::ProgramResult result = render({"-o", "out/f#.png", "--follow", "--follow-timeout", "0.3"});
    EXPECT_EQ(result.exitCode, 0) << result.error;
    EXPECT_NE(result.error.find("the list has no end mark"), std::string::npos) << result.error;
    EXPECT_EQ(outputs(), (Names{"f1.png", "f2.png"}));
    EXPECT_EQ(render({"-o", "out/g#.png", "--follow", "--frames", "1"}).exitCode, 0);
    EXPECT_EQ(outputs().size(), 3U);
}

TEST_F(LongLists, FollowingCanBeStopped) {
    test::RunningProgram program(test::programPath("Renderer"),
                                 {"room.obj", "-l", "none.lst", "--follow", "--progress=json"},
                                 {.folder = folder.path()});
    ASSERT_TRUE(program.waitForError("waiting for frames"));
    program.send(SIGINT);
    EXPECT_EQ(program.wait().exitCode, 130);
}

TEST_F(LongLists, AKilledRendererGoesOnToACompleteFilm) {
    const char* asked = std::getenv("RT_LIST_FRAMES");
    const int frames = asked == nullptr ? 200 : std::max(20, std::atoi(asked));
    std::string text;
    for (int i = 1; i <= frames; ++i) text += i == frames / 2 ? "late.cam\n" : "a.cam\n";
    test::writeText(folder / "film.lst", text);
    std::mt19937 random(20100601);
    for (int kill = 0; kill < 4; ++kill) {
        test::RunningProgram program(test::programPath("Renderer"),
                                     words({"-o", "out/f####.png", "--progress=json"}),
                                     {.folder = folder.path()});
        if (!program.waitForError(
                "\"rendering\"")) { // on a quick machine there is nothing left to kill it at
            ASSERT_GT(kill, 0);
            EXPECT_EQ(program.wait().exitCode, 66);
            break;
        }
        std::this_thread::sleep_for(
            std::chrono::duration<double>(std::uniform_real_distribution<double>(0, 0.05)(random)));
        program.send(SIGKILL);
        program.wait();
        for (const std::string& name : outputs()) {
            // The temporary file of a killed program may stay; it has another name.
            if (name.starts_with('.')) continue;
            EXPECT_NO_THROW(rtcore::readLdrImage(folder.path() / "out" / name)) << name;
        }
    }
    EXPECT_EQ(render({"-o", "out/f####.png"}).exitCode, 66);
    const test::ProgramResult lacking = render({"-o", "out/f####.png", "--verify"});
    EXPECT_EQ(lacking.exitCode, 1);
    EXPECT_EQ(std::count(lacking.output.begin(), lacking.output.end(), '\n'), 1) << lacking.output;
    test::writeCamera(folder / "late.cam", 0);
    EXPECT_EQ(render({"-o", "out/f####.png"}).exitCode, 0);
    EXPECT_EQ(render({"-o", "out/f####.png", "--verify"}).exitCode, 0);
}

} // namespace
