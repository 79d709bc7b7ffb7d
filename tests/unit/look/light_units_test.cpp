#include "rtcore/look/light_units.h"

#include "rtcore/look/lighting_preset.h"
#include "rtcore/sky/scene_sky.h"
#include "rtcore/sky/sky_light.h"

#include "support/rooms.h"

#include <gtest/gtest.h>

#include <string>
#include <utility>

namespace {

using rtcore::Scene;

/// A block without light.
Scene dark() {
    test::SceneBuilder b = test::block();
    Scene scene = b.finish();
    scene.ambient = scene.background = {};
    scene.lights.clear();
    return scene;
}

Scene underSky() {
    Scene scene = dark();
    rtcore::setSky(scene, rtcore::Sky{});
    return scene;
}

std::string told(const Scene& scene) {
    const rtcore::UnitlessLight light = unitlessLight(scene, {});
    std::string text = light.all ? "all:" : "";
    for (const rtcore::Sentence& each : light.what) text += ' ' + each.english() + ';';
    return text;
}

TEST(LightByUnit, SkyAndLightsAreApart) {
    Scene scene = underSky();
    scene.lights.insert(scene.lights.begin(), {test::pointLight({0, 5, 0}, 10), "bulb"});
    scene.materials[0].emission = {1, 1, 1};
    scene.fog.emission = {1, 0, 0};
    const rtcore::LightByUnit light = lightByUnit(scene);
    ASSERT_TRUE(light.sky && light.rest);
    EXPECT_EQ(light.sky->luminanceOfOne, rtcore::kLuminanceOfOne);
    EXPECT_EQ(light.rest->luminanceOfOne, 683);
    ASSERT_EQ(light.sky->scene.lights.size(), 1U);
    EXPECT_EQ(light.sky->scene.lights[0].name, "sun");
    EXPECT_EQ(light.sky->scene.environment(), scene.environment());
    EXPECT_TRUE(isBlack(light.sky->scene.materials[0].emission));
    EXPECT_TRUE(isBlack(light.sky->scene.fog.emission));
    ASSERT_EQ(light.rest->scene.lights.size(), 1U);
    EXPECT_EQ(light.rest->scene.lights[0].name, "bulb");
    EXPECT_EQ(light.rest->scene.environment(), nullptr);
    EXPECT_FALSE(isBlack(light.rest->scene.materials[0].emission));
    EXPECT_FALSE(isBlack(light.rest->scene.fog.emission));
}

TEST(LightByUnit, WhatIsNotThereIsNoPart) {
    EXPECT_FALSE(lightByUnit(dark()).sky);
    EXPECT_FALSE(lightByUnit(dark()).rest);
    Scene sky = underSky();
    sky.ambient = {1, 1, 1}; // the sky takes its place
    EXPECT_TRUE(lightByUnit(sky).sky);
    EXPECT_FALSE(lightByUnit(sky).rest);
    Scene studio = dark();
    rtcore::setSky(studio, rtcore::Sky{.studio = true});
    EXPECT_FALSE(lightByUnit(studio).sky);
    EXPECT_TRUE(lightByUnit(studio).rest);
}

TEST(LightByUnit, TheSunShinesBesideAnotherEnvironment) {
    Scene scene = underSky();
    scene.activeEnvironment = rtcore::kNoEnvironment;
    scene.ambient = {1, 1, 1};
    const rtcore::LightByUnit light = lightByUnit(scene);
    ASSERT_TRUE(light.sky && light.rest);
    EXPECT_EQ(light.sky->scene.environment(), nullptr);
    EXPECT_TRUE(isBlack(light.sky->scene.ambient));
    EXPECT_FALSE(isBlack(light.rest->scene.ambient));
    EXPECT_TRUE(light.rest->scene.lights.empty());
}

TEST(UnitOfSky, DimsAllOtherLight) {
    Scene scene = underSky();
    scene.lights.push_back({test::pointLight({0, 5, 0}, 10), "bulb"});
    scene.materials[0].emission = {2, 2, 2};
    const auto one = inUnitOfSky(scene);
    ASSERT_TRUE(one);
    constexpr float kFactor = 683.0F / rtcore::kLuminanceOfOne;
    EXPECT_EQ(one->lights[0].light.intensity, scene.lights[0].light.intensity) << "the sun's";
    EXPECT_FLOAT_EQ(one->lights[1].light.intensity.r, kFactor * scene.lights[1].light.intensity.r);
    EXPECT_FLOAT_EQ(one->materials[0].emission.g, kFactor * 2);
    EXPECT_EQ(one->environment(), scene.environment());
    EXPECT_FALSE(inUnitOfSky(underSky()));
    EXPECT_FALSE(inUnitOfSky(dark()));
}

TEST(UnitOfImages, IsThatOfTheSkyOrOfLights) {
    Scene scene = dark();
    scene.lights = {{test::pointLight({0, 5, 0}, 10), "bulb"}};
    EXPECT_EQ(unitOfImages(scene, {}), (rtcore::LuminanceUnit{.ofOne = 683, .absolute = true}));
    EXPECT_TRUE(unitWarning(unitlessLight(scene, {})).empty());
    scene.background = {1, 1, 1};
    EXPECT_TRUE(unitOfImages(scene, {}).absolute) << "of the bulb";
    EXPECT_EQ(
        unitWarning(unitlessLight(scene, {})).english(),
        "some of the light of this scene has no absolute unit (the background), so that false colours are "
        "true of the rest alone");
    scene.lights.clear();
    EXPECT_FALSE(unitOfImages(scene, {}).absolute);
    EXPECT_EQ(unitOfImages(underSky(), {}),
              (rtcore::LuminanceUnit{.ofOne = rtcore::kLuminanceOfOne, .absolute = true}));
}

TEST(UnitlessLight, IsToldByWhatThereIs) {
    EXPECT_EQ(told(dark()), "");
    EXPECT_EQ(told(underSky()), "");
    Scene scene = dark();
    scene.ambient = {0.1F, 0.1F, 0.1F};
    EXPECT_EQ(told(scene), "all: ambient light;");
    scene.background = {1, 1, 1};
    EXPECT_EQ(told(scene), "all: the background;");
    scene.lights = {{test::pointLight({0, 5, 0}, 10), "bulb"}};
    EXPECT_EQ(told(scene), " the background;");
    scene.lights[0].name = rtcore::kHeadlightName;
    EXPECT_EQ(told(scene), "all: lights of a look; the background;");
    scene.lights[0].light.on = 0;
    EXPECT_EQ(told(scene), "all: the background;");
    scene.environments = {std::make_shared<const rtcore::Environment>(
        rtcore::Environment::fromEquirectangular(rtcore::HdrImage(4, 2, {1, 1, 1}), "noon"))};
    EXPECT_EQ(told(scene), "all: the environment noon;");
    EXPECT_EQ(told(scene), "all: the environment noon;") << "there is no fog";
    scene.fog.kind = rtcore::FogKind::Homogeneous;
    scene.fog.density = 0.1F;
    EXPECT_EQ(told(scene), "all: the environment noon; fog;");
}

TEST(UnitlessLight, OfTheModelsFile) {
    test::SceneBuilder b = test::block();
    const std::uint32_t tube = b.material(test::emitter({1, 1, 1}));
    b.material(test::emitter({3, 3, 3})); // of no surface
    b.square({0, 3, 0}, {0, -1, 0}, 0.1F, tube);
    b.buffers.lights = {test::pointLight({1, 2, 3}, 4)};
    Scene scene = b.finish();
    scene.ambient = scene.background = {};
    scene.lights = {{scene.model.lights[0], "Light.001"}};
    EXPECT_EQ(told(scene),
              "all: lights as the model's file brought them; surfaces that emit as the model's file says;");
    scene.lights[0].light.intensity = {5, 5, 5};
    EXPECT_EQ(told(scene), " surfaces that emit as the model's file says;");
    scene.materials[tube].emission = {2, 2, 2};
    EXPECT_EQ(told(scene), "");
}

TEST(UnitlessLight, OfASkyThatIsNotNatures) {
    Scene scene = dark();
    rtcore::setSky(scene, rtcore::Sky{.strength = 2});
    EXPECT_EQ(told(scene), " a sky of another strength than 1;");
    scene.lights[0].light.intensity = {1, 1, 1};
    EXPECT_EQ(told(scene), " a sky of another strength than 1; a sun that was edited;");
    rtcore::setSky(scene, rtcore::Sky{.studio = true});
    EXPECT_EQ(told(scene), "all: the environment studio;");
}

TEST(PresetLights, AreKnownByTheirNames) {
    for (const char* name : {"default", "ceiling 2", "key", "fill", "rim"})
        EXPECT_TRUE(rtcore::isPresetLightName(name)) << name;
    for (const char* name : {"", "desk", "key light", "sun"})
        EXPECT_FALSE(rtcore::isPresetLightName(name)) << name;
}

} // namespace
