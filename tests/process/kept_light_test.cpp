/// Indirect light that images share: of a list, and in files.
#include "process/sample_scene.h"

#include "rtcore/io/images/image_file.h"

#include <gtest/gtest.h>

#include <csignal>
#include <filesystem>
#include <string>
#include <vector>

namespace {

using Names = std::vector<std::string>;

class KeptLight : public testing::Test {
  protected:
    void SetUp() override {
        test::writeRoom(folder / "room.obj");
        std::string list;
        for (int i = 1; i <= 4; ++i) {
            const std::string name = std::to_string(i) + ".cam";
            test::writeCamera(folder / name, i * 0.1 - 1);
            list += name + "\n";
        }
        test::writeText(folder / "film.lst", list);
    }
    test::ProgramResult render(Names extra) const {
        extra.insert(extra.begin(), {"room.obj", "-w", "48", "-h", "36", "--setting=indirect.mode=live"});
        return test::renderer(extra, {.folder = folder.path()});
    }
    test::ProgramResult make(Names extra) const {
        extra.push_back("--make-light=room.light");
        return render(extra);
    }
    std::string bytes(const std::string& file) const { return test::readBytes(folder / file); }

    test::TemporaryFolder folder;
};

TEST_F(KeptLight, IsThatOfTheWholeListWhicheverFramesAreRendered) {
    ASSERT_EQ(render({"-l", "film.lst", "-o", "all#.png"}).exitCode, 0);
    ASSERT_EQ(render({"-l", "film.lst", "-o", "part#.png", "--chunk=2/2", "--threads=1"}).exitCode, 0);
    ASSERT_EQ(render({"-l", "film.lst", "-o", "one#.png", "--frames=3"}).exitCode, 0);
    EXPECT_EQ(bytes("part3.png"), bytes("all3.png"));
    EXPECT_EQ(bytes("part4.png"), bytes("all4.png"));
    EXPECT_EQ(bytes("one3.png"), bytes("all3.png"));
}

/// Each frame has paths of its own, but their light is that of the list.
TEST_F(KeptLight, IsThatOfTheListWhicheverSeedsItsFramesHave) {
    const std::string seeds = "--setting=path.seedPerFrame=true";
    ASSERT_EQ(render({"-l", "film.lst", "-o", "all#.png", seeds}).exitCode, 0);
    ASSERT_EQ(render({"-l", "film.lst", "-o", "part#.png", "--chunk=2/2", seeds}).exitCode, 0);
    EXPECT_EQ(bytes("part3.png"), bytes("all3.png"));
    EXPECT_EQ(bytes("part4.png"), bytes("all4.png"));
}

/// The same light, to the bit: the file is learned of the same views.
TEST_F(KeptLight, OfAFileIsThatOfTheListThatItWasMadeOf) {
    const test::ProgramResult made = make({"-l", "film.lst"});
    ASSERT_EQ(made.exitCode, 0) << made.error;
    ASSERT_EQ(render({"-l", "film.lst", "-o", "own#.png"}).exitCode, 0);
    const test::ProgramResult film = render({"-l", "film.lst", "-o", "kept#.png", "--light=room.light"});
    ASSERT_EQ(film.exitCode, 0) << film.error;
    for (const char* const number : {"1", "2", "3", "4"})
        EXPECT_EQ(bytes(std::string("kept") + number + ".png"), bytes(std::string("own") + number + ".png"));
    ASSERT_EQ(render({"--camera=2.cam", "-o", "still.png", "--light=room.light"}).exitCode, 0);
    EXPECT_EQ(bytes("still.png"), bytes("kept2.png"));
}

TEST_F(KeptLight, OfAListIsWrittenWhereTheFileIsMissing) {
    const test::ProgramResult first =
        render({"-l", "film.lst", "-o", "a#.png", "--chunk=1/2", "--light=film.light"});
    ASSERT_EQ(first.exitCode, 0) << first.error;
    EXPECT_NE(first.error.find("wrote film.light"), std::string::npos) << first.error;
    const test::ProgramResult second =
        render({"-l", "film.lst", "-o", "a#.png", "--chunk=2/2", "--light=film.light"});
    ASSERT_EQ(second.exitCode, 0) << second.error;
    EXPECT_EQ(second.error.find("wrote film.light"), std::string::npos) << second.error;
    ASSERT_EQ(render({"-l", "film.lst", "-o", "b#.png"}).exitCode, 0);
    for (const char* const number : {"1", "4"})
        EXPECT_EQ(bytes(std::string("a") + number + ".png"), bytes(std::string("b") + number + ".png"));
}

TEST_F(KeptLight, IsToldOfWhereSettingsDoNotUseIt) {
    ASSERT_EQ(make({"--camera=1.cam"}).exitCode, 0);
    const test::ProgramResult unused =
        render({"--camera=1.cam", "-o", "a.png", "--light=room.light", "--setting=indirect.mode=off"});
    EXPECT_EQ(unused.exitCode, 0);
    EXPECT_NE(unused.error.find("warning: room.light: it is not used"), std::string::npos) << unused.error;
    const test::ProgramResult byPaths =
        render({"--camera=1.cam", "-o", "d.png", "--light=room.light", "--setting=integrator=path",
                "--setting=path.samples=1", "--setting=denoise.net=off"});
    EXPECT_NE(byPaths.error.find("warning: room.light: it is not used"), std::string::npos) << byPaths.error;
    const test::ProgramResult used = render({"--camera=1.cam", "-o", "b.png", "--light=room.light"});
    EXPECT_EQ(used.error.find("warning"), std::string::npos) << used.error;
    const test::ProgramResult missing =
        render({"--camera=1.cam", "-o", "c.png", "--light=none.light", "--setting=indirect.mode=off"});
    EXPECT_EQ(missing.exitCode, 66) << missing.error;
}

TEST_F(KeptLight, IsMadeOfAllThatIsWalkedOn) {
    const test::ProgramResult made = make({"-v"});
    ASSERT_EQ(made.exitCode, 0) << made.error;
    EXPECT_NE(made.error.find("wrote room.light: "), std::string::npos) << made.error;
    ASSERT_EQ(render({"--camera=2.cam", "-o", "kept.png", "--light=room.light"}).exitCode, 0);
    ASSERT_EQ(render({"--camera=2.cam", "-o", "alone.png"}).exitCode, 0);
    const rtcore::LdrImage kept = rtcore::readLdrImage(folder / "kept.png"),
                           alone = rtcore::readLdrImage(folder / "alone.png");
    double sum = 0;
    for (std::size_t i = 0; i < kept.pixels.size(); ++i)
        sum += std::abs(kept.pixels[i].g - alone.pixels[i].g);
    EXPECT_LT(sum / static_cast<double>(kept.pixels.size()), 3) << "codes of 255";
}

/// The first view alone makes a file of more than a tenth of a megabyte.
TEST_F(KeptLight, GoesOnWhereABoundEndedIt) {
    const test::ProgramResult some = make({"--light-size=0.1"});
    ASSERT_EQ(some.exitCode, 0) << some.error;
    EXPECT_NE(some.error.find("wrote room.light: 1 of "), std::string::npos) << some.error;
    const test::ProgramResult all = make({});
    ASSERT_EQ(all.exitCode, 0) << all.error;
    EXPECT_NE(all.error.find("going on with room.light"), std::string::npos) << all.error;
    EXPECT_EQ(all.error.find("wrote room.light: 1 of "), std::string::npos) << all.error;
    EXPECT_EQ(make({"--light-time=0.1"}).exitCode, 0);
}

TEST_F(KeptLight, OfAnotherSceneIsRefused) {
    ASSERT_EQ(make({"-l", "film.lst"}).exitCode, 0);
    const test::ProgramResult dark = render({"--look=studio", "--light=room.light", "-o", "x.png"});
    EXPECT_EQ(dark.exitCode, 65);
    EXPECT_NE(dark.error.find("room.light: is of the same surfaces by another light; make it anew by "
                              "--make-light"),
              std::string::npos)
        << dark.error;
    test::writeWaves(folder / "waves.obj", 5);
    const test::ProgramResult waves =
        test::renderer({"waves.obj", "--light=room.light", "-o", "x.png"}, {.folder = folder.path()});
    EXPECT_EQ(waves.exitCode, 65);
    EXPECT_NE(waves.error.find("is of other surfaces"), std::string::npos) << waves.error;
    EXPECT_FALSE(std::filesystem::exists(folder / "x.png"));
    EXPECT_EQ(render({"--light=none.light", "-o", "x.png"}).exitCode, 66);
    // What is made anew is told of.
    const test::ProgramResult again =
        render({"--look=studio", "--make-light=room.light", "--light-time=0.1"});
    EXPECT_EQ(again.exitCode, 0);
    EXPECT_NE(again.error.find("room.light is of another scene or light; it is made anew"), std::string::npos)
        << again.error;
}

TEST_F(KeptLight, IsNotWrittenOverAnythingElse) {
    test::writeText(folder / "mine.light", "a poem");
    const test::ProgramResult made = render({"--make-light=mine.light"});
    EXPECT_EQ(made.exitCode, 65) << made.error;
    EXPECT_EQ(bytes("mine.light"), "a poem");
    EXPECT_EQ(render({"--make-light=room.obj"}).exitCode, 2);
    EXPECT_EQ(render({"--make-light=no/where.light"}).exitCode, 73);
    EXPECT_EQ(make({"-o", "x.png"}).exitCode, 2);
    EXPECT_EQ(render({"--light-time=3", "-o", "x.png"}).exitCode, 2);
}

TEST_F(KeptLight, StoppedItKeepsWhatItHasLearned) {
    test::RunningProgram program(test::programPath("Renderer"),
                                 {"room.obj", "--setting=indirect.mode=live", "--make-light=room.light", "-w",
                                  "1600", "-h", "1200", "--progress=json"},
                                 {.folder = folder.path()});
    ASSERT_TRUE(program.waitForError("learning indirect light"));
    program.send(SIGINT);
    const test::ProgramResult result = program.wait();
    EXPECT_EQ(result.exitCode, 130) << result.error;
    EXPECT_NE(result.error.find("what was learned is kept"), std::string::npos) << result.error;
    EXPECT_TRUE(std::filesystem::exists(folder / "room.light"));
    EXPECT_EQ(test::filesIn(folder.path()).size(), 7U) << "four cameras, the list, the model, the light";
    EXPECT_EQ(make({"--light-time=0.1"}).exitCode, 0) << "it is sound";
}

} // namespace
