/// The answer to `state`: what is written is read back.
#include "common/commands/server_state.h"

#include "rtcore/platform/error.h"
#include "rtcore/settings/render_settings.h"

#include <gtest/gtest.h>

namespace {

app::ServerState sample() {
    app::ServerState state{.scene = "/scenes/a \"b\".scn",
                           .lights = {{true, "sun"}, {false, ""}},
                           .environments = {{false, "day"}, {true, "night"}},
                           .camera = {},
                           .settings = rtcore::settingAssignments(rtcore::RenderSettings(), true)};
    state.camera.eye = {0.1F, 2, 1.0F / 3};
    state.camera.aspect = 1.5F;
    return state;
}

TEST(ServerState, SurvivesTheRoundTrip) {
    const app::ServerState state = sample();
    EXPECT_EQ(app::parseServerState(app::formatServerState(state, 60000)), state);
    app::ServerState other = state;
    other.lights.clear();
    other.environments.clear();
    other.camera.kind = rtcore::CameraKind::Orthographic;
    other.camera.orthographicWidth = 12.5F;
    EXPECT_EQ(app::parseServerState(app::formatServerState(other, 60000)), other);
}

TEST(ServerState, LeavesNamesOutWhereThereIsNoRoom) {
    app::ServerState state = sample();
    state.lights.assign(1000, {true, "a light with a rather long name"});
    const std::string text = app::formatServerState(state, 20000);
    EXPECT_LE(text.size(), 20000U);
    const app::ServerState read = app::parseServerState(text);
    ASSERT_EQ(read.lights.size(), 1000U);
    EXPECT_TRUE(read.lights.back().on);
    EXPECT_EQ(read.lights.back().name, "");
    EXPECT_THROW(app::formatServerState(state, 1000), std::runtime_error);
}

TEST(ServerState, WhatIsNoUtf8IsShownAsBytes) {
    app::ServerState state = sample();
    state.lights[0].name = "l\xE4mp";
    EXPECT_EQ(app::parseServerState(app::formatServerState(state, 60000)).lights[0].name, "l\\xe4mp");
}

TEST(ServerState, OtherTextIsRefused) {
    for (const char* text :
         {"", "pong", "version = 1", "version = 2\nscene = \"a\"", "version = 1\nscene = 3"})
        EXPECT_THROW(app::parseServerState(text), rtcore::FileError) << text;
}

} // namespace
