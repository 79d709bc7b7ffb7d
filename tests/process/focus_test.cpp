/// The distance in focus by Renderer --focus-at; and the samples that Renderer -v reports as saved.
#include "process/sample_scene.h"

#include <gtest/gtest.h>

#include <regex>

namespace {

class Focusing : public testing::Test {
  protected:
    void SetUp() override {
        test::writeText(folder / "wall.obj", "v -9 -9 -4\nv 0 -9 -4\nv 0 9 -4\nv -9 9 -4\nf 1 2 3 4\n");
        test::writeText(folder / "wall.scn", "version = 1\nmodel = \"wall.obj\"\nambient = [1, 1, 1]\n"
                                             "[camera]\neye = [0, 0, 0]\nforward = [0, 0, -1]\n"
                                             "[still]\nwidth = 40\nheight = 30\nantialiasing = 2\n");
    }
    test::ProgramResult render(std::vector<std::string> arguments) {
        arguments.insert(arguments.begin(), {"wall.scn", "-v"});
        return test::renderer(arguments, {.folder = folder.path()});
    }

    test::TemporaryFolder folder;
};

TEST_F(Focusing, OnWhatIsSeenThere) {
    const test::ProgramResult wall = render({"-o", "wall.ppm", "--focus-at", "5,12.5"});
    EXPECT_EQ(wall.exitCode, 0) << wall.error;
    EXPECT_NE(wall.error.find("focused at 4\n"), std::string::npos) << wall.error;
    const test::ProgramResult sky = render({"-o", "sky.ppm", "--focus-at", "39,12"});
    EXPECT_NE(sky.error.find("focused at infinity\n"), std::string::npos) << sky.error;
    EXPECT_EQ(
        render({"-o", "same.ppm", "--setting", "depthOfField.on=true", "--setting", "depthOfField.focus=4"})
            .exitCode,
        0);
    const std::string picture = test::readBytes(folder / "wall.ppm");
    EXPECT_EQ(picture, test::readBytes(folder / "same.ppm"));
}

TEST_F(Focusing, PlacesThatAreNoneAreRefused) {
    for (const char* place :
         {"5", "5,", ",5", "5;5", "a,b", "-1,5", "5,5,5", "nan,1", "inf,1", "41,5", "5,31"}) {
        const test::ProgramResult result = render({"-o", "a.ppm", "--focus-at", place});
        EXPECT_EQ(result.exitCode, 2) << place << result.error;
        EXPECT_NE(result.error.find("focus-at"), std::string::npos) << place << result.error;
        EXPECT_FALSE(std::filesystem::exists(folder / "a.ppm"));
    }
}

TEST_F(Focusing, SavedSamplesAreTold) {
    const test::ProgramResult result =
        render({"-o", "a.ppm", "--setting", "adaptive=0.05", "--setting", "antialiasing=4"});
    EXPECT_TRUE(std::regex_search(result.error,
                                  std::regex("took [0-9]+ of 19200 samples, [67][0-9]\\.[0-9] % saved")))
        << result.error;
    EXPECT_EQ(render({"-o", "b.ppm"}).error.find("saved"), std::string::npos);
}

} // namespace
