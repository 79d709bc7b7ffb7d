#include "common/settings_merge.h"

#include "rtcore/platform/error.h"

#include <gtest/gtest.h>

namespace {

using Assignments = std::vector<rtcore::SettingAssignment>;

TEST(SettingsMerge, EachPlaceBeatsTheOneBefore) {
    const Assignments scene{{"width", 1}, {"height", 1}, {"antialiasing", 2}, {"maxDepth", 3}};
    const Assignments file{{"width", 2}, {"height", 2}, {"antialiasing", 3}};
    rtcore::CameraFile camera;
    camera.width = 3;
    camera.height = 3;
    const Assignments commandLine{{"width", 4}};
    const rtcore::RenderSettings settings = app::mergeSettings(
        {.scene = scene, .settingsFile = file, .camera = &camera, .commandLine = commandLine});
    EXPECT_EQ(settings.width, 4);
    EXPECT_EQ(settings.height, 3);
    EXPECT_EQ(settings.antialiasing, 3);
    EXPECT_EQ(settings.maxDepth, 3);
    EXPECT_EQ(settings.shadows, rtcore::RenderSettings().shadows);
}

TEST(SettingsMerge, AnExposureOfTheCameraIsFixed) {
    rtcore::CameraFile camera;
    camera.exposure = 0.42F;
    const Assignments scene{{"exposure.mode", std::string("automatic")}};
    rtcore::RenderSettings settings = app::mergeSettings({.scene = scene, .camera = &camera});
    EXPECT_EQ(settings.exposure.mode, rtcore::ExposureMode::Fixed);
    EXPECT_EQ(settings.exposure.value, 0.42F);
    camera.exposure.reset();
    settings = app::mergeSettings({.scene = scene, .camera = &camera});
    EXPECT_EQ(settings.exposure.mode, rtcore::ExposureMode::Automatic);
}

TEST(SettingsMerge, ACameraSwitchesLights) {
    rtcore::Scene scene;
    scene.lights.resize(3);
    rtcore::CameraFile camera;
    camera.lights = std::vector<bool>{false, true};
    app::applyCameraToScene(camera, "x.cam", scene);
    EXPECT_EQ(scene.lights[0].on, 0U);
    EXPECT_EQ(scene.lights[1].on, 1U);
    EXPECT_EQ(scene.lights[2].on, 1U);
    camera.lights->resize(4);
    EXPECT_THROW(app::applyCameraToScene(camera, "x.cam", scene), rtcore::FileError);
}

TEST(SettingsMerge, ACameraPicksAnEnvironmentThatExists) {
    rtcore::Scene scene;
    rtcore::CameraFile camera;
    camera.environment = 0;
    EXPECT_NO_THROW(app::applyCameraToScene(camera, "x.cam", scene));
    camera.environment = 1;
    EXPECT_THROW(app::applyCameraToScene(camera, "x.cam", scene), rtcore::FileError);
}

} // namespace
