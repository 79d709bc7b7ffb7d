/// Means and the two forms of the report.
#include "bench/rtbench/json_report.h"
#include "bench/rtbench/summary.h"
#include "bench/rtbench/tables.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace {

using rtbench::RayFigures;
using rtbench::Rival;
using rtbench::SceneFigures;

SceneFigures scene(const std::string& name, const std::string& view, double ratio, double robust) {
    RayFigures primary;
    primary.test = &rtbench::kRayTests[0];
    primary.rays = 100;
    primary.speed = 50;
    primary.best = Rival{"high 16 coherent", 50 / ratio, ratio, 1};
    primary.robust = Rival{"robust 16 coherent", 50 / robust, robust, 2};
    primary.spread = 0.0123;
    SceneFigures figures;
    figures.scene = name;
    figures.view = view;
    figures.triangles = 12;
    figures.rays = {primary};
    return figures;
}

TEST(Means, TakeTheMedianOfAScenesViewsWhenAsked) {
    const std::vector<SceneFigures> scenes{scene("a", "one", 2, 4), scene("a", "two", 3, 1),
                                           scene("a", "three", 9, 2)};
    const auto median = [&](bool robust) {
        return *rtbench::meanRatio(scenes, rtbench::kRayTests[0], robust, rtbench::OfViews::Median);
    };
    EXPECT_NEAR(median(false), 3, 1e-9);
    EXPECT_NEAR(median(true), 2, 1e-9);
}

TEST(Means, CountEachSceneOnce) {
    const std::vector<SceneFigures> scenes{scene("a", "one", 2, 4), scene("a", "two", 8, 4),
                                           scene("b", "", 1, 4)};
    EXPECT_NEAR(*rtbench::meanRatio(scenes, rtbench::kRayTests[0], false), 2, 1e-9); // sqrt(4 * 1)
    EXPECT_NEAR(*rtbench::meanRatio(scenes, rtbench::kRayTests[0], true), 4, 1e-9);
    EXPECT_FALSE(rtbench::meanRatio(scenes, rtbench::kRayTests[1], false));
    EXPECT_NE(rtbench::meansTable(scenes).find("2.000"), std::string::npos);
}

TEST(JsonReport, HasTheDocumentedNames) {
    const auto json = nlohmann::json::parse(rtbench::jsonReport(std::vector{scene("a", "one", 2, 4)}));
    const auto expected = nlohmann::json::parse(
        R"({"scenes": [{"name": "a one", "triangles": 12, "look": "headlight", "rays": {"primary": {"ours": 50.0, "embree": 25.0,
            "mode": "high 16 coherent", "ratio": 2.0, "ratioRobust": 4.0, "spread": 0.0123}}}],
            "geomean": {"primary": 2.0}, "geomeanRobust": {"primary": 4.0},
            "geomeanOfMedians": {"primary": 2.0}, "geomeanOfMediansRobust": {"primary": 4.0}})");
    EXPECT_EQ(json, expected);
}

TEST(JsonReport, OfFrames) {
    SceneFigures figures = scene("a", "", 2, 4);
    rtbench::FrameFigures frame;
    frame.kind = "phong";
    frame.threads = 2;
    frame.ours = {0.010, 0.011};
    frame.embree = rtbench::FrameTimes{0.015, 0.016};
    figures.frames = {frame};
    const auto frames = nlohmann::json::parse(rtbench::jsonReport(std::vector{figures})).at("frames");
    const auto expected = nlohmann::json::parse(
        R"({"scenes": [{"name": "a", "phong": {"2": {"ours": 10.0, "oursMedian": 11.0, "embree": 15.0,
            "embreeMedian": 16.0, "ratio": 1.5, "fps": 100.0}}}], "geomean": {"phong": {"2": 1.5}}})");
    EXPECT_EQ(frames, expected);
}

TEST(JsonReport, WithoutARivalHasNulls) {
    SceneFigures figures = scene("a", "", 2, 4);
    figures.rays[0].best.reset();
    figures.rays[0].robust.reset();
    const auto json = nlohmann::json::parse(rtbench::jsonReport(std::vector{figures}));
    const auto& primary = json["scenes"][0]["rays"]["primary"];
    for (const char* key : {"embree", "mode", "ratio", "ratioRobust"}) EXPECT_TRUE(primary.at(key).is_null());
    EXPECT_EQ(json["geomean"], nlohmann::json::object());
    EXPECT_EQ(rtbench::meansTable(std::vector{figures}), "");
}

TEST(Tables, SayWhatTheTreesTake) {
    SceneFigures figures = scene("a", "", 2, 4);
    figures.trees = {{"ours", 61.6}, {"Embree default", 150}};
    EXPECT_NE(rtbench::sceneTable(figures, false).find("bytes a triangle: ours 62, Embree default 150\n"),
              std::string::npos);
    const auto json = nlohmann::json::parse(rtbench::jsonReport(std::vector{figures}));
    EXPECT_EQ(json["scenes"][0]["bytesPerTriangle"]["ours"], 61.6);
}

TEST(Tables, ListModesWhenAsked) {
    SceneFigures figures = scene("a", "", 2, 4);
    figures.rays[0].modes = {Rival{"default 1", 5, 10, 0}};
    EXPECT_EQ(rtbench::sceneTable(figures, false).find("default 1"), std::string::npos);
    EXPECT_NE(rtbench::sceneTable(figures, true).find("default 1"), std::string::npos);
}

} // namespace
