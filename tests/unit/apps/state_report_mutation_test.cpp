// Damaged answers to `state`: each is read, or refused by a FileError; what is read is written and read
// again.
#include "common/commands/state_report.h"

#include "rtcore/platform/error.h"
#include "rtcore/settings/render_settings.h"
#include "support/damaged_text.h"

#include <gtest/gtest.h>

namespace {

app::StateReport fullState() {
    app::StateReport state{.scene = "/scenes/a.scn",
                           .lights = {{1, true, "sun", rtcore::LightDescription()}, {7, false, ""}},
                           .environments = {{false, "day"}, {true, "night"}},
                           .map = app::ReportedMap{-30.5F, 2},
                           .sky = rtcore::Sky{.north = 40, .turbidity = 5, .ground = true},
                           .bounds = {{-1, 0, -1}, {1, 2, 1}},
                           .sections = {.planes = {{{0, 1, 0}, {0, 1, 0}}},
                                        .light = rtcore::SectionLight::Cut,
                                        .caps = {rtcore::CapColours::One, {1, 0, 0}, true}},
                           .measures = {.all = {{.points = {{0, 1, 0}, {1, 0, 0}}, .name = "a"},
                                                {.kind = rtcore::MeasureKind::Area,
                                                 .points = {{1, 2, 3}},
                                                 .normal = {0, 1, 0},
                                                 .amount = 4}},
                                        .unit = rtcore::LengthUnit::Inch,
                                        .decimals = 1},
                           .measureCount = 2,
                           .notes = {{.point = {1, 2, 3},
                                      .text = "a\nb",
                                      .author = "c",
                                      .view = {},
                                      .written = "2026-11-30T18:40:00Z"}},
                           .noteCount = 2,
                           .notesShortened = true,
                           .camera = {},
                           .settings = rtcore::settingAssignments(rtcore::RenderSettings(), true),
                           .undo = "set bloom.radius",
                           .redo = "load camera",
                           .bookmarks = {"door"},
                           .flights = {{.name = "around",
                                        .seconds = 12.5,
                                        .timing = rtcore::FlightTiming::Times,
                                        .closed = true,
                                        .turntable = true,
                                        .keyCount = 2,
                                        .keyTimes = {0, 12500}}},
                           .variants = {"oak", "by night"},
                           .variant = "oak",
                           .modified = true,
                           .edits = 3};
    state.lights[0].description->id = 1;
    state.lights[0].description->name = "sun";
    return state;
}

TEST(StateReportMutation, IsReadOrRefused) {
    app::StateReport other = fullState();
    other.settings.clear();
    other.map.reset();
    other.camera.kind = rtcore::CameraKind::Orthographic;
    constexpr std::size_t kRoom = 60000;
    test::DamagedText damaged(
        {app::formatStateReport(fullState(), kRoom), app::formatStateReport(other, kRoom)}, test::kTomlTokens,
        7);
    long readable = 0;
    for (long i = 0; i < test::damagedTexts(); ++i) {
        const std::string text = damaged.next();
        try {
            // Escapes that replace bytes of damaged names are written as they are from then on.
            const std::size_t room = text.size() * 8 + kRoom;
            const std::string written = app::formatStateReport(app::parseStateReport(text), room);
            EXPECT_EQ(app::formatStateReport(app::parseStateReport(written), room), written) << text;
            ++readable;
        } catch (const rtcore::FileError& error) {
            EXPECT_EQ(error.kind, rtcore::FailureKind::BadData);
        }
    }
    EXPECT_GT(readable, 0);
    EXPECT_LT(readable, test::damagedTexts());
}

} // namespace
