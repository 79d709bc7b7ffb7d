/// The report of BSPBuilder.
#include "process/sample_scene.h"

#include <gtest/gtest.h>

#include <regex>

namespace {

class Reports : public testing::Test {
  protected:
    void SetUp() override { test::writeRoom(folder / "room.obj"); }
    std::string build(std::vector<std::string> extra) {
        extra.insert(extra.begin(), {"room.obj", "room.bsp"});
        const test::ProgramResult result = test::bspBuilder(extra, {.folder = folder.path()});
        EXPECT_EQ(result.exitCode, 0) << result.error;
        return result.output;
    }
    static bool has(const std::string& text, const std::string& pattern) {
        return std::regex_search(text, std::regex(pattern));
    }

    test::TemporaryFolder folder;
};

TEST_F(Reports, NothingUnlessAsked) { EXPECT_EQ(build({}), ""); }

TEST_F(Reports, VerboseTellsTheModelAndTheTimes) {
    const std::string text = build({"-v"});
    EXPECT_TRUE(has(text, "triangles: +168\n")) << text; // 14 boxes
    EXPECT_TRUE(has(text, "dropped: no area: +0\n")) << text;
    EXPECT_TRUE(has(text, "materials: +[1-9]")) << text;
    EXPECT_TRUE(has(text, "import: +[0-9.]+ s\n")) << text;
    EXPECT_FALSE(has(text, "nodes:")) << text;
}

TEST_F(Reports, VeryVerboseTellsTheTree) {
    for (const std::vector<std::string>& mode :
         std::vector<std::vector<std::string>>{{"-vv"}, {"-vv", "-f", "-m", "2"}}) {
        const std::string text = build(mode);
        for (const char* label :
             {"triangles", "tree: prepare", "tree: split", "tree: emit", "nodes", "leaves", "depth",
              "references", "expected cost", "tree memory", "import", "write"}) {
            EXPECT_TRUE(has(text, std::string(label) + ": +[0-9]")) << label << "\n" << text;
        }
        EXPECT_TRUE(has(text, "check: structure: +sound\n")) << text;
        EXPECT_TRUE(has(text, "check: coverage: +sound\n")) << text;
    }
}

TEST_F(Reports, HistogramsOfSizeAndDepth) {
    const std::string text = build({"-hist", "5"});
    EXPECT_NE(text.find("Leaves by number of triangles"), std::string::npos) << text;
    EXPECT_NE(text.find("Leaves by depth"), std::string::npos) << text;
    EXPECT_FALSE(has(text, "nodes:")) << text;
}

TEST_F(Reports, DroppedTrianglesAreCounted) {
    test::writeText(folder / "room.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 2 0 0\nf 1 2 3\nf 1 2 4\nf 1 1 2\n");
    const std::string text = build({"-v"});
    EXPECT_TRUE(has(text, "triangles: +1\n")) << text;
    EXPECT_TRUE(has(text, "dropped: no area: +2\n")) << text;
}

} // namespace
