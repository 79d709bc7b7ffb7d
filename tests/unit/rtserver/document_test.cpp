/// The document that is shown, and notes of its edits. Motion by itself: walk_test.cpp.
#include "shown_room.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

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

class DocumentTest : public test::ShownRoom {
  protected:
    /// The message of the error that the edit throws; "" when it does not.
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

TEST_F(DocumentTest, BeginsWithoutAScene) {
    const Document fresh(options, {}, messages);
    EXPECT_FALSE(fresh.ready());
    EXPECT_EQ(fresh.revisions().revision(), 0U);
}

TEST_F(DocumentTest, ShowsASceneAsItSays) {
    EXPECT_TRUE(document.ready());
    EXPECT_EQ(document.title(), "room.scn");
    EXPECT_EQ(document.camera(), test::makeRoom().camera);
    EXPECT_EQ(document.settings().width, 32);
    EXPECT_EQ(reserved, (std::vector{std::pair(32, 24)}));
    EXPECT_EQ(document.revisions().since(0), Changes::all());
}

TEST_F(DocumentTest, AnotherSceneChangesEverythingButTheSize) {
    const auto last = document.scene();
    document.setSettings(with(document.settings(), 64, 3));
    changes();
    rtcore::LoadedScene dark = test::makeRoom(0.1F);
    dark.camera.eye.x = 1;
    dark.live = {{"width", 100}, {"maxDepth", 7}};
    document.show(test::worldOf(std::move(dark)));
    EXPECT_EQ(changes(), Changes::all());
    EXPECT_EQ(document.camera().eye.x, 1);
    EXPECT_EQ(document.settings().width, 64);
    EXPECT_EQ(document.settings().maxDepth, 7);
    EXPECT_EQ(document.settings().antialiasing, 1) << "of the command line again";
    EXPECT_NE(document.scene(), last);
    EXPECT_EQ(last->materials.at(0).diffuse.r, 0.5F) << "lives on for those that hold it";
}

TEST_F(DocumentTest, ASceneThatCannotBeShownLeavesTheLast) {
    const auto last = document.scene();
    full = true;
    EXPECT_THROW(document.show(test::worldOf(test::makeRoom(0.1F))), rtcore::FileError);
    EXPECT_EQ(document.scene(), last);
    EXPECT_EQ(changes(), Changes{});
}

TEST_F(DocumentTest, AnEditPublishesAnotherSceneAndLeavesTheLastAsItWas) {
    const auto last = document.scene();
    switchLight(document, 1, false);
    EXPECT_NE(document.scene(), last);
    EXPECT_FALSE(lightIsOn(0));
    EXPECT_EQ(last->lights.at(0).light.on, 1U);
    EXPECT_EQ(document.world().loaded.scene.lights.at(0).light.on, 1U) << "as the files say";
    EXPECT_EQ(document.scene()->mesh().triangles.data(), last->mesh().triangles.data()) << "shared";
    EXPECT_EQ(document.scene()->environments, last->environments) << "shared";
}

TEST_F(DocumentTest, LightsAreSwitched) {
    switchLight(document, 2, std::nullopt);
    EXPECT_FALSE(lightIsOn(1));
    EXPECT_EQ(changes(), Changes{Change::Light});
    switchLight(document, 2, true);
    EXPECT_TRUE(lightIsOn(1));
    EXPECT_EQ(changes(), Changes{Change::Light});
    const auto last = document.scene();
    switchLight(document, 2, true);
    EXPECT_EQ(changes(), Changes{}) << "it was on";
    EXPECT_EQ(document.scene(), last);
}

TEST_F(DocumentTest, TheEnvironmentIsChosen) {
    setEnvironment(document, 1);
    EXPECT_EQ(environment(), 1);
    EXPECT_EQ(changes(), Changes{Change::Sky});
    setEnvironment(document, 1);
    EXPECT_EQ(changes(), Changes{});
}

TEST_F(DocumentTest, WhatTheSceneLacksIsRefused) {
    using Wrong = std::invalid_argument;
    EXPECT_EQ(refusal<Wrong>([&] { switchLight(document, 3, true); }),
              "there is no light 3; the scene has numbers 1 to 2");
    EXPECT_EQ(refusal<Wrong>([&] { switchLight(document, 0, true); }),
              "there is no light 0; the scene has numbers 1 to 2");
    EXPECT_EQ(refusal<Wrong>([&] { setEnvironment(document, 2); }),
              "there is no environment 3; the scene has numbers 1 to 2");
    EXPECT_EQ(changes(), Changes{});
}

TEST_F(DocumentTest, SettingsAreTakenOver) {
    document.setSettings(with(document.settings(), 32, 2));
    EXPECT_EQ(document.settings().antialiasing, 2);
    EXPECT_EQ(changes(), Changes{Change::Setting});
    EXPECT_EQ(reserved.size(), 1U) << "the size is the same";
    document.setSettings(with(document.settings(), 64, 2));
    EXPECT_EQ(reserved.back(), std::pair(64, 24));
    EXPECT_EQ(changes(), Changes{Change::Setting});
    document.setSettings(document.settings());
    EXPECT_EQ(changes(), Changes{});
}

TEST_F(DocumentTest, SettingsThatAreRefusedChangeNothing) {
    full = true;
    EXPECT_THROW(document.setSettings(with(document.settings(), 64, 2)), rtcore::FileError);
    EXPECT_THROW(document.assign({{"antialiasing", 2}, {"width", 64}}), rtcore::FileError);
    EXPECT_THROW(document.assign({{"antialiasing", 2}, {"width", -1}}), std::invalid_argument);
    EXPECT_EQ(document.settings().width, 32);
    EXPECT_EQ(document.settings().antialiasing, 1);
    EXPECT_EQ(changes(), Changes{});
}

TEST_F(DocumentTest, GoesBackWithoutAskingForRoom) {
    const rtcore::RenderSettings before = document.settings();
    document.setSettings(with(before, 64, 2));
    changes();
    full = true;
    document.goBackTo(before);
    EXPECT_EQ(document.settings().width, 32);
    EXPECT_EQ(changes(), Changes{Change::Setting});
}

TEST_F(DocumentTest, BloomIsAsStrongAsItWas) {
    document.assign({{"bloom.radius", 5}});
    changes();
    document.switchBloom(true);
    EXPECT_EQ(changes(), Changes{});
    document.switchBloom(false);
    EXPECT_EQ(document.settings().bloom.radius, 0);
    EXPECT_EQ(changes(), Changes{Change::Setting});
    document.switchBloom(true);
    EXPECT_EQ(document.settings().bloom.radius, 5);
}

TEST_F(DocumentTest, TheCameraIsSet) {
    rtcore::Camera camera = document.camera();
    document.setCamera(camera);
    EXPECT_EQ(changes(), Changes{});
    camera.eye.x = 1;
    document.setCamera(camera);
    EXPECT_EQ(document.camera(), camera);
    EXPECT_EQ(changes(), Changes{Change::View});
    walk.turn(90, 0);
    EXPECT_NEAR(document.camera().forward.x, 1, 1e-5);
    EXPECT_EQ(changes(), Changes{Change::View});
}

TEST_F(DocumentTest, ACameraThatSeesNothingIsRefused) {
    const rtcore::Camera good = document.camera();
    rtcore::Camera blind = good, skew = good, wide = good, narrow = good;
    blind.forward = {0, 0, 0};
    skew.up = good.forward;
    wide.horizontalFov = 180;
    narrow.kind = rtcore::CameraKind::Orthographic;
    for (const rtcore::Camera& camera : {blind, skew, wide, narrow})
        EXPECT_THROW(document.setCamera(camera), std::invalid_argument);
    EXPECT_EQ(document.camera(), good);
    EXPECT_EQ(changes(), Changes{});
}

TEST_F(DocumentTest, TheCameraOfAModelGetsAnotherUpWhereItIsTheDirectionToLookIn) {
    rtcore::LoadedScene loaded = test::makeRoom();
    loaded.camera.up = loaded.camera.forward;
    document.show(test::worldOf(std::move(loaded)));
    EXPECT_FALSE(rtcore::areParallel(document.camera().forward, document.camera().up));
    EXPECT_NO_THROW(document.setCamera(document.world().loaded.camera));
}

TEST_F(DocumentTest, ACamFileSaysMoreThanTheView) {
    rtcore::CameraFile file = test::cameraFileOf(document.camera());
    file.camera.eye.x = 1;
    file.width = 40;
    file.lights = {false, true};
    file.environment = 1;
    EXPECT_EQ(document.applyCameraFile(file, "a.cam").english(), "");
    EXPECT_EQ(changes(), (Changes{Change::View, Change::Light, Change::Sky, Change::Setting}));
    EXPECT_EQ(document.camera().eye.x, 1);
    EXPECT_EQ(document.settings().width, 40);
    EXPECT_EQ(document.settings().height, 24);
    EXPECT_FALSE(lightIsOn(0));
    EXPECT_EQ(environment(), 1);
    file.lights = {false, true, true};
    file.camera.eye.x = 2;
    EXPECT_EQ(document.applyCameraFile(file, "a.cam").english(),
              "a.cam switches 3 lights, but the scene has 2; these stay as they are");
    EXPECT_EQ(changes(), Changes{Change::View});
}

TEST_F(DocumentTest, ACamFileWithoutRoomForItsFramesChangesNothing) {
    const auto scene = document.scene();
    rtcore::CameraFile file = test::cameraFileOf(document.camera());
    file.camera.eye.x = 1;
    file.width = 40;
    file.lights = {false, true};
    full = true;
    EXPECT_THROW(document.applyCameraFile(file, "a.cam").english(), rtcore::FileError);
    EXPECT_EQ(document.scene(), scene);
    EXPECT_EQ(document.settings().width, 32);
    EXPECT_EQ(document.camera().eye.x, 0);
    EXPECT_EQ(changes(), Changes{});
}

/// Notes what it is told.
class Follower final : public DocumentFollower {
  public:
    void sceneOpened() override { told.push_back("opened"); }
    void sceneEdited(const rtcore::Scene& before, const Changes& changes) override {
        told.push_back("edited");
        lights = before.lights.size();
        kinds = changes;
    }
    void treeReplaced() override { told.push_back("tree"); }
    void unitsChanged() override { told.push_back("units"); }
    void cameraPlaced() override { told.push_back("camera"); }

