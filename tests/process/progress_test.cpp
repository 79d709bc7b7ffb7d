/// The output of --progress.
#include "process/sample_scene.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <sstream>

namespace {

std::vector<nlohmann::json> parseLines(const std::string& text) {
    std::vector<nlohmann::json> objects;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) objects.push_back(nlohmann::json::parse(line));
    return objects;
}

void checkObjects(const std::vector<nlohmann::json>& objects) {
    std::string phase;
    double last = 0;
    for (const nlohmann::json& object : objects) {
        EXPECT_EQ(object.size(), 5U);
        ASSERT_TRUE(object.at("phase").is_string());
        if (object["phase"] != phase) last = 0;
        phase = object["phase"];
        if (object.at("fraction").is_null()) continue;
        const double fraction = object["fraction"];
        EXPECT_GE(fraction, last);
        EXPECT_LE(fraction, 1);
        last = fraction;
        EXPECT_TRUE(object.at("secondsLeft").is_null() || object["secondsLeft"] >= 0);
    }
}

TEST(ProgressOutput, JsonParsesLineByLine) {
    const test::TemporaryFolder folder;
    test::writeWaves(folder / "waves.obj", 60);
    test::writeCamera(folder / "a.cam", 0);
    test::writeText(folder / "film.lst", "a.cam\na.cam\na.cam\n");
    const test::ProgramResult result =
        test::renderer({"waves.obj", "--progress=json", "-w", "64", "-h", "48", "-l", "film.lst"},
                       {.folder = folder.path()});
    ASSERT_EQ(result.exitCode, 0) << result.error;
    EXPECT_EQ(result.output, "");
    const auto objects = parseLines(result.error);
    ASSERT_FALSE(objects.empty());
    checkObjects(objects);
    EXPECT_EQ(objects.back()["phase"], "rendering");
    EXPECT_EQ(objects.back()["fraction"], 1);
    EXPECT_EQ(objects.back()["frame"], 3);
    EXPECT_EQ(objects.back()["frames"], 3);
}

TEST(ProgressOutput, BuilderNamesItsPhases) {
    const test::TemporaryFolder folder;
    test::writeWaves(folder / "waves.obj", 60);
    const test::ProgramResult result =
        test::bspBuilder({"waves.obj", "waves.bsp", "--progress=json"}, {.folder = folder.path()});
    ASSERT_EQ(result.exitCode, 0) << result.error;
    const auto objects = parseLines(result.error);
    checkObjects(objects);
    for (const char* phase : {"importing", "building the tree", "writing"}) {
        EXPECT_TRUE(std::any_of(objects.begin(), objects.end(), [&](const auto& o) {
            return o["phase"] == phase;
        })) << phase;
    }
}

TEST(ProgressOutput, NoTerminalMeansNoControlCharacters) {
    const test::TemporaryFolder folder;
    test::writeRoom(folder / "room.obj");
    const test::ProgramResult result =
        test::renderer({"room.obj", "--progress=auto", "-w", "8", "-h", "8"}, {.folder = folder.path()});
    ASSERT_EQ(result.exitCode, 0) << result.error;
    EXPECT_EQ(result.error.find('\r'), std::string::npos) << result.error;
    EXPECT_EQ(result.error.find('\x1b'), std::string::npos) << result.error;
}

TEST(ProgressOutput, TheBarLeavesAnEmptyLine) {
    const test::TemporaryFolder folder;
    test::writeWaves(folder / "waves.obj", 100);
    // Long enough for a bar, by however many processors there are.
    const test::ProgramResult result =
        test::renderer({"waves.obj", "--progress=bar", "--threads=1", "-w", "400", "-h", "300", "-a", "10"},
                       {.folder = folder.path()});
    ASSERT_EQ(result.exitCode, 0) << result.error;
    ASSERT_NE(result.error.find('%'), std::string::npos) << result.error;
    EXPECT_EQ(result.error.substr(result.error.size() - 4), "\r\x1b[K");
}

} // namespace
