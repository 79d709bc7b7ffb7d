#include "common/progress/progress_format.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <limits>

namespace {

using app::ProgressState;

TEST(ProgressFormat, Durations) {
    EXPECT_EQ(app::durationText(0), "0:00");
    EXPECT_EQ(app::durationText(6.2), "0:07");
    EXPECT_EQ(app::durationText(754), "12:34");
    EXPECT_EQ(app::durationText(3723), "1:02:03");
    EXPECT_EQ(app::durationText(-5), "0:00");
}

TEST(ProgressFormat, BarFitsTheTerminal) {
    const ProgressState state{"rendering", 0.485, 3, 10, 66.5};
    EXPECT_EQ(app::barText(state, 200),
              "rendering 3/10 [###################                     ]  48% 1:07 left");
    for (int columns = 1; columns < 120; ++columns) {
        EXPECT_LT(app::barText(state, columns).size(), static_cast<std::size_t>(std::max(columns, 2)))
            << columns;
    }
    EXPECT_EQ(app::barText({"importing", {}, 0, 0, {}}, 80), "importing");
}

TEST(ProgressFormat, PlainLines) {
    EXPECT_EQ(app::plainText({"rendering", 0.485, 3, 10, 66.5}), "rendering frame 3 of 10: 48%, 1:07 left");
    EXPECT_EQ(app::plainText({"importing", {}, 0, 0, {}}), "importing");
}

TEST(ProgressFormat, JsonAlwaysHasAllNames) {
    const auto known = nlohmann::json::parse(app::jsonText({"rendering", 0.485, 3, 10, 66.54}));
    EXPECT_EQ(known["phase"], "rendering");
    EXPECT_EQ(known["fraction"], 0.485);
    EXPECT_EQ(known["frame"], 3);
    EXPECT_EQ(known["frames"], 10);
    EXPECT_EQ(known["secondsLeft"], 66.5);
    const auto unknown = nlohmann::json::parse(app::jsonText({"a \"b\\\n", {}, 0, 0, {}}));
    EXPECT_EQ(unknown["phase"], "a \"b\\\n");
    for (const char* name : {"fraction", "frame", "frames", "secondsLeft"})
        EXPECT_TRUE(unknown[name].is_null()) << name;
}

TEST(ProgressFormat, JsonKeepsItsOrderAndRoundsItsNumbers) {
    EXPECT_EQ(app::jsonText({"rendering", 0.48504, 3, 10, 66.54}),
              R"({"phase":"rendering","fraction":0.485,"frame":3,"frames":10,"secondsLeft":66.5})");
    constexpr double none = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(
        app::jsonText({"a\xff", 1.0, 0, 0, none}),
        "{\"phase\":\"a\xef\xbf\xbd\",\"fraction\":1.0,\"frame\":null,\"frames\":null,\"secondsLeft\":null}");
}

} // namespace
