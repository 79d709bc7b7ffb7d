/// The up axis and the length of a unit: --up and --units, .scn, .bsp, and guesses for a bare model.
#include "process/sample_scene.h"

#include <gtest/gtest.h>

namespace {

using Names = std::vector<std::string>;

class UpAndUnits : public testing::Test {
  protected:
    UpAndUnits() { test::writeRoom(folder / "room.obj"); }

    std::string file(const std::string& name) const { return (folder / name).string(); }
    /// The bytes of the picture.
    std::string picture(const std::string& scene, const Names& options = {}) {
        Names arguments{file(scene), "-o", file("a.ppm"), "-w", "48", "-h", "32"};
        arguments.insert(arguments.end(), options.begin(), options.end());
        const test::ProgramResult result = test::renderer(arguments);
        EXPECT_EQ(result.exitCode, 0) << result.error;
        return test::readBytes(folder / "a.ppm");
    }
    void writeScene(const std::string& name, const std::string& lines) {
        test::writeText(folder / name, "version = 1\nmodel = \"room.obj\"\n" + lines);
    }

    test::TemporaryFolder folder;
};

TEST_F(UpAndUnits, OptionsWinOverTheScene) {
    writeScene("y.scn", "");
    writeScene("z.scn", "up = \"+z\"\n");
    const std::string y = picture("y.scn"), z = picture("z.scn");
    EXPECT_NE(y, z);
    EXPECT_EQ(picture("y.scn", {"--up=+z"}), z);
    EXPECT_EQ(picture("z.scn", {"--up", "+y"}), y);
    EXPECT_EQ(picture("z.scn", {"--up=auto"}), z);
}

TEST_F(UpAndUnits, APictureIsTurnedUprightWhereTheSceneHasACamera) {
    const std::string camera = "[camera]\neye = [0, 2, 6]\nforward = [0, 0, -1]\n";
    writeScene("y.scn", camera);
    writeScene("x.scn", "up = \"+x\"\n" + camera);
    EXPECT_EQ(picture("y.scn", {"--up=+x"}), picture("x.scn"));
    EXPECT_NE(picture("y.scn", {"--up=+x"}), picture("y.scn"));
}

TEST_F(UpAndUnits, ABspKeepsWhatItsBuilderWasTold) {
    ASSERT_EQ(test::bspBuilder({file("room.obj"), file("room.bsp"), "--up=-z", "--units=ft"}).exitCode, 0);
    EXPECT_EQ(picture("room.bsp"), picture("room.obj", {"--up=-z"}));
    EXPECT_EQ(picture("room.bsp", {"--up=+y"}), picture("room.obj", {"--up=+y"}));
}

TEST_F(UpAndUnits, UnitsDecideWhatALensBlurs) {
    writeScene("m.scn", "");
    writeScene("cm.scn", "metresPerUnit = 0.01\n");
    const Names lens{"--setting=depthOfField.on=on", "--setting=depthOfField.focus=3",
                     "--setting=depthOfField.fNumber=1"};
    Names small = lens;
    small.emplace_back("--units=cm");
    EXPECT_EQ(picture("m.scn", small), picture("cm.scn", lens));
    EXPECT_NE(picture("m.scn", small), picture("m.scn", lens));
}

// People are told of a guess, since the image may lie on its side.
TEST_F(UpAndUnits, AGuessIsTold) {
    const auto told = [&](const std::string& scene, const Names& options) {
        Names arguments{file(scene), "-o", file("a.ppm"), "-w", "8", "-h", "8"};
        arguments.insert(arguments.end(), options.begin(), options.end());
        const test::ProgramResult result = test::renderer(arguments);
        EXPECT_EQ(result.exitCode, 0) << result.error;
        EXPECT_EQ(result.output.find("guessed"), std::string::npos);
        return result.error;
    };
    writeScene("said.scn", "up = \"+z\"\nmetresPerUnit = 0.01\n");
    const std::string lines = "--progress=plain";
    EXPECT_NE(
        told("room.obj", {lines}).find("room.obj: +y is up (guessed: usual for OBJ files); one unit is "),
        std::string::npos);
    const std::string unitOnly = told("room.obj", {lines, "--up=+z"});
    EXPECT_NE(unitOnly.find("room.obj: +z is up (as you say); one unit is "), std::string::npos) << unitOnly;
    EXPECT_NE(unitOnly.find("guessed"), std::string::npos);
    for (const auto& [scene, options] :
         {std::pair{"room.obj", Names{lines, "--up=+z", "--units=cm"}}, std::pair{"said.scn", Names{lines}},
          std::pair{"room.obj", Names{"--progress=none"}}, std::pair{"room.obj", Names{"--progress=json"}}})
        EXPECT_EQ(told(scene, options).find("guessed"), std::string::npos) << options.back();
}

TEST_F(UpAndUnits, WrongOnesAreRefused) {
    for (const char* option :
         {"--up=z", "--up=up", "--units=parsecs", "--units=0", "--units=-1", "--units=nan"}) {
        const test::ProgramResult result = test::renderer({file("room.obj"), "-o", file("a.png"), option});
        EXPECT_EQ(result.exitCode, 2) << option << result.error;
    }
}

} // namespace