    std::vector<std::string> told;
    std::size_t lights = 0;
    Changes kinds;
};

TEST_F(DocumentTest, TellsItsFollowerOfEditsWhenTheyAreDone) {
    Document other(
        options, [](const rtcore::RenderSettings&) {}, messages);
    Follower follower;
    other.setFollower(&follower);
    other.show(test::worldOf(test::makeRoom()));
    removeLight(other, 2);
    EXPECT_EQ(follower.lights, 2U) << "before it";
    EXPECT_EQ(follower.kinds, Changes{Change::Light});
    const rtcore::Camera camera = other.camera();
    other.setCamera(camera);
    other.moveCamera(camera);
    other.setModelUnits(std::nullopt, 0.01);
    other.setModelUnits(std::nullopt, 0.01);
    other.useTree(other.world().loaded.tree, other.world().tracer);
    other.switchBloom(true);
    const std::vector<std::string> expected{"opened", "edited", "camera", "units", "tree"};
    EXPECT_EQ(follower.told, expected);
}

TEST_F(DocumentTest, IsEditedWithoutAFollower) {
    Document other(
        options, [](const rtcore::RenderSettings&) {}, messages);
    other.show(test::worldOf(test::makeRoom()));
    const Snapshot before = other.snapshot();
    hideParts(other, std::make_shared<const std::vector<std::uint8_t>>(1, 1));
    EXPECT_TRUE(other.visible().pruned());
    other.keepStep("part hide", before);
    EXPECT_EQ(other.undo(), "part hide");
    EXPECT_FALSE(other.visible().pruned());
    EXPECT_EQ(other.tracer(), other.world().tracer);
}

TEST_F(DocumentTest, AGestureThatComesBackToWhereItBeganLeavesNoStep) {
    const auto cutAt = [&](float height, bool goesOn) {
        const Snapshot before = document.snapshot();
        rtcore::SectionPlanes sections;
        sections.planes = {{{0, height, 0}, {0, 1, 0}}};
        cutOpen(document, sections);
        document.keepStep("section plane 1", before, {}, goesOn);
    };
    cutAt(0.5F, false);
    const std::uint64_t begun = document.history().state();
    cutAt(0.6F, false);
    cutAt(0.7F, true);
    EXPECT_NE(document.history().state(), begun);
    cutAt(0.5F, true);
    EXPECT_EQ(document.history().state(), begun);
    document.undo();
    EXPECT_TRUE(document.scene()->sections.empty()) << "the step before";
    EXPECT_EQ(document.history().last(), nullptr);
}

TEST_F(DocumentTest, HasThePlayedExposureInFramesAlone) {
    document.setPlayedExposure(3);
    EXPECT_EQ(changes(), Changes{Change::Setting});
    EXPECT_EQ(document.frameSettings().exposure.mode, rtcore::ExposureMode::Fixed);
    EXPECT_EQ(document.frameSettings().exposure.value, 3.0F);
    EXPECT_EQ(document.settings().exposure.mode, rtcore::ExposureMode::Automatic);
    document.setPlayedExposure(3);
    EXPECT_EQ(changes(), Changes{});
    document.setPlayedExposure(std::nullopt);
    EXPECT_EQ(changes(), Changes{Change::Setting});
    EXPECT_EQ(document.frameSettings(), document.settings());
}

TEST_F(DocumentTest, AnotherTreeChangesNoFrame) {
    rtcore::LoadedScene same = test::makeRoom();
    const auto tracer = std::make_shared<const rtcore::KdRayTracer>(same.tree, document.scene()->mesh());
    document.useTree(same.tree, tracer);
    EXPECT_EQ(document.world().tracer, tracer);
    EXPECT_EQ(changes(), Changes{});
}

} // namespace
} // namespace rtserver
