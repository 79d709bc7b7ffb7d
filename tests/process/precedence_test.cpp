/// Which of several places a setting comes from, seen by the size of the image.
#include "process/sample_scene.h"

#include <gtest/gtest.h>

namespace {

class Precedence : public testing::Test {
  protected:
    void SetUp() override {
        test::writeRoom(folder / "room.obj");
        test::writeText(folder / "named.set",
                        "version = 1\n[still]\nheight = 21\nantialiasing = 1\n[live]\nheight = 99\n");
        test::writeText(folder / "given.set", "version = 1\n[still]\nwidth = 12\nheight = 22\n");
        test::writeText(folder / "plain.scn",
                        "version = 1\nmodel = \"room.obj\"\n[still]\nwidth = 10\nheight = 20\n");
        test::writeText(
            folder / "named.scn",
            "version = 1\nmodel = \"room.obj\"\nsettings = \"named.set\"\noutput = \"by_scene.png\"\n"
            "[still]\nwidth = 10\nheight = 20\n");
        test::writeCamera(folder / "both.cam", 0, "width = 13\nheight = 23\n");
        test::writeCamera(folder / "none.cam", 0);
    }
    test::PictureSize render(std::vector<std::string> arguments) {
        arguments.insert(arguments.end(), {"-o", "a.png"});
        const test::ProgramResult result = test::renderer(arguments, {.folder = folder.path()});
        EXPECT_EQ(result.exitCode, 0) << result.error;
        return test::pngFileSize(folder / "a.png");
    }

    test::TemporaryFolder folder;
};

using Size = test::PictureSize;

TEST_F(Precedence, Default) { EXPECT_EQ(render({"room.obj"}), (Size{640, 480})); }
TEST_F(Precedence, SceneBeatsDefault) { EXPECT_EQ(render({"plain.scn"}), (Size{10, 20})); }
TEST_F(Precedence, NamedSetBeatsScene) { EXPECT_EQ(render({"named.scn"}), (Size{10, 21})); }
TEST_F(Precedence, GivenSetBeatsNamedSet) {
    EXPECT_EQ(render({"named.scn", "--set", "given.set"}), (Size{12, 22}));
}
TEST_F(Precedence, CameraBeatsSets) {
    EXPECT_EQ(render({"named.scn", "--set", "given.set", "--camera", "both.cam"}), (Size{13, 23}));
    EXPECT_EQ(render({"named.scn", "--set", "given.set", "--camera", "none.cam"}), (Size{12, 22}));
}
TEST_F(Precedence, CommandLineBeatsAll) {
    EXPECT_EQ(render({"named.scn", "--set", "given.set", "--camera", "both.cam", "-w", "14"}), (Size{14, 25}))
        << "in the aspect of the camera";
    EXPECT_EQ(render({"named.scn", "--camera", "both.cam", "--setting", "height=24", "-w", "9"}),
              (Size{9, 24}));
}
TEST_F(Precedence, ThesisSpellingsAndLongOnesAreOne) {
    EXPECT_EQ(render({"room.obj", "-w", "15", "-h", "25", "-a", "1"}), (Size{15, 25}));
    EXPECT_EQ(render({"room.obj", "--width=15", "--height", "25", "--antialiasing=1"}), (Size{15, 25}));
}

TEST_F(Precedence, TheModelOfTheCommandLineBeatsTheScenes) {
    test::writeText(folder / "lost.scn",
                    "version = 1\nmodel = \"nowhere.obj\"\n[still]\nwidth = 10\nheight = 20\n");
    ASSERT_EQ(test::bspBuilder({"room.obj", "room.bsp"}, {.folder = folder.path()}).exitCode, 0);
    EXPECT_EQ(test::renderer({"lost.scn", "-o", "a.png"}, {.folder = folder.path()}).exitCode, 66);
    EXPECT_EQ(render({"lost.scn", "--model", "room.bsp"}), (Size{10, 20}));
}

TEST_F(Precedence, TheCreaseAngleOfTheCommandLineBeatsTheScenes) {
    test::writeText(folder / "wedge.obj", "v -1 0 0\nv 1 0 0\nv -1 0 -1\nv 1 0 -1\nv -1 1 -2\nv 1 1 -2\n"
                                          "f 1 2 4 3\nf 3 4 6 5\n");
    for (const char* const angle : {"10", "120"}) {
        test::writeText(folder / (std::string("wedge") + angle + ".scn"),
                        "version = 1\nmodel = \"wedge.obj\"\ncreaseAngle = " + std::string(angle) + "\n");
    }
    const auto picture = [&](std::vector<std::string> arguments) {
        arguments.insert(arguments.end(), {"-o", "a.ppm", "-w", "40", "-h", "30", "--force"});
        EXPECT_EQ(test::renderer(arguments, {.folder = folder.path()}).exitCode, 0);
        return test::readBytes(folder / "a.ppm");
    };
    const std::string sharp = picture({"wedge10.scn"});
    const std::string smooth = picture({"wedge120.scn"});
    EXPECT_NE(sharp, smooth);
    EXPECT_EQ(picture({"wedge10.scn", "--crease-angle", "120"}), smooth);
}

TEST_F(Precedence, TheOutputOfTheSceneLiesBesideIt) {
    std::filesystem::create_directory(folder / "elsewhere");
    const test::ProgramResult result = test::renderer({"../named.scn"}, {.folder = folder / "elsewhere"});
    EXPECT_EQ(result.exitCode, 0) << result.error;
    EXPECT_EQ(test::pngFileSize(folder / "by_scene.png"), (Size{10, 21}));
}

TEST_F(Precedence, WithoutAnOutputThePictureIsNamedAfterTheScene) {
    std::filesystem::create_directory(folder / "elsewhere");
    const test::ProgramResult result = test::renderer({"../plain.scn"}, {.folder = folder / "elsewhere"});
    EXPECT_EQ(result.exitCode, 0) << result.error;
    EXPECT_EQ(test::pngFileSize(folder / "elsewhere" / "plain.png"), (Size{10, 20}));
}

TEST_F(Precedence, TheCameraFileOfASceneBringsItsFields) {
    test::writeText(
        folder / "camera.scn",
        "version = 1\nmodel = \"room.obj\"\n[camera]\nfile = \"both.cam\"\n[still]\nwidth = 10\n");
    EXPECT_EQ(render({"camera.scn"}), (Size{13, 23}));
    EXPECT_EQ(render({"camera.scn", "--camera", "none.cam"}), (Size{10, 480}));
}

} // namespace
