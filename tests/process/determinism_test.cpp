/// The same bits for every number of threads, and for a model and its .bsp.
#include "process/sample_scene.h"

#include <gtest/gtest.h>

namespace {

class SameBits : public testing::Test {
  protected:
    void SetUp() override {
        test::writeRoom(folder / "room.obj");
        test::writeWaves(folder / "waves.obj", 90);
    }
    std::string render(const std::string& scene, const std::vector<std::string>& extra) {
        std::vector<std::string> arguments{scene, "-w", "97", "-h", "61",
                                           "-a",  "2",  "-o", "-",  "--format=ppm"};
        arguments.insert(arguments.end(), extra.begin(), extra.end());
        const test::ProgramResult result = test::renderer(arguments, {.folder = folder.path()});
        EXPECT_EQ(result.exitCode, 0) << result.error;
        EXPECT_GT(result.output.size(), 97U * 61 * 3);
        return result.output;
    }
    std::string build(const std::string& model, const std::vector<std::string>& extra) {
        std::vector<std::string> arguments{model, "out.bsp"};
        arguments.insert(arguments.end(), extra.begin(), extra.end());
        const test::ProgramResult result = test::bspBuilder(arguments, {.folder = folder.path()});
        EXPECT_EQ(result.exitCode, 0) << result.error;
        return test::readBytes(folder / "out.bsp");
    }

    test::TemporaryFolder folder;
};

TEST_F(SameBits, PicturesOfOneTwoAndSevenThreads) {
    for (const char* scene : {"room.obj", "waves.obj"}) {
        const std::string one = render(scene, {"--threads=1"});
        EXPECT_TRUE(one == render(scene, {"--threads=2"})) << scene;
        EXPECT_TRUE(one == render(scene, {"--threads=7"})) << scene;
    }
}

TEST_F(SameBits, TreesOfOneTwoAndSevenThreads) {
    for (const std::vector<std::string>& mode :
         std::vector<std::vector<std::string>>{{}, {"-f"}, {"-f", "-m", "1"}}) {
        const auto with = [&](const char* threads) {
            std::vector<std::string> arguments = mode;
            arguments.emplace_back(threads);
            return build("waves.obj", arguments);
        };
        const std::string one = with("--threads=1");
        ASSERT_FALSE(one.empty());
        EXPECT_TRUE(one == with("--threads=2")) << testing::PrintToString(mode);
        EXPECT_TRUE(one == with("--threads=7")) << testing::PrintToString(mode);
    }
}

TEST_F(SameBits, AModelAndItsBsp) {
    for (const char* scene : {"room.obj", "waves.obj"}) {
        const std::string ofModel = render(scene, {});
        build(scene, {});
        EXPECT_TRUE(ofModel == render("out.bsp", {})) << scene;
        build(scene, {"-f"});
        EXPECT_TRUE(ofModel == render("out.bsp", {})) << scene << ", fast tree";
    }
}

} // namespace
