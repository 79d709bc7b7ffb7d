/// The answer to `state`: what is written is read back.
#include "common/commands/state_report.h"

#include "rtcore/platform/error.h"
#include "rtcore/settings/render_settings.h"

#include <gtest/gtest.h>

namespace {

app::StateReport sampleReport() {
    app::StateReport state{.scene = "/scenes/a \"b\".scn",
                           .lights = {{1, true, "sun"}, {7, false, ""}},
                           .environments = {{false, "day"}, {true, "night"}},
                           .camera = {},
                           .settings = rtcore::settingAssignments(rtcore::RenderSettings(), true),
                           .undo = "set bloom.radius",
                           .redo = "load camera \"a b\"",
                           .undoEdit = {4, 7},
                           .redoEdit = {6, 0},
                           .bookmarks = {"door", "by the \"altar\""},
                           .bookmarkViews = {"00ff", "1234"},
                           .flights = {{.name = "a\"b",
                                        .seconds = 12.5,
                                        .timing = rtcore::FlightTiming::Times,
                                        .keyCount = 2,
                                        .keyTimes = {0, 12500}},
                                       {.name = "c", .seconds = 1, .turntable = true, .keyCount = 1},
                                       {.name = "d", .seconds = 1.0 / 3, .closed = true}},
                           .variants = {"oak \"floor\"", "by night"},
                           .variant = "by night",
                           .modified = true,
                           .edits = 3};
    state.camera.eye = {0.1F, 2, 1.0F / 3};
    state.camera.aspect = 1.5F;
    return state;
}

TEST(StateReport, SurvivesTheRoundTrip) {
    const app::StateReport state = sampleReport();
    EXPECT_EQ(app::parseStateReport(app::formatStateReport(state, 60000)), state);
    app::StateReport other = state;
    other.up = {0, 0, -1};
    other.metresPerUnit = 0.0254F;
    other.sun = 7;
    EXPECT_EQ(app::parseStateReport(app::formatStateReport(other, 60000)), other);
    other.lights.clear();
    other.environments.clear();
    other.camera.kind = rtcore::CameraKind::Orthographic;
    other.camera.orthographicWidth = 12.5F;
    EXPECT_EQ(app::parseStateReport(app::formatStateReport(other, 60000)), other);
}

TEST(StateReport, HasTheSkyAndTheMap) {
    app::StateReport state = sampleReport();
    state.map = app::ReportedMap{-30.5F, 2};
    state.sky = rtcore::Sky{.north = 40, .turbidity = 5, .strength = 0.5F, .ground = true};
    EXPECT_EQ(app::parseStateReport(app::formatStateReport(state, 60000)), state);
    state.sky->date.reset();
    state.sky->direction = {0.1F, 2, -3};
    EXPECT_EQ(app::parseStateReport(app::formatStateReport(state, 60000)), state);
}

TEST(StateReport, HasTheSectionsAndTheBounds) {
    app::StateReport state = sampleReport();
    state.origin.at = {500'000, 0, -3};
    state.bounds = {{-1, 0.1F, -3}, {1, 2, 1.0F / 3}};
    state.sections.planes = {{{0, 1.2F, 0}, {0, 1, 0}}, {{1.0F / 3, 0, 0}, {-1, 2, 0}}};
    EXPECT_EQ(app::parseStateReport(app::formatStateReport(state, 60000)), state);
    state.sections.light = rtcore::SectionLight::Cut;
    state.sections.caps = {rtcore::CapColours::One, {1, 0.5F, 0}, true};
    EXPECT_EQ(app::parseStateReport(app::formatStateReport(state, 60000)), state);
}

TEST(StateReport, HasTheMeasures) {
    app::StateReport state = sampleReport();
    state.measures = {
        .all = {{.points = {{0, 1.0 / 3, 0}, {1, 0, 0}}, .name = "a \"b\""},
                {.kind = rtcore::MeasureKind::Volume, .points = {{1, 2, 3}}, .amount = 4, .part = 2}},
        .unit = rtcore::LengthUnit::Inch,
        .decimals = 1};
    state.measureCount = 2;
    EXPECT_EQ(app::parseStateReport(app::formatStateReport(state, 60000)), state);
}

TEST(StateReport, HasTheNotes) {
    app::StateReport state = sampleReport();
    state.notes = {
        {.point = {1.0 / 3, 1e9, 0}, .text = "a \"b\"\n\tc", .author = "Ada", .view = {}},
        {.point = {1, 2, 3}, .text = std::string(2000, 'x'), .view = {}, .written = "2026-11-30T18:40:00Z"}};
    state.noteCount = 2;
    EXPECT_EQ(app::parseStateReport(app::formatStateReport(state, 60000)), state);
    state.notes[0].view = rtcore::Camera{};
    const app::StateReport read = app::parseStateReport(app::formatStateReport(state, 60000));
    EXPECT_FALSE(read.notes[0].view) << "the server knows it";
}

TEST(StateReport, HasTheBeginningsOfLongNotesAndTheFirstOfVeryMany) {
    app::StateReport state = sampleReport();
    state.notes.assign(40, {.point = {1, 2, 3}, .text = std::string(2000, 'x'), .view = {}});
    state.noteCount = 40;
    const app::StateReport read = app::parseStateReport(app::formatStateReport(state, 60000));
    ASSERT_EQ(read.notes.size(), 40U);
    EXPECT_TRUE(read.notesShortened);
    EXPECT_EQ(read.notes[39].text, rtcore::shortened(state.notes[39].text, app::kShortNote));
    state.notes.assign(1000, {.point = {1.0 / 3, 1.0 / 7, 3}, .text = std::string(2000, '"'), .view = {}});
    state.noteCount = 1000;
    const std::string text = app::formatStateReport(state, 60000);
    EXPECT_LE(text.size(), 60000U);
    const app::StateReport many = app::parseStateReport(text);
    EXPECT_GT(many.notes.size(), 30U);
    EXPECT_LT(many.notes.size(), 1000U);
    EXPECT_EQ(many.noteCount, 1000);
    EXPECT_EQ(many.bookmarks, state.bookmarks);
}

TEST(StateReport, HasTheFirstOfVeryManyMeasures) {
    app::StateReport state = sampleReport();
    rtcore::KeptMeasure chain{.kind = rtcore::MeasureKind::Chain,
                              .points = std::vector<rtcore::Vec3d>(64, {1.0 / 3, 1.0 / 7, 1.0 / 9}),
                              .name = std::string(200, '\x01')};
    state.measures.all.assign(1000, chain);
    state.measureCount = 1000;
    const std::string text = app::formatStateReport(state, 60000);
    EXPECT_LE(text.size(), 60000U);
    const app::StateReport read = app::parseStateReport(text);
    EXPECT_GT(read.measures.all.size(), 4U);
    EXPECT_LT(read.measures.all.size(), 1000U);
    EXPECT_EQ(read.measureCount, 1000);
    EXPECT_EQ(read.bookmarks, state.bookmarks);
}

app::ReportedLight describedLight(int id) {
    app::ReportedLight light{id, true, "spot", rtcore::LightDescription()};
    light.description->name = light.name;
    light.description->id = id;
    light.description->temperature = 2700;
    light.description->light.position = {0.1F, 2, 3};
    return light;
}

TEST(StateReport, DescribesLights) {
    app::StateReport state = sampleReport();
    state.lights = {describedLight(3), describedLight(1)};
    EXPECT_EQ(app::parseStateReport(app::formatStateReport(state, 60000)), state);
}

TEST(StateReport, LeavesDescriptionsOutBeforeNames) {
    app::StateReport state = sampleReport();
    state.lights.clear();
    for (int id = 1; id <= 300; ++id) state.lights.push_back(describedLight(id));
    const app::StateReport read = app::parseStateReport(app::formatStateReport(state, 30000));
    ASSERT_EQ(read.lights.size(), 300U);
    EXPECT_EQ(read.lights.back().id, 300);
    EXPECT_EQ(read.lights.back().name, "spot");
    EXPECT_FALSE(read.lights.back().description);
}

TEST(StateReport, LeavesNamesOutWhereThereIsNoRoom) {
    app::StateReport state = sampleReport();
    state.lights.assign(1000, {1, true, "a light with a rather long name"});
    const std::string text = app::formatStateReport(state, 20000);
    EXPECT_LE(text.size(), 20000U);
    const app::StateReport read = app::parseStateReport(text);
    ASSERT_EQ(read.lights.size(), 1000U);
    EXPECT_TRUE(read.lights.back().on);
    EXPECT_EQ(read.lights.back().name, "");
}

TEST(StateReport, LeavesLightsOutOfVeryMany) {
    app::StateReport state = sampleReport();
    state.lights.assign(100'000, {1, true, "a light"});
    const app::StateReport read = app::parseStateReport(app::formatStateReport(state, 60000));
    EXPECT_GT(read.lights.size(), 3000U);
    EXPECT_LT(read.lights.size(), 100'000U);
    EXPECT_EQ(read.environments.size(), state.environments.size());
    EXPECT_EQ(read.settings, state.settings);
    EXPECT_THROW(app::formatStateReport(state, 100), std::runtime_error);
}

TEST(StateReport, WhatIsNoUtf8IsShownAsBytes) {
    app::StateReport state = sampleReport();
    state.lights[0].name = "l\xE4mp";
    EXPECT_EQ(app::parseStateReport(app::formatStateReport(state, 60000)).lights[0].name, "l\\xe4mp");
}

TEST(StateReport, OtherTextIsRefused) {
    for (const char* text :
         {"", "pong", "version = 1", "version = 2\nscene = \"a\"", "version = 1\nscene = 3", "version = 3"})
        EXPECT_THROW(app::parseStateReport(text), rtcore::FileError) << text;
}

} // namespace
