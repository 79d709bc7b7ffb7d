#include "rtcore/look/lighting_preset.h"

#include "support/rooms.h"

#include "rtcore/math/constants.h"
#include "rtcore/sky/scene_sky.h"
#include "rtcore/survey/default_view.h"

#include <gtest/gtest.h>

#include <cmath>
#include <utility>
#include <variant>

namespace {

using rtcore::LightingPreset;
using rtcore::PresetLighting;
using rtcore::Vec3;

const Vec3 kUp{0, 1, 0};

PresetLighting lightsFor(LightingPreset preset, const test::TracedScene& s) {
    const rtcore::Mesh& mesh = s.scene.model.mesh;
    const rtcore::Survey found = rtcore::survey(s.tree, mesh, rtcore::Axes(kUp));
    return rtcore::presetLighting(preset, s.tree, mesh, found, rtcore::defaultCamera(s.tree, mesh, found));
}

TEST(LightingPreset, HasANameForEach) {
    for (std::size_t i = 0; i < rtcore::kLightingPresetNames.size(); ++i)
        EXPECT_EQ(rtcore::lightingPresetNamed(rtcore::kLightingPresetNames[i]),
                  static_cast<LightingPreset>(i));
    EXPECT_FALSE(rtcore::lightingPresetNamed("moon"));
}

TEST(LightingPreset, OfAnObjectIsASkyOrAStudioWithThreeLights) {
    const test::TracedScene s(test::block().finish());
    const PresetLighting sky = lightsFor(LightingPreset::Sky, s),
                         studio = lightsFor(LightingPreset::Studio, s);
    EXPECT_TRUE(sky.sky);
    EXPECT_TRUE(sky.lights.empty());
    ASSERT_TRUE(studio.sky);
    EXPECT_TRUE(studio.sky->studio && studio.sky->ground);
    EXPECT_FALSE(sky.sky->studio);
    ASSERT_EQ(studio.lights.size(), 3U);
    for (const rtcore::Light& light : rtcore::lightsOf(studio.lights)) {
        EXPECT_GT(dot(light.direction, -light.position), 0) << "shines at the object";
        EXPECT_TRUE(isMirrored(light));
    }
}

TEST(FillLight, IsForWhatOwnLightsLeaveInTheDark) {
    test::SceneBuilder builder = test::block();
    builder.scene.ambient = {};
    test::TracedScene s(builder.finish());
    const rtcore::Mesh& mesh = s.scene.model.mesh;
    const rtcore::Camera camera =
        rtcore::defaultCamera(s.tree, mesh, rtcore::survey(s.tree, mesh, rtcore::Axes(kUp)));
    rtcore::Light above;
    above.kind = rtcore::LightKind::Directional;
    above.direction = -kUp;
    above.intensity = rtcore::kWhite * 3;
    s.scene.lights = {above};
    const auto fill = rtcore::fillLight(s.scene, s.tree, camera);
    ASSERT_TRUE(fill) << "its sides are black";
    EXPECT_NEAR(fill->g * rtcore::kPi, 0.04F * 3, 1e-5F);
    rtcore::Camera level = camera;
    level.eye = {0, 1.3F, 7};
    level.forward = {0, 0, -1};
    EXPECT_TRUE(rtcore::fillLight(s.scene, s.tree, level)) << "only a sliver is lit";
    s.scene.ambient = rtcore::kWhite * 0.15F;
    EXPECT_FALSE(rtcore::fillLight(s.scene, s.tree, camera)) << "it has light from around";
    s.scene.ambient = {};
    s.scene.lights.push_back(above);
    s.scene.lights.back().light.direction = camera.forward;
    EXPECT_FALSE(rtcore::fillLight(s.scene, s.tree, camera)) << "all that is seen is lit";
}

TEST(LightingPreset, LetsRoomsBeAsBrightOnWideGroundAsWithout) {
    const auto reachOf = [](test::SceneBuilder builder, float metresPerUnit) {
        const test::TracedScene s(builder.finish());
        const rtcore::Mesh& mesh = s.scene.model.mesh;
        const rtcore::Survey found = rtcore::survey(s.tree, mesh, rtcore::Axes(kUp, metresPerUnit));
        for (const rtcore::SettingAssignment& each : rtcore::settingsOf(LightingPreset::Sky, found))
            if (each.name == "ambientOcclusion.distance") return std::get<float>(each.value);
        return 0.0F;
    };
    EXPECT_NEAR(reachOf(test::block(), 1), 0.15F * std::sqrt(12.0F), 1e-4F);
    test::SceneBuilder onGround = test::block();
    onGround.square({0, -1, 0}, {0, 1, 0}, 500, onGround.material(test::matte(0.5F)));
    EXPECT_NEAR(reachOf(std::move(onGround), 1), 0.15F * std::sqrt(12.0F), 1e-4F);
    EXPECT_NEAR(reachOf(test::block(), 100), 0.05F, 1e-6F) << "5 m of 200";
}

TEST(LightingPreset, OfARoomHasLightsUnderItsCeiling) {
    const test::TracedScene s(test::room().finish());
    EXPECT_EQ(lightsFor(LightingPreset::Sky, s).lights, lightsFor(LightingPreset::Studio, s).lights);
    EXPECT_EQ(lightsFor(LightingPreset::Sky, s).lights.front().name, "ceiling 1");
    EXPECT_FALSE(lightsFor(LightingPreset::Studio, s).sky) << "its walls are those of the room";
}

TEST(LightingPreset, TakesThePlaceOfAllOtherLight) {
    test::TracedScene s(test::block().finish());
    rtcore::Scene& scene = s.scene;
    scene.lights = {test::pointLight({1, 2, 3}, 4)};
    scene.lights[0].name = "mine";
    rtcore::lightBy(scene, lightsFor(LightingPreset::Sky, s));
    ASSERT_EQ(scene.lights.size(), 1U);
    EXPECT_EQ(rtcore::sunOf(scene), 0U);
    EXPECT_NE(scene.environment(), nullptr);
    EXPECT_TRUE(rtcore::isLitBy(scene, lightsFor(LightingPreset::Sky, s)));
    EXPECT_FALSE(rtcore::isLitBy(scene, lightsFor(LightingPreset::Headlight, s)));
    scene.lights[0].light.on = 0;
    EXPECT_TRUE(rtcore::isLitBy(scene, lightsFor(LightingPreset::Sky, s))) << "switched off is not edited";

    rtcore::lightBy(scene, lightsFor(LightingPreset::Headlight, s));
    EXPECT_FALSE(scene.sky);
    EXPECT_EQ(scene.environment(), nullptr);
    ASSERT_EQ(scene.lights.size(), 1U);
    EXPECT_EQ(scene.lights[0].name, rtcore::kHeadlightName);
    EXPECT_EQ(scene.lights[0].notes.id, 1);
    scene.lights[0].light.intensity = {1, 2, 3};
    EXPECT_FALSE(rtcore::isLitBy(scene, lightsFor(LightingPreset::Headlight, s)));
}

TEST(LightingPreset, TakesTheSkyThatIsNamed) {
    const test::TracedScene s(test::block().finish());
    rtcore::Sky evening;
    evening.date->second = 18 * 3600;
    const PresetLighting preset =
        rtcore::presetLighting(LightingPreset::Sky, s.tree, s.scene.mesh(),
                               rtcore::survey(s.tree, s.scene.mesh(), rtcore::Axes(kUp)), {}, evening);
    evening.ground = true;
    EXPECT_EQ(preset.sky, evening);
}

} // namespace
