#include "rtcore/sky/scene_sky.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>

namespace {

using rtcore::Colour;
using rtcore::Environment;
using rtcore::Scene;
using rtcore::Sky;
using rtcore::TexelFilter;
using rtcore::Vec3;

/// Bright ahead (-z), dark elsewhere.
Environment brightAhead() {
    rtcore::HdrImage image(64, 32, {0.1F, 0.1F, 0.1F});
    for (int y = 10; y < 22; ++y)
        for (int x = 26; x < 38; ++x) image.at(x, y) = {9, 8, 7};
    return Environment::fromEquirectangular(image, "spot");
}

Scene litScene() {
    Scene scene;
    scene.lights = {{{}, "left"}};
    addEnvironment(scene, {.files = {"spot.hdr"}, .parts = {}, .name = "spot"}, brightAhead());
    return scene;
}

std::vector<std::string> namesOf(const Scene& scene) {
    std::vector<std::string> names;
    for (const rtcore::SceneLight& each : scene.lights) names.push_back(each.name);
    return names;
}

TEST(SceneSky, TurnsAnEnvironmentAndItsLightAlike) {
    Scene scene = litScene();
    const auto before = scene.environments[0];
    setEnvironmentRotation(scene, 0, 90);
    const Environment& turned = *scene.environments[0];
    const Vec3 right{1, 0, 0}, ahead{0, 0, -1};
    EXPECT_GT(turned.radiance(right, TexelFilter::Bilinear).r, 8);
    EXPECT_LT(turned.radiance(ahead, TexelFilter::Bilinear).r, 0.2F);
    EXPECT_GT(before->radiance(ahead, TexelFilter::Bilinear).r, 8) << "copies of scenes share it";
    EXPECT_NEAR(turned.light().open(right).r / before->light().open(ahead).r, 1, 0.02F);
    EXPECT_LT(turned.light().open({-1, 0, 0}).r, 0.5F * turned.light().open(right).r);
    EXPECT_EQ(scene.environmentFiles[0].rotation, 90);
    setEnvironmentRotation(scene, 0, 0);
    EXPECT_EQ(scene.environments[0]->radiance(right, TexelFilter::Nearest),
              before->radiance(right, TexelFilter::Nearest));
}

TEST(SceneSky, RotationIsAboutTheUpAxis) {
    Scene scene = litScene();
    setEnvironmentRotation(scene, 0, 30);
    scene.up = {0, 0, 1};
    straightenSky(scene);
    EXPECT_GT(scene.environments[0]->radiance({0, 0, -1}, TexelFilter::Bilinear).r, 8);
}

TEST(SceneSky, OfAStudioHasNoSun) {
    Scene scene = litScene();
    setSky(scene, Sky{.studio = true});
    EXPECT_EQ(scene.environments.size(), 2U);
    EXPECT_FALSE(sunOf(scene));
    EXPECT_FALSE(isSunEdited(scene));
    setSky(scene, Sky{});
    ASSERT_EQ(sunOf(scene), 1U) << "the sun rises with the sky";
    setSky(scene, Sky{.studio = true});
    EXPECT_EQ(namesOf(scene), std::vector<std::string>{"left"});
    setSky(scene, Sky{});
    rtcore::eraseLight(scene, *sunOf(scene));
    setSky(scene, Sky{.turbidity = 5});
    EXPECT_FALSE(sunOf(scene)) << "one that was taken away stays away";
}

TEST(SceneSky, ComesAndGoesWithItsLight) {
    Scene scene = litScene();
    setSky(scene, Sky{});
    ASSERT_EQ(scene.environments.size(), 2U);
    EXPECT_EQ(skyEnvironmentOf(scene), 1U);
    EXPECT_EQ(scene.activeEnvironment, 1);
    ASSERT_EQ(sunOf(scene), 1U);
    EXPECT_EQ(scene.lights[1].name, "sun");
    scene.lights[1].light.on = 0;
    Sky evening;
    evening.date->second = 18 * 3600;
    const Vec3 noon = scene.lights[1].light.direction;
    setSky(scene, evening);
    EXPECT_EQ(scene.lights.size(), 2U);
    EXPECT_NE(scene.lights[1].light.direction, noon);
    EXPECT_EQ(scene.lights[1].light.on, 0U) << "stays switched off";
    EXPECT_EQ(addEnvironment(scene, {.files = {"b.hdr"}, .parts = {}, .name = "b"}, brightAhead()), 1U);
    EXPECT_EQ(scene.activeEnvironment, 2) << "still the sky";
    setSky(scene, std::nullopt);
    EXPECT_EQ(scene.environments.size(), 2U);
    EXPECT_EQ(namesOf(scene), std::vector<std::string>{"left"});
    EXPECT_EQ(scene.activeEnvironment, 0);
    EXPECT_FALSE(sunOf(scene));
}

TEST(SceneSky, LeavesOtherLightsAloneThatAreCalledSun) {
    Scene scene = litScene();
    rtcore::Light own;
    own.kind = rtcore::LightKind::Directional;
    scene.lights.emplace_back(own, "sun");
    setSky(scene, Sky{});
    ASSERT_EQ(sunOf(scene), 2U);
    rtcore::eraseLight(scene, 2);
    Sky evening;
    evening.date->second = 18 * 3600;
    setSky(scene, evening);
    EXPECT_FALSE(sunOf(scene));
    EXPECT_FALSE(isSunEdited(scene));
    EXPECT_EQ(scene.lights[1].light, own);
    setSky(scene, std::nullopt);
    EXPECT_EQ(namesOf(scene), (std::vector<std::string>{"left", "sun"}));
    setSky(scene, Sky{});
    EXPECT_EQ(sunOf(scene), 2U) << "a new sky brings its own";
    setSky(scene, std::nullopt);
    EXPECT_EQ(scene.lights[1].light, own);
}

TEST(SceneSky, ASunThatWasTakenAwayStaysAway) {
    Scene scene = litScene();
    setSky(scene, Sky{});
    scene.lights.pop_back();
    setSky(scene, Sky{.turbidity = 5});
    EXPECT_EQ(scene.lights.size(), 1U);
    setSky(scene, std::nullopt);
    EXPECT_EQ(namesOf(scene), std::vector<std::string>{"left"});
}

} // namespace
