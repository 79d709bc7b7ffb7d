// Bounds to what a hostile file may ask of the parser: depth, size, time.
#include "rtcore/io/text/cam.h"
#include "rtcore/io/text/scn.h"
#include "rtcore/io/text/toml_guard.h"
#include "rtcore/io/text/toml_parser.h"
#include "support/temporary_folder.h"
#include "unit/text/text_test_support.h"

#include <gtest/gtest.h>

namespace {

std::string repeated(std::string_view piece, std::size_t times) {
    std::string text;
    for (std::size_t i = 0; i < times; ++i) text += piece;
    return text;
}

std::string problem(const std::string& text) {
    return test::badData([&] { rtcore::parseToml(text, "f"); });
}

TEST(TomlBounds, DeepNestingIsRefused) {
    for (const std::size_t depth : {20U, 1000U, 1'000'000U}) {
        EXPECT_NE(problem(repeated("a.", depth) + "b = 1"), "no error");
        EXPECT_NE(problem("[" + repeated("a.", depth) + "b]"), "no error");
        EXPECT_NE(problem("[[" + repeated("a.", depth) + "b]]"), "no error");
        EXPECT_NE(problem("a = " + repeated("[", depth)), "no error");
        EXPECT_NE(problem("a = " + repeated("[", depth) + repeated("]", depth)), "no error");
        EXPECT_NE(problem("a = " + repeated("{a = ", depth) + "1" + repeated("}", depth)), "no error");
        EXPECT_NE(problem("a = {" + repeated("a.", depth) + "b = 1}"), "no error");
        EXPECT_NE(problem("a = [{x = 1, " + repeated("'=' . \"\\\"\" .", depth) + "b = 1}]"), "no error");
    }
}

TEST(TomlBounds, RefusalsNameTheirPlace) {
    EXPECT_EQ(problem("x = 1\n" + repeated("a.", 16) + "b = 1"),
              "f:2:32: a key has too many parts; no scene needs that");
    EXPECT_EQ(problem("x = \"\u00e4\"\ny = " + repeated("[", 17)),
              "f:2:21: too many brackets within brackets; no scene needs that");
}

TEST(TomlBounds, WhatLooksDeepInStringsAndCommentsIsTaken) {
    const std::string dots = repeated(".", 100), brackets = repeated("[{", 100);
    EXPECT_EQ(problem("a = \"" + dots + brackets + "\\\"" + dots + "\" # " + dots + brackets), "no error");
    EXPECT_EQ(problem("a = '" + dots + brackets + "\\'\nb = 2"), "no error");
    EXPECT_EQ(problem("a = \"\"\"" + dots + "\n\"\" " + brackets + "\"\"\"\"\"\nb = 2"), "no error");
    EXPECT_EQ(problem("a = '''" + dots + "\n'' " + brackets + "'''''\nb = 2"), "no error");
    EXPECT_EQ(problem("\"" + dots + "\" = 1\nb = [" + repeated("1.5, ", 100) + "]"), "no error");
    EXPECT_EQ(problem(repeated("[[a.b]]\nx.y = 1.5\n", 100)), "no error");
}

TEST(TomlBounds, ManyValuesAreRefusedBeforeTheyTakeMemory) {
    EXPECT_EQ(problem("a = [" + repeated("1,", 2'000'000) + "]").substr(0, 2), "f:");
    EXPECT_NE(problem(repeated("a.b = 1\n", 20'000)), "no error");
}

TEST(TomlBounds, LargeFilesAreRefused) {
    const test::TemporaryFolder folder;
    test::writeFile(folder / "large.cam", std::string(rtcore::kMaxTomlBytes + 1, '#'));
    EXPECT_NE(test::badData([&] { rtcore::readCameraFile(folder / "large.cam"); }), "no error");
    test::writeFile(folder / "long.cam",
                    "version = 1\neye = [0,0,0]\nforward = [0,0,1]\n#" + std::string(1 << 20, 'x'));
    EXPECT_EQ(test::badData([&] { rtcore::readCameraFile(folder / "long.cam"); }), "no error");
}

TEST(TomlBounds, MessagesOfLongNamesAreShort) {
    const std::string name(1 << 20, 'x');
    const auto parse = [&](const std::string& text) {
        return test::badData([&] { rtcore::parseSceneFile(text, "f"); });
    };
    EXPECT_LT(parse("version = 1\n" + name + " = 1").size(), 500U);
    EXPECT_LT(parse("version = 1\nmodel = 'a'\nup = '" + name + "'").size(), 500U);
    EXPECT_LT(parse("version = 1\n" + name + " = 1\n" + name + " = 1").size(), 500U);
    EXPECT_LT(parse("version = 1\n[live]\n" + name + ".y = 1").size(), 1000U); // it lists all settings
}

} // namespace
