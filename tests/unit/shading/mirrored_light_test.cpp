// Lights with a place where mirrors and bending glass show them, and cameras do not.
#include "support/small_scene.h"

#include "rtcore/scene/metallic_roughness.h"

#include <gtest/gtest.h>

namespace rtcore {
namespace mirrored_light {
namespace {

using test::SceneBuilder;
using test::TracedScene;

constexpr float kSide = 2, kIntensity = 12, kRadiance = kIntensity / (kSide * kSide);

/// A rectangle around `middle`, which shines to `towards`.
Light softbox(Vec3 middle, Vec3 towards, bool mirrored = true) {
    Light light;
    light.kind = LightKind::Rectangle;
    light.position = middle;
    light.direction = normalize(towards);
    light.right = basisAround(light.direction).tangent;
    light.width = light.height = kSide;
    light.intensity = kWhite * kIntensity;
    light.mirrored = mirrored ? 1 : 0;
    return light;
}

Light ball(Vec3 middle, float radius) {
    Light light = test::pointLight(middle, kIntensity);
    light.kind = LightKind::Sphere;
    light.radius = radius;
    light.mirrored = 1;
    return light;
}

Material metal(float roughness) {
    Material m;
    setMetallicRoughness(m, kWhite * 0.9F, 1, roughness);
    return m;
}

RenderSettings sampled(int samples = 64) {
    RenderSettings settings = test::exactSettings();
    settings.areaLights.samples = samples;
    return settings;
}

/// Looks from z = 3 at a surface at z = 0 of such a material.
TracedScene facing(const Material& material, std::vector<Light> lights) {
    SceneBuilder b;
    b.square({0, 0, 0}, {0, 0, 1}, 5, b.material(material));
    b.scene.lights.assign(lights.begin(), lights.end());
    return TracedScene(b.finish());
}
float seen(const TracedScene& scene, Vec3 direction = {0, 0, -1}, int samples = 64) {
    return scene.trace({0, 0, 3}, direction, sampled(samples)).radiance.r;
}

TEST(MirroredLight, IsSeenInMirrorsWhereItIsToBe) {
    const Light box = softbox({0, 0, 6}, {0, 0, -1});
    EXPECT_NEAR(seen(facing(test::mirror(0.5F), {box})), 0.5F * kRadiance, 1e-4F);
    EXPECT_NEAR(seen(facing(metal(0), {box})), 0.9F * kRadiance, 1e-3F) << "chrome";
    EXPECT_NEAR(seen(facing(test::mirror(1), {ball({0, 0, 6}, 1)})), kIntensity / test::kPi, 1e-3F);
    EXPECT_EQ(seen(facing(test::mirror(1), {softbox({0, 0, 6}, {0, 0, -1}, false)})), 0);
    EXPECT_EQ(seen(facing(test::mirror(1), {softbox({0, 0, 6}, {0, 0, 1})})), 0) << "from behind";
    EXPECT_EQ(seen(facing(test::mirror(1), {softbox({2, 0, 6}, {0, 0, -1})})), 0) << "beside it";
    Light off = box, black = box, flat = box;
    off.on = 0;
    black.intensity = {};
    flat.height = 0;
    for (const Light& light : {off, black, flat}) EXPECT_EQ(seen(facing(test::mirror(1), {light})), 0);
}

TEST(MirroredLight, IsNotSeenByCamerasAndThroughPanes) {
    EXPECT_EQ(seen(facing(test::glass(1), {softbox({0, 0, -6}, {0, 0, 1})})), 0);
    const TracedScene s = facing(test::matte(0), {softbox({0, 0, 6}, {0, 0, -1})});
    EXPECT_EQ(seen(s, {0, 0, 1}), 0);
}

TEST(MirroredLight, IsSeenThroughGlassThatBends) {
    SceneBuilder b;
    b.box({-1, -1, -1}, {1, 1, 0}, b.material(test::glass()));
    b.scene.lights = {softbox({0, 0, -6}, {0, 0, 1})};
    const float once = 1 - 0.04F; // of what reaches a face, 4 % are mirrored
    EXPECT_NEAR(seen(TracedScene(b.finish())), once * once * kRadiance, 0.01F * kRadiance);
}

TEST(MirroredLight, IsHiddenByWhatStandsBeforeIt) {
    SceneBuilder b;
    b.square({0, 0, 0}, {0, 0, 1}, 5, b.material(test::mirror(1)));
    b.square({0, 0, 5}, {0, 0, -1}, 5, b.material(test::matte(0)));
    b.scene.lights = {softbox({0, 0, 6}, {0, 0, -1})};
    EXPECT_EQ(seen(TracedScene(b.finish())), 0);
    SceneBuilder behind;
    behind.square({0, 0, 0}, {0, 0, 1}, 5, behind.material(test::mirror(1)));
    behind.square({0, 0, 7}, {0, 0, -1}, 5, behind.material(test::matte(0)));
    behind.scene.lights = {softbox({0, 0, 6}, {0, 0, -1})};
    EXPECT_NEAR(seen(TracedScene(behind.finish())), kRadiance, 1e-4F);
}

/// Between a mirror and a lobe each shows its share: in the middle of a large light both see all of it.
TEST(MirroredLight, CountsOnceWhereAMirrorStandsForPartOfALobe) {
    for (const float roughness : {0.02F, 0.05F, 0.1F, 0.2F, 0.28F}) {
        Light box = softbox({0, 0, 1}, {0, 0, -1});
        box.width = box.height = 8;
        box.intensity = kWhite * (kRadiance * 64);
        EXPECT_NEAR(seen(facing(metal(roughness), {box}), {0, 0, -1}, 4096) / (0.9F * kRadiance), 1, 0.04F)
            << roughness;
    }
}

/// As the same light by area, with less noise: also where part of it is below the surface's horizon.
TEST(MirroredLight, LightsMatteSurfacesAsBefore) {
    for (const float tilt : {0.0F, 40.0F, 80.0F, 110.0F}) {
        for (const float height : {0.7F, 2.0F, 10.0F}) {
            SceneBuilder b;
            b.square({0, 0, 0}, {0, 1, 0}, 5, b.material(test::matte(1)));
            const Vec3 to = test::atAngle(static_cast<double>(tilt));
            Light light = softbox(to * height, -to, false);
            b.scene.lights = {light};
            Scene scene = b.finish();
            const float expected = TracedScene(scene).see({0.01F, 1, 0.02F}, {}, sampled(20'000));
            scene.lights[0].light.mirrored = 1;
            const TracedScene mirrored(scene);
            EXPECT_NEAR(mirrored.see({0.01F, 1, 0.02F}, {}, sampled(20'000)), expected, 2e-3F * kRadiance)
                << tilt << ", " << height;
            if (tilt > 45 || height < 1) continue;
            EXPECT_NEAR(mirrored.see({0.01F, 1, 0.02F}, {}, sampled(1)), expected, 0.05F * expected)
                << "by one sample: " << tilt << ", " << height;
        }
    }
}

TEST(MirroredLight, FogTakesWhatLiesBefore) {
    SceneBuilder b;
    b.square({0, 0, 0}, {0, 0, 1}, 5, b.material(test::mirror(1)));
    b.scene.lights = {softbox({0, 0, 6}, {0, 0, -1})};
    b.scene.fog.kind = FogKind::Homogeneous;
    b.scene.fog.density = 0.1F;
    b.scene.fog.colour = b.scene.fog.albedo = {};
    EXPECT_NEAR(seen(TracedScene(b.finish())), kRadiance * std::exp(-0.9F), 1e-3F);
}

} // namespace
} // namespace mirrored_light
} // namespace rtcore
