// --hide, --show, --isolate and --lights: what they leave of a scene.
#include "common/settings/selection_options.h"

#include "common/cli/selection_option_group.h"

#include "rtcore/scene/part_list.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <string>
#include <vector>

namespace {

using Words = std::vector<std::string>;
using Flags = std::vector<std::uint8_t>;

/// A triangle each: floor, box, ball, box, and one that is not named; three lights.
rtcore::Scene house() {
    rtcore::ModelBuffers b;
    b.triangles.resize(5);
    const std::uint32_t floor = b.addName("room/floor"), box = b.addName("room/box"),
                        ball = b.addName("ball"), none = b.addName("");
    b.parts = {{floor, 0, 1}, {box, 1, 1}, {ball, 2, 1}, {box, 3, 1}, {none, 4, 1}};
    rtcore::Scene scene;
    scene.model = makeModel(std::move(b));
    scene.lights = {{{}, "sun"}, {{}, ""}, {{}, "desk"}};
    for (std::size_t i = 0; const int id : {1, 7, 3}) scene.lights[i++].notes.id = id;
    scene.lights[1].light.on = 0;
    return scene;
}

app::Selection selectionOf(const Words& words) {
    const app::ProgramSpec spec{.name = "x",
                                .purpose = "",
                                .positionals = {},
                                .groups = {app::selectionOptionGroup()},
                                .examples = {}};
    return app::readSelection(app::parseCommandLine(spec, words));
}

Flags hiddenBy(const Words& words) {
    rtcore::Scene scene = house();
    app::selectParts(selectionOf(words), scene);
    return partTriangles(scene.model, scene.hiddenParts);
}

Flags onBy(const std::string& list) {
    rtcore::Scene scene = house();
    app::selectLights(selectionOf({"--lights=" + list}), scene);
    Flags on;
    for (const rtcore::SceneLight& each : scene.lights)
        on.push_back(static_cast<std::uint8_t>(each.light.on));
    return on;
}

std::string refusalOf(const Words& words) {
    rtcore::Scene scene = house();
    try {
        app::selectParts(selectionOf(words), scene);
        app::selectLights(selectionOf(words), scene);
    } catch (const app::UsageError& error) {
        return error.what();
    }
    return "";
}

TEST(Selection, HidesAndShowsInOrder) {
    EXPECT_EQ(hiddenBy({}), (Flags{0, 0, 0, 0, 0}));
    EXPECT_EQ(hiddenBy({"--hide=room/box"}), (Flags{0, 1, 0, 1, 0}));
    EXPECT_EQ(hiddenBy({"--hide=3", "--hide=room/f*"}), (Flags{1, 0, 1, 0, 0})) << "number and pattern";
    EXPECT_EQ(hiddenBy({"--hide=*", "--show=ball"}), (Flags{1, 1, 0, 1, 1}));
    EXPECT_EQ(hiddenBy({"--show=ball", "--hide=*"}), (Flags{1, 1, 1, 1, 1}));
}

TEST(Selection, IsolatesFirst) {
    EXPECT_EQ(hiddenBy({"--isolate=ball"}), (Flags{1, 1, 0, 1, 1}));
    EXPECT_EQ(hiddenBy({"--isolate=ball", "--isolate=1"}), (Flags{0, 1, 0, 1, 1}));
    EXPECT_EQ(hiddenBy({"--hide=ball", "--isolate=room/*"}), (Flags{0, 0, 1, 0, 1}));
    EXPECT_EQ(hiddenBy({"--show=ball", "--isolate=room/box"}), (Flags{1, 0, 0, 0, 1}));
}

TEST(Selection, WhatTheSceneHidesIsShown) {
    rtcore::Scene scene = house();
    app::selectParts(selectionOf({"--hide=ball", "--hide=1"}), scene);
    app::selectParts({}, scene);
    EXPECT_EQ(partTriangles(scene.model, scene.hiddenParts), (Flags{1, 0, 1, 0, 0})) << "nothing is said";
    app::selectParts(selectionOf({"--show=ball"}), scene);
    EXPECT_EQ(partTriangles(scene.model, scene.hiddenParts), (Flags{1, 0, 0, 0, 0}));
    app::selectParts(selectionOf({"--show=*"}), scene);
    EXPECT_EQ(scene.hiddenParts, nullptr);
}

TEST(Selection, LeavesPartsUncut) {
    rtcore::Scene scene = house();
    app::selectParts(selectionOf({"--section-except=room/*", "--hide=ball", "--section-except=4"}), scene);
    EXPECT_EQ(partTriangles(scene.model, scene.uncutParts), (Flags{1, 1, 0, 1, 1}));
    EXPECT_EQ(partTriangles(scene.model, scene.hiddenParts), (Flags{0, 0, 1, 0, 0}));
    EXPECT_THROW(app::selectParts(selectionOf({"--section-except=cellar"}), scene), app::UsageError);
}

TEST(Selection, SwitchesLights) {
    EXPECT_EQ(onBy("all"), (Flags{1, 1, 1}));
    EXPECT_EQ(onBy("none"), (Flags{0, 0, 0}));
    EXPECT_EQ(onBy("7"), (Flags{0, 1, 0})) << "an id, not a place";
    EXPECT_EQ(onBy("desk,1"), (Flags{1, 0, 1}));
    EXPECT_EQ(onBy("*s*"), (Flags{1, 0, 1}));
}

TEST(Selection, TellsWhatThereIs) {
    EXPECT_EQ(refusalOf({"--hide=ball"}), "");
    EXPECT_EQ(refusalOf({"--hide=attic"}), "option '--hide': no part of the model is 'attic'; it has "
                                           "'room/floor', 'room/box', 'ball' and number 4");
    EXPECT_EQ(refusalOf({"--isolate=5"}).find("option '--isolate': no part of the model is '5'; it has "),
              0U);
    EXPECT_EQ(refusalOf({"--lights=desk,2"}),
              "option '--lights': no light of the scene is '2'; it has 1 'sun', 7 and 3 'desk'");
    EXPECT_EQ(refusalOf({"--lights=desk,"}).find("option '--lights': no light of the scene is ''"), 0U);
}

TEST(Selection, TellsSomeOfMany) {
    rtcore::Scene scene;
    rtcore::ModelBuffers b;
    b.triangles.resize(20);
    for (std::uint32_t i = 0; i < 20; ++i) b.parts.push_back({b.addName("p" + std::to_string(i)), i, 1});
    scene.model = makeModel(std::move(b));
    try {
        app::selectParts(selectionOf({"--show=q"}), scene);
        ADD_FAILURE();
    } catch (const app::UsageError& error) {
        EXPECT_EQ(std::string(error.what()),
                  "option '--show': no part of the model is 'q'; it has 'p0', 'p1', "
                  "'p2', 'p3', 'p4', 'p5', 'p6', 'p7' and 12 more");
    }
    try {
        app::selectLights(selectionOf({"--lights=1"}), scene);
        ADD_FAILURE();
    } catch (const app::UsageError& error) {
        EXPECT_EQ(std::string(error.what()), "option '--lights': no light of the scene is '1'; it has none");
    }
}

} // namespace
