/// Films: what ffmpeg gets, and what is left when it fails. A script takes its place, except in the last
/// tests.
#include "process/sample_scene.h"

#include "renderer/film.h"
#include "rtcore/io/images/image_file.h"
#include "rtcore/platform/processes.h"

#include <gtest/gtest.h>

#include <cstdlib>

namespace {

using Names = std::vector<std::string>;

// Writes down its arguments, and what it reads in place of the film.
constexpr const char* kHonest = "#!/bin/sh\nfor film; do :; done\nprintf '%s\\n' \"$@\" > words\n"
                                "cat > \"${film#file:}\"\n";

class Films : public testing::Test {
  protected:
    void SetUp() override {
        for (const char* name : {"out", "bin", "films"}) std::filesystem::create_directory(folder / name);
        test::writeRoom(folder / "room.obj");
        for (int i = 1; i <= 3; ++i) test::writeCamera(folder / (std::to_string(i) + ".cam"), i * 0.5 - 1);
        test::writeText(folder / "film.lst", "1.cam\n2.cam\n3.cam\n");
    }
    void setFfmpeg(const std::string& script) {
        test::writeText(folder / "bin" / "ffmpeg", script);
        std::filesystem::permissions(folder / "bin" / "ffmpeg", std::filesystem::perms::owner_all);
    }
    std::string fakePath() const { return (folder / "bin").string() + ":/usr/bin:/bin"; }
    Names words(const Names& extra) const {
        // Images of a list share indirect light, which another list may change.
        Names all{"room.obj", "-l", "film.lst", "-w", "15", "-h", "11", "--setting=indirect.mode=off"};
        all.insert(all.end(), extra.begin(), extra.end());
        return all;
    }
    test::ProgramResult render(const Names& extra, const std::string& path = "") {
        return test::renderer(words(extra), {.folder = folder.path(),
                                             .environment = {{"PATH", path.empty() ? fakePath() : path}}});
    }
    // The frames' bytes as a film of that size gets them.
    std::string frames(int width, int height) {
        EXPECT_EQ(render({"-o", "out/expected#.ppm"}).exitCode, 0);
        std::string all;
        for (int i = 1; i <= 3; ++i) {
            const auto path = folder / "out" / ("expected" + std::to_string(i) + ".ppm");
            std::vector<std::byte> bytes;
            renderer::packFrame(rtcore::readLdrImage(path), width, height, bytes);
            all.append(reinterpret_cast<const char*>(bytes.data()), bytes.size());
        }
        return all;
    }
    Names films() const { return test::filesIn(folder / "films"); }
    bool wordsHold(const std::string& sequence) {
        return test::readBytes(folder / "words").find(sequence) != std::string::npos;
    }

