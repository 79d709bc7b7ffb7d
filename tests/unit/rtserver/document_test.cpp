/// What is shown, and how its edits are noted. What moves by itself: walk_test.cpp.
#include "shown_room.h"

#include <gtest/gtest.h>

#include <stdexcept>

namespace rtserver {
namespace {

using rtcore::Change;
using rtcore::Changes;

rtcore::RenderSettings with(const rtcore::RenderSettings& settings, int width, int antialiasing) {
    rtcore::RenderSettings changed = settings;
    changed.width = width;
    changed.antialiasing = antialiasing;
    return changed;
}

class ServerStateTest : public test::ShownRoom {
  protected:
    /// What the edit throws; "" when it does not.
    template <typename Error, typename Edit>
    static std::string refusal(Edit&& edit) {
        try {
            edit();
        } catch (const Error& error) {
            return error.what();
        }
        return "";
    }
};

TEST_F(ServerStateTest, BeginsWithoutAScene) {
    const ServerState fresh(options, {}, messages);
    EXPECT_FALSE(fresh.ready());
    EXPECT_EQ(fresh.revisions().revision(), 0U);
}

TEST_F(ServerStateTest, ShowsASceneAsItSays) {
    EXPECT_TRUE(state.ready());
    EXPECT_EQ(state.title(), "room.scn");
    EXPECT_EQ(state.camera(), test::makeRoom().camera);
    EXPECT_EQ(state.settings().width, 32);
    EXPECT_EQ(reserved, (std::vector{std::pair(32, 24)}));
    EXPECT_EQ(state.revisions().since(0), Changes::all());
}

TEST_F(ServerStateTest, AnotherSceneChangesEverythingButTheSize) {
    const auto last = state.scene();
    state.setSettings(with(state.settings(), 64, 3));
    changes();
    rtcore::LoadedScene dark = test::makeRoom(0.1F);
    dark.camera.eye.x = 1;
    dark.live = {{"width", 100}, {"maxDepth", 7}};
    state.show(test::worldOf(std::move(dark)));
    EXPECT_EQ(changes(), Changes::all());
    EXPECT_EQ(state.camera().eye.x, 1);
    EXPECT_EQ(state.settings().width, 64);
    EXPECT_EQ(state.settings().maxDepth, 7);
    EXPECT_EQ(state.settings().antialiasing, 1) << "of the command line again";
    EXPECT_NE(state.scene(), last);
    EXPECT_EQ(last->materials.at(0).diffuse.r, 0.5F) << "lives on for those that hold it";
}

TEST_F(ServerStateTest, ASceneThatCannotBeShownLeavesTheLast) {
    const auto last = state.scene();
    full = true;
    EXPECT_THROW(state.show(test::worldOf(test::makeRoom(0.1F))), rtcore::FileError);
    EXPECT_EQ(state.scene(), last);
    EXPECT_EQ(changes(), Changes{});
}

TEST_F(ServerStateTest, AnEditPublishesAnotherSceneAndLeavesTheLastAsItWas) {
    const auto last = state.scene();
    state.switchLight(1, false);
    EXPECT_NE(state.scene(), last);
    EXPECT_FALSE(lightIsOn(0));
    EXPECT_EQ(last->lights.at(0).light.on, 1U);
    EXPECT_EQ(state.world().loaded.scene.lights.at(0).light.on, 1U) << "as the files say";
    EXPECT_EQ(state.scene()->mesh().triangles.data(), last->mesh().triangles.data()) << "shared";
    EXPECT_EQ(state.scene()->environments, last->environments) << "shared";
}

TEST_F(ServerStateTest, LightsAreSwitched) {
    state.switchLight(2, std::nullopt);
    EXPECT_FALSE(lightIsOn(1));
    EXPECT_EQ(changes(), Changes{Change::Light});
    state.switchLight(2, true);
    EXPECT_TRUE(lightIsOn(1));
    EXPECT_EQ(changes(), Changes{Change::Light});
    const auto last = state.scene();
    state.switchLight(2, true);
    EXPECT_EQ(changes(), Changes{}) << "it was on";
    EXPECT_EQ(state.scene(), last);
}

TEST_F(ServerStateTest, TheEnvironmentIsChosen) {
    state.setEnvironment(1);
    EXPECT_EQ(environment(), 1);
    EXPECT_EQ(changes(), Changes{Change::Sky});
    state.setEnvironment(1);
    EXPECT_EQ(changes(), Changes{});
}

TEST_F(ServerStateTest, WhatTheSceneLacksIsRefused) {
    using Wrong = std::invalid_argument;
    EXPECT_EQ(refusal<Wrong>([&] { state.switchLight(3, true); }),
              "there is no light 3; the scene has numbers 1 to 2");
    EXPECT_EQ(refusal<Wrong>([&] { state.switchLight(0, true); }),
              "there is no light 0; the scene has numbers 1 to 2");
    EXPECT_EQ(refusal<Wrong>([&] { state.setEnvironment(2); }),
              "there is no environment 3; the scene has numbers 1 to 2");
    EXPECT_EQ(changes(), Changes{});
}

TEST_F(ServerStateTest, SettingsAreTakenOver) {
    state.setSettings(with(state.settings(), 32, 2));
    EXPECT_EQ(state.settings().antialiasing, 2);
    EXPECT_EQ(changes(), Changes{Change::Setting});
    EXPECT_EQ(reserved.size(), 1U) << "the size is the same";
    state.setSettings(with(state.settings(), 64, 2));
    EXPECT_EQ(reserved.back(), std::pair(64, 24));
    EXPECT_EQ(changes(), Changes{Change::Setting});
    state.setSettings(state.settings());
    EXPECT_EQ(changes(), Changes{});
}

TEST_F(ServerStateTest, SettingsThatAreRefusedChangeNothing) {
    full = true;
    EXPECT_THROW(state.setSettings(with(state.settings(), 64, 2)), rtcore::FileError);
    EXPECT_THROW(state.assign({{"antialiasing", 2}, {"width", 64}}), rtcore::FileError);
    EXPECT_THROW(state.assign({{"antialiasing", 2}, {"width", -1}}), std::invalid_argument);
    EXPECT_EQ(state.settings().width, 32);
    EXPECT_EQ(state.settings().antialiasing, 1);
    EXPECT_EQ(changes(), Changes{});
}

TEST_F(ServerStateTest, GoesBackWithoutAskingForRoom) {
    const rtcore::RenderSettings before = state.settings();
    state.setSettings(with(before, 64, 2));
    changes();
    full = true;
    state.goBackTo(before);
    EXPECT_EQ(state.settings().width, 32);
    EXPECT_EQ(changes(), Changes{Change::Setting});
}

TEST_F(ServerStateTest, BloomIsAsStrongAsItWas) {
    state.assign({{"bloom.radius", 5}});
    changes();
    state.switchBloom(true);
    EXPECT_EQ(changes(), Changes{});
    state.switchBloom(false);
    EXPECT_EQ(state.settings().bloom.radius, 0);
    EXPECT_EQ(changes(), Changes{Change::Setting});
    state.switchBloom(true);
    EXPECT_EQ(state.settings().bloom.radius, 5);
}

TEST_F(ServerStateTest, TheCameraIsSet) {
    rtcore::Camera camera = state.camera();
    state.setCamera(camera);
    EXPECT_EQ(changes(), Changes{});
    camera.eye.x = 1;
    state.setCamera(camera);
    EXPECT_EQ(state.camera(), camera);
    EXPECT_EQ(changes(), Changes{Change::View});
    state.turn(90, 0);
    EXPECT_NEAR(state.camera().forward.x, 1, 1e-5);
    EXPECT_EQ(changes(), Changes{Change::View});
}

TEST_F(ServerStateTest, ACameraThatSeesNothingIsRefused) {
    const rtcore::Camera good = state.camera();
    rtcore::Camera blind = good, skew = good, wide = good, narrow = good;
    blind.forward = {0, 0, 0};
    skew.up = good.forward;
    wide.horizontalFov = 180;
    narrow.kind = rtcore::CameraKind::Orthographic;
    for (const rtcore::Camera& camera : {blind, skew, wide, narrow})
        EXPECT_THROW(state.setCamera(camera), std::invalid_argument);
    EXPECT_EQ(state.camera(), good);
    EXPECT_EQ(changes(), Changes{});
}

TEST_F(ServerStateTest, TheCameraOfAModelGetsAnotherUpWhereItIsTheDirectionToLookIn) {
    rtcore::LoadedScene loaded = test::makeRoom();
    loaded.camera.up = loaded.camera.forward;
    state.show(test::worldOf(std::move(loaded)));
    EXPECT_FALSE(rtcore::areParallel(state.camera().forward, state.camera().up));
    EXPECT_NO_THROW(state.setCamera(state.world().loaded.camera));
}

TEST_F(ServerStateTest, ACamFileSaysMoreThanTheView) {
    rtcore::CameraFile file = test::cameraFileOf(state.camera());
    file.camera.eye.x = 1;
    file.width = 40;
    file.lights = {false, true};
    file.environment = 1;
    EXPECT_EQ(state.applyCameraFile(file, "a.cam"), "");
    EXPECT_EQ(changes(), (Changes{Change::View, Change::Light, Change::Sky, Change::Setting}));
    EXPECT_EQ(state.camera().eye.x, 1);
    EXPECT_EQ(state.settings().width, 40);
    EXPECT_EQ(state.settings().height, 24);
    EXPECT_FALSE(lightIsOn(0));
    EXPECT_EQ(environment(), 1);
    file.lights = {false, true, true};
    file.camera.eye.x = 2;
    EXPECT_EQ(state.applyCameraFile(file, "a.cam"),
              "a.cam switches 3 lights, but the scene has 2; these stay as they are");
    EXPECT_EQ(changes(), Changes{Change::View});
}

TEST_F(ServerStateTest, ACamFileWithoutRoomForItsFramesChangesNothing) {
    const auto scene = state.scene();
    rtcore::CameraFile file = test::cameraFileOf(state.camera());
    file.camera.eye.x = 1;
    file.width = 40;
    file.lights = {false, true};
    full = true;
    EXPECT_THROW(state.applyCameraFile(file, "a.cam"), rtcore::FileError);
    EXPECT_EQ(state.scene(), scene);
    EXPECT_EQ(state.settings().width, 32);
    EXPECT_EQ(state.camera().eye.x, 0);
    EXPECT_EQ(changes(), Changes{});
}

TEST_F(ServerStateTest, AnotherTreeChangesNoFrame) {
    rtcore::LoadedScene same = test::makeRoom();
    const auto tracer = std::make_shared<const rtcore::KdRayTracer>(same.tree, state.scene()->mesh());
    state.useTree(same.tree, tracer);
    EXPECT_EQ(state.world().tracer, tracer);
    EXPECT_EQ(changes(), Changes{});
}

} // namespace
} // namespace rtserver
