#include "common/settings/settings_merge.h"

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
    EXPECT_EQ(settings.height, 4) << "in the aspect of the camera";
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
    EXPECT_EQ(app::applyCameraToScene(camera, "x.cam", scene).english(), "");
    EXPECT_EQ(scene.lights[0].light.on, 0U);
    EXPECT_EQ(scene.lights[1].light.on, 1U);
    EXPECT_EQ(scene.lights[2].light.on, 1U);
    camera.lights->resize(4);
    EXPECT_EQ(app::applyCameraToScene(camera, "x.cam", scene).english(),
              "x.cam switches 4 lights, but the scene has 3; these stay as they are");
    EXPECT_EQ(scene.lights[0].light.on, 0U);
    EXPECT_EQ(scene.lights[1].light.on, 1U);
}

TEST(SettingsMerge, ACameraSwitchesLightsByTheirIds) {
    rtcore::Scene scene;
    for (const int id : {7, 2, 5}) scene.lights.emplace_back().notes.id = id;
    rtcore::CameraFile camera;
    camera.lightsOff = {7, 2};
    EXPECT_EQ(app::applyCameraToScene(camera, "x.cam", scene).english(), "");
    EXPECT_EQ(scene.lights[0].light.on, 0U);
    EXPECT_EQ(scene.lights[1].light.on, 0U);
    EXPECT_EQ(scene.lights[2].light.on, 1U);
    camera.lightsOn = {9, 2};
    camera.lightsOff = {1, 5};
    EXPECT_EQ(app::applyCameraToScene(camera, "x.cam", scene).english(),
              "x.cam names lights that the scene lacks (9, 1); these stay as they are");
    EXPECT_EQ(scene.lights[1].light.on, 1U);
    EXPECT_EQ(scene.lights[2].light.on, 0U);
}

TEST(SettingsMerge, ACameraPicksAnEnvironmentThatExists) {
    rtcore::Scene scene;
    rtcore::CameraFile camera;
    camera.environment = 0;
    EXPECT_EQ(app::applyCameraToScene(camera, "x.cam", scene).english(), "");
    camera.environment = 1;
    camera.lights = std::vector<bool>{true};
    EXPECT_EQ(
        app::applyCameraToScene(camera, "x.cam", scene).english(),
        "x.cam switches 1 light, but the scene has 0 and asks for environment 1 (counted from 0), but the "
        "scene has 0; these stay as they are");
    EXPECT_EQ(scene.activeEnvironment, 0);
}

TEST(SettingsMerge, OneSideAloneKeepsTheAspect) {
    const auto sizeOf = [](const Assignments& scene, const rtcore::CameraFile* camera,
                           const Assignments& line) {
        const rtcore::RenderSettings settings =
            app::mergeSettings({.scene = scene, .camera = camera, .commandLine = line});
        return std::pair(settings.width, settings.height);
    };
    EXPECT_EQ(sizeOf({}, nullptr, {{"width", 800}}), std::pair(800, 600)) << "that of the default";
    EXPECT_EQ(sizeOf({}, nullptr, {{"height", 240}}), std::pair(320, 240));
    EXPECT_EQ(sizeOf({}, nullptr, {{"width", 7}, {"height", 9}}), std::pair(7, 9));
    const Assignments scene{{"width", 1920}, {"height", 1080}};
    EXPECT_EQ(sizeOf(scene, nullptr, {{"width", 1280}}), std::pair(1280, 720));
    EXPECT_EQ(sizeOf({{"width", 1920}}, nullptr, {}), std::pair(1920, 480)) << "files say what they mean";
    rtcore::CameraFile camera;
    camera.width = 100;
    camera.height = 400;
    EXPECT_EQ(sizeOf(scene, &camera, {{"height", 200}}), std::pair(50, 200));
    camera.height = 32768;
    EXPECT_EQ(sizeOf(scene, &camera, {{"height", 10}}), std::pair(1, 10));
    EXPECT_EQ(sizeOf(scene, &camera, {{"width", 32768}}), std::pair(32768, 32768)) << "the most there can be";
}

} // namespace