    struct Folder : test::TemporaryFolder {
        std::filesystem::path operator/(const std::string& name) const { return path() / name; }
    } folder;
};

TEST_F(Films, GetEveryFrameInOrderAndPadded) {
    setFfmpeg(kHonest);
    const test::ProgramResult result = render({"--video", "films/a.mp4", "--fps", "12.5"});
    EXPECT_EQ(result.exitCode, 0) << result.error;
    EXPECT_EQ(films(), Names{"a.mp4"});
    EXPECT_TRUE(test::readBytes(folder / "films" / "a.mp4") == frames(16, 12));
    EXPECT_TRUE(wordsHold("-video_size\n16x12\n-framerate\n12.5\n"));
    EXPECT_TRUE(wordsHold("-c:v\nlibx264\n"));
    EXPECT_FALSE(std::filesystem::exists(folder / "room_0001.png"));
}

TEST_F(Films, OfFullColourKeepTheirSize) {
    setFfmpeg(kHonest);
    EXPECT_EQ(render({"--video", "films/a.gif"}).exitCode, 0);
    EXPECT_TRUE(wordsHold("-video_size\n15x11\n-framerate\n25\n"));
    EXPECT_TRUE(test::readBytes(folder / "films" / "a.gif") == frames(15, 11));
}

TEST_F(Films, RunAsFastAsTheyWereRecorded) {
    setFfmpeg(kHonest);
    test::writeCamera(folder / "1.cam", 0, "time = 1.0\n");
    test::writeCamera(folder / "3.cam", 0, "time = 1.05\n");
    EXPECT_EQ(render({"--video", "films/a.mkv"}).exitCode, 0);
    EXPECT_TRUE(wordsHold("-framerate\n40\n"));
}

TEST_F(Films, TakeFinishedFramesFromTheirFiles) {
    setFfmpeg(kHonest);
    const std::string expected = frames(16, 12);
    ASSERT_EQ(render({"-o", "out/f#.png", "--frames", "1-2"}).exitCode, 0);
    const std::string second = test::readBytes(folder / "out" / "f2.png");
    test::writeText(folder / "out" / "f2.png", second.substr(0, second.size() - 20));
    std::filesystem::remove(folder / "1.cam"); // the frame is there
    const test::ProgramResult result = render({"-o", "out/f#.png", "--video", "films/a.mp4"});
    EXPECT_EQ(result.exitCode, 0) << result.error;
    EXPECT_NE(result.error.find("1 of 3 frames are there already"), std::string::npos) << result.error;
    EXPECT_NE(result.error.find("f2.png is rendered again: damaged PNG"), std::string::npos) << result.error;
    EXPECT_TRUE(test::readBytes(folder / "films" / "a.mp4") == expected);
    EXPECT_TRUE(test::readBytes(folder / "out" / "f2.png") == second);
}

TEST_F(Films, AreNotMadeWithAGap) {
    setFfmpeg(kHonest);
    std::filesystem::remove(folder / "2.cam");
    const test::ProgramResult kept = render({"-o", "out/f#.png", "--video", "films/a.mp4"});
    EXPECT_EQ(kept.exitCode, 66) << kept.error;
    EXPECT_NE(kept.error.find("a.mp4: not written, since frames are missing"), std::string::npos)
        << kept.error;
    EXPECT_EQ(test::filesIn(folder / "out"), (Names{"f1.png", "f3.png"}));
    EXPECT_EQ(render({"--video", "films/a.mp4"}).exitCode, 66);
    EXPECT_EQ(films(), Names{});
}

TEST_F(Films, HaveFramesOfOneSize) {
    setFfmpeg(kHonest);
    test::writeCamera(folder / "2.cam", 0, "width = 20\nheight = 10\n");
    const test::ProgramResult result = test::renderer(
        {"room.obj", "-l", "film.lst", "--setting", "antialiasing=1", "--video", "films/a.mp4"},
        {.folder = folder.path(), .environment = {{"PATH", fakePath()}}});
    EXPECT_EQ(result.exitCode, 65);
    EXPECT_NE(result.error.find("frame 2 has 20 x 10 pixels"), std::string::npos) << result.error;
    EXPECT_EQ(films(), Names{});
}

TEST_F(Films, FailWithTheWordsOfFfmpeg) {
    test::writeText(folder / "films" / "a.mp4", "old");
    for (const char* body : {"cat > /dev/null; ", "head -c 700 > /dev/null; ", ""}) {
        setFfmpeg(std::string("#!/bin/sh\n") + body + "echo 'Unknown encoder' >&2; exit 3\n");
        const test::ProgramResult result = render({"-o", "out/f#.png", "--video", "films/a.mp4"});
        EXPECT_EQ(result.exitCode, 73) << result.error;
        EXPECT_NE(result.error.find("ffmpeg failed with exit code 3: \"Unknown encoder\""), std::string::npos)
            << result.error;
        EXPECT_EQ(films(), Names{"a.mp4"});
        EXPECT_EQ(test::readBytes(folder / "films" / "a.mp4"), "old");
    }
}

TEST_F(Films, FailWhenFfmpegDies) {
    setFfmpeg("#!/bin/sh\ncat > /dev/null\nkill -9 $$\n");
    const test::ProgramResult killed = render({"--video", "films/a.mp4"});
    EXPECT_EQ(killed.exitCode, 73);
    EXPECT_NE(killed.error.find("ffmpeg was ended by a signal (Killed)"), std::string::npos) << killed.error;
    setFfmpeg("#!/bin/sh\ncat > /dev/null\n");
    const test::ProgramResult idle = render({"--video", "films/a.mp4"});
    EXPECT_EQ(idle.exitCode, 73);
    EXPECT_NE(idle.error.find("ended without making the film"), std::string::npos) << idle.error;
    EXPECT_EQ(films(), Names{});
}

TEST_F(Films, CanBeStoppedWhileFfmpegHangs) {
    setFfmpeg("#!/bin/sh\ntouch started\nexec sleep 1000\n");
    for (const bool requeue : {false, true}) {
        Names extra{"--video", "films/a.mp4", "--progress=json"};
        if (requeue) extra.push_back("--requeue");
        test::RunningProgram program(test::programPath("Renderer"), words(extra),
                                     {.folder = folder.path(), .environment = {{"PATH", fakePath()}}});
        EXPECT_TRUE(program.waitForError("finishing the film"));
        program.send(SIGTERM);
        const test::ProgramResult result = program.wait();
        EXPECT_EQ(result.exitCode, requeue ? 75 : 143) << result.error;
        EXPECT_EQ(films(), Names{});
    }
}

TEST_F(Films, WithoutFfmpegSayHowTheyAreMade) {
    const std::string nowhere = (folder / "bin").string();
    const test::ProgramResult early = render({"--video", "films/a.mp4"}, nowhere);
    EXPECT_EQ(early.exitCode, 66);
    EXPECT_NE(early.error.find("ffmpeg -framerate 25 -i frame_%04d.png"), std::string::npos) << early.error;
    const test::ProgramResult late = render({"-o", "out/f#.png", "--video", "films/a.mp4"}, nowhere);
    EXPECT_EQ(late.exitCode, 66);
    EXPECT_EQ(test::filesIn(folder / "out").size(), 3U);
    EXPECT_EQ(films(), Names{});
}

TEST_F(Films, BadOptionsAreRefused) {
    for (const Names& extra : std::vector<Names>{{"--video", "films/a.avi"},
                                                 {"--video", "films/a"},
                                                 {"--video", "films/a.mp4", "--fps", "0"},
                                                 {"--fps", "5"},
                                                 {"--video", "films/a.mp4", "--verify"},
                                                 {"--chunk", "0/3"},
                                                 {"--chunk", "4/3"},
                                                 {"--chunk", "1"},
                                                 {"--chunk", "1/2", "--follow"},
                                                 {"--follow-timeout", "3"},
                                                 {"--verify", "--force"}}) {
        EXPECT_EQ(render(extra).exitCode, 2) << extra[0] << ' ' << extra[1];
    }
    EXPECT_EQ(render({"--video", "missing/a.mp4"}).exitCode, 73);
}

// By the ffmpeg of this machine.
class RealFilms : public Films {
  protected:
    void SetUp() override {
        Films::SetUp();
        if (!rtcore::findProgram("ffmpeg")) GTEST_SKIP() << "ffmpeg is not installed";
    }
    std::string path() const { return std::getenv("PATH"); }
};

TEST_F(RealFilms, OfEveryKindAreMade) {
    for (const char* film : {"films/a.mp4", "films/a.webm", "films/a.mkv", "films/a.gif"}) {
        const test::ProgramResult result = render({"--video", film}, path());
        EXPECT_EQ(result.exitCode, 0) << film << ": " << result.error;
    }
}

TEST_F(RealFilms, CanBeMadeOfTheFramesAsTheAdviceSays) {
    ASSERT_EQ(render({"-o", "frame_####.png"}, path()).exitCode, 0);
    for (const char* film : {"films/a b.mp4", "films/a.gif"}) {
        const test::ProgramResult result =
            test::runProgram("/bin/sh", {"-c", renderer::encodeCommand(film, 25)}, {.folder = folder.path()});
        EXPECT_EQ(result.exitCode, 0) << result.error;
        EXPECT_TRUE(std::filesystem::exists(folder / film));
    }
}

TEST_F(RealFilms, OfTheLosslessKindHoldTheFramesBitForBit) {
    ASSERT_EQ(render({"--video", "films/a.mkv"}, path()).exitCode, 0);
    const rtcore::ProcessResult decoded = rtcore::runProcess(
        *rtcore::findProgram("ffmpeg"), {"-loglevel", "error", "-i", (folder / "films/a.mkv").string(), "-f",
                                         "rawvideo", "-pix_fmt", "rgb24", "pipe:1"});
    EXPECT_TRUE(decoded.output == frames(15, 11)) << decoded.errors;
}

} // namespace
