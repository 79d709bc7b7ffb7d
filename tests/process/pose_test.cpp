/// The pose of an animated model: --pose, .scn, .bsp.
#include "process/sample_scene.h"
#include "unit/import/pose_files.h"

#include <gtest/gtest.h>

namespace {

class Poses : public testing::Test {
  protected:
    Poses() {
        test::writeText(folder / "bar.x", test::barX());
        writeScene("rest.scn", "");
        writeScene("first.scn", "pose = \"first\"\n");
    }

    test::ProgramResult render(const std::string& scene, const std::string& pose = "") {
        std::vector<std::string> arguments{scene, "-o", "a.ppm", "-w", "40", "-h", "30", "--force"};
        if (!pose.empty()) arguments.push_back("--pose=" + pose);
        return test::renderer(arguments, {.folder = folder.path()});
    }
    /// The bytes of the picture.
    std::string picture(const std::string& scene, const std::string& pose = "") {
        const test::ProgramResult result = render(scene, pose);
        EXPECT_EQ(result.exitCode, 0) << result.error;
        return test::readBytes(folder / "a.ppm");
    }

    /// Seen from the front in even light.
    void writeScene(const std::string& name, const std::string& line) const {
        test::writeText(
            folder / name,
            "version = 2\nmodel = \"bar.x\"\nambient = [0.5, 0.5, 0.5]\nbackground = [0, 0, 1]\n" + line +
                "[camera]\neye = [0, 1, 6]\nforward = [0, 0, -1]\n");
    }

    test::TemporaryFolder folder;
};

TEST_F(Poses, TheCommandLineBeatsTheScene) {
    const std::string rest = picture("rest.scn"), first = picture("first.scn");
    EXPECT_NE(rest, first);
    EXPECT_EQ(picture("rest.scn", "first"), first);
    EXPECT_EQ(picture("first.scn", "rest"), rest);
    EXPECT_EQ(picture("rest.scn", "Walk@0"), first);
    EXPECT_EQ(picture("first.scn", "1@1"), rest) << "the animation ends where the frames stand";
    EXPECT_NE(picture("first.scn", "Walk@0.5"), rest);
}

TEST_F(Poses, ABspKeepsThatOfItsBuilder) {
    const auto build = [&](const char* pose, const char* bsp) {
        return test::bspBuilder({"bar.x", bsp, pose}, {.folder = folder.path()}).exitCode;
    };
    ASSERT_EQ(build("--pose=first", "first.bsp"), 0);
    EXPECT_EQ(picture("first.bsp"), picture("bar.x", "first"));
    const test::ProgramResult told = render("first.bsp", "Walk@1");
    EXPECT_EQ(told.exitCode, 0);
    EXPECT_NE(told.error.find("the pose that it was built in"), std::string::npos) << told.error;
    EXPECT_EQ(build("--pose=Run@0", "run.bsp"), 65);
}

TEST_F(Poses, UnknownOnesAreRefusedWithThoseThatThereAre) {
    const test::ProgramResult unknown = render("bar.x", "Run@0");
    EXPECT_EQ(unknown.exitCode, 65);
    EXPECT_NE(unknown.error.find("it has no animation 'Run'; name one of these: 1 'Walk'"), std::string::npos)
        << unknown.error;
    EXPECT_EQ(render("bar.x", "walking").exitCode, 2);
    writeScene("odd.scn", "pose = \"Walk\"\n");
    EXPECT_EQ(render("odd.scn").exitCode, 65);
    test::writeText(folder / "old.scn", "version = 1\nmodel = \"bar.x\"\npose = \"first\"\n");
    EXPECT_EQ(render("old.scn").exitCode, 65);
}

} // namespace
