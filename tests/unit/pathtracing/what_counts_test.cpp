// Rows of the table "What counts which light" in docs/shading.md: what is seen, what is not, ambient light,
// emission that lights nothing, fog. Light behind mirrors and glass has tests of its own.

#include "path_support.h"

#include <gtest/gtest.h>

#include <array>
#include <string>

namespace rtcore {
namespace what_counts {
namespace {

constexpr Vec3 kEye{0, 0, 4}, kAhead{0, 0, -1};

/// Eyes at (0, 0, 4) see by a mirror or pane at z = 0 what is at z = 6, and at z = -6.
template <typename Add>
test::PathScene between(const Material& material, EmitterLight emitters, Add&& add,
                        const RenderSettings& settings = test::exactSettings()) {
    test::SceneBuilder b;
    b.square({0, 0, 0}, {0, 0, 1}, 1, b.material(material));
    add(b);
    return test::PathScene(b.finish(), settings, emitters);
}

Material tintedPane() {
    Material pane = test::glass(1);
    pane.transmission = {0.6F, 0.7F, 0.8F};
    return pane;
}

TEST(WhatCounts, EmissionIsSeenWholeByMirrorsAndGlassWhateverItLights) {
    const auto emitters = [](test::SceneBuilder& b) {
        const auto bright = b.material(test::emitter({3, 3, 3}));
        b.square({0, 0, 6}, {0, 0, 1}, 1, bright);
        b.square({0, 0, -6}, {0, 0, 1}, 1, bright);
        b.scene.lights = {test::pointLight({0, 0, 6}, 1)}; // it stands for this emission
    };
    for (const EmitterLight use : {EmitterLight::Automatic, EmitterLight::On, EmitterLight::Off}) {
        const auto byMirror = between(test::mirror(0.5F), use, emitters);
        const auto byPane = between(tintedPane(), use, emitters);
        for (const bool caustics : {false, true}) {
            test::PathLimits limits = test::bouncesAlone(2);
            limits.caustics = caustics;
            test::expectLight(byMirror, kEye, kAhead, 64, limits, 1.5, "mirror");
            test::expectLight(byPane, kEye, kAhead, 64, limits, 1.8, "pane");
        }
    }
}

TEST(WhatCounts, SurroundingsAreSeenWholeByMirrorsAndGlass) {
    const auto background = [](test::SceneBuilder& b) { b.scene.background = {2, 2, 2}; };
    test::expectLight(between(test::mirror(0.5F), EmitterLight::On, background), kEye, kAhead, 64, {}, 1,
                      "mirror");
    test::expectLight(between(tintedPane(), EmitterLight::On, background), kEye, kAhead, 64, {}, 1.2, "pane");
}

Light areaLight(LightKind kind, Vec3 position, Vec3 direction) {
    Light light = test::pointLight(position, 10);
    light.kind = kind;
    light.radius = kind == LightKind::Sphere ? 0.7F : 0;
    light.direction = direction;
    light.right = {1, 0, 0};
    light.width = light.height = 1.4F;
    return light;
}

TEST(WhatCounts, LightsAreSeenNeitherDirectlyNorByMirrorsAndGlass) {
    for (const LightKind kind : {LightKind::Sphere, LightKind::Rectangle}) {
        const auto lights = [&](test::SceneBuilder& b) {
            b.scene.lights = {areaLight(kind, {0, 0, 6}, {0, 0, -1}), areaLight(kind, {0, 0, -6}, {0, 0, 1})};
        };
        for (const Material& material : {test::mirror(1), tintedPane(), test::glass()}) {
            const test::PathScene scene = between(material, EmitterLight::On, lights);
            for (const bool caustics : {false, true}) {
                test::PathLimits limits;
                limits.caustics = caustics;
                test::expectLight(scene, kEye, kAhead, 64, limits, 0, "by the surface");
                test::expectLight(scene, {5, 0, 0}, normalize({-5, 0, -6}), 64, limits, 0, "directly");
            }
        }
    }
}

// --- Emission that lights nothing ---

TEST(WhatCounts, EmissionThatIsOffLightsNothing) {
    test::SceneBuilder b;
    b.square({0, 0, 0}, {0, 1, 0}, 2, b.material(test::matte(0.5F)));
    b.square({0, 1, 0}, {0, -1, 0}, 2, b.material(test::emitter(kWhite)));
    const Scene flame = b.finish();
    const test::PathScene off(flame, test::exactSettings(), EmitterLight::Off);
    for (const bool caustics : {false, true}) {
        test::PathLimits limits = test::bouncesAlone(3);
        limits.caustics = caustics;
        test::expectLight(off, {0, 0.5F, 0}, {0, -1, 0}, 4096, limits, 0, "off");
    }
    const test::PathScene on(flame, test::exactSettings(), EmitterLight::On);
    EXPECT_GT(on.see({0, 0.5F, 0}, {0, -1, 0}, 1000).mean[0], 0.2);
}

TEST(WhatCounts, OnlyLightsThatAreOnAndInTheBoxStandForEmission) {
    test::SceneBuilder b;
    b.square({0, 0, 0}, {0, 1, 0}, 2, b.material(test::matte(0.5F)));
    b.box({-.1F, 1, -.1F}, {.1F, 1.2F, .1F}, b.material(test::emitter({30, 30, 30})));
    Scene flame = b.finish();
    const auto lit = [&](Light light) {
        flame.lights = {light};
        const test::PathScene scene(flame, test::exactSettings(), EmitterLight::Automatic);
        return scene.lights.emitsNoLight()[1] == 0;
    };
    EXPECT_FALSE(lit(test::pointLight({0, 1.1F, 0}, 1)));
    EXPECT_TRUE(lit(test::pointLight({0, 1.3F, 0}, 1)));
    EXPECT_TRUE(lit(test::pointLight({0.2F, 1.1F, 0}, 1)));
    Light off = test::pointLight({0, 1.1F, 0}, 1);
    off.on = 0;
    EXPECT_TRUE(lit(off));
    Light sun = test::pointLight({0, 1.1F, 0}, 1);
    sun.kind = LightKind::Directional;
    EXPECT_TRUE(lit(sun));
}

// --- Ambient light ---

/// A floor that scatters half of its light, in ambient light of radiance 0.3.
test::SceneBuilder inAmbientLight() {
    test::SceneBuilder b;
    b.square({0, 0, 0}, {0, 1, 0}, 1, b.material(test::matte(0.5F)));
    b.scene.ambient = {0.3F, 0.3F, 0.3F};
    return b;
}

TEST(WhatCounts, AmbientLightIsThatOfAnEvenSkyThatIsNotSeen) {
    test::SceneBuilder b = inAmbientLight();
    b.square({0, 3, 0}, {0, 0, 1}, 1, b.material(test::mirror(1)));
    b.square({5, 3, 0}, {0, 0, 1}, 1, b.material(tintedPane()));
    const Scene scene = b.finish();
    for (const bool caustics : {false, true}) {
        test::PathLimits limits = test::bouncesAlone(0);
        limits.caustics = caustics;
        const test::PathScene traced(scene);
        test::expectLight(traced, {0, 3, 4}, {0, 0, -1}, 64, limits, 0, "in a mirror");
        test::expectLight(traced, {5, 3, 4}, {0, 0, -1}, 64, limits, 0, "through a pane");
        test::expectLight(traced, {0, 8, 4}, {0, 0, -1}, 64, limits, 0, "directly");
    }
}

TEST(WhatCounts, AmbientLightYieldsToABackgroundAndIsNoneInAClosedRoom) {
    test::SceneBuilder outside = inAmbientLight();
    outside.scene.background = {0.1F, 0.1F, 0.1F};
    test::expectLight(test::PathScene(outside.finish()), {0, 0.5F, 0}, {0, -1, 0}, 8192,
                      test::bouncesAlone(0), 0.05, "background");
    test::SceneBuilder room = inAmbientLight();
    room.box({-2, -2, -2}, {2, 2, 2}, room.material(test::matte(0.8F)));
    test::expectLight(test::PathScene(room.finish()), {0, 0.5F, 0}, {0, -1, 0}, 512, {}, 0, "room");
}

TEST(WhatCounts, AmbientOcclusionAndTheLightOfTheSkyChangeNothing) {
    RenderSettings with = test::exactSettings();
    with.ambientOcclusion.on = true;
    RenderSettings sky = test::exactSettings();
    sky.skyLight.on = true;
    const test::PathLimits limits = test::bouncesAlone(0);
    for (const bool background : {false, true}) {
        std::vector<double> means;
        for (const RenderSettings& settings : {test::exactSettings(), with, sky}) {
            test::SceneBuilder b = inAmbientLight();
            if (background) b.scene.background = {0.2F, 0.3F, 0.4F};
            const test::PathScene scene(b.finish(), settings);
            means.push_back(scene.see({0, 0.5F, 0}, {0, -1, 0}, 2048, limits).mean[0]);
        }
        EXPECT_GT(means[0], 0.05);
        EXPECT_EQ(means[1], means[0]);
        EXPECT_EQ(means[2], means[0]);
    }
}

// --- Fog ---

Fog thinFog(Colour albedo) {
    Fog fog;
    fog.kind = FogKind::Homogeneous;
    fog.density = 0.2F;
    fog.albedo = albedo;
    fog.colour = {};
    return fog;
}

TEST(WhatCounts, FogWeakensEmissionThatIsSeenAndThatLights) {
    // Seen over four units; then a unit square two units above a floor, whose light is seen over 0.5.
    test::SceneBuilder b;
    b.square({0, 0, 0}, {0, 1, 0}, 2, b.material(test::matte(1)));
    b.quad({-.5F, 2, -.5F}, {.5F, 2, -.5F}, {.5F, 2, .5F}, {-.5F, 2, .5F}, b.material(test::emitter(kWhite)));
    b.scene.fog = thinFog({});
    const test::PathScene scene(b.finish());
    test::expectLight(scene, {0, 6, 0}, {0, -1, 0}, 64, {}, std::exp(-0.8), "seen");
    // The square is 2 to 2.12 units away; the mean of exp(-0.2 r), weighted by cosines and distance.
    double sum = 0, weights = 0;
    for (int x = 0; x < 100; ++x) {
        for (int z = 0; z < 100; ++z) {
            const double dx = (x + 0.5) / 100 - 0.5, dz = (z + 0.5) / 100 - 0.5;
            const double square = dx * dx + dz * dz + 4, weight = 4 / (square * square);
            weights += weight;
            sum += weight * std::exp(-0.2 * std::sqrt(square));
        }
    }
    test::expectLight(scene, {0, 0.5F, 0}, {0, -1, 0}, 16384, test::bouncesAlone(0),
                      .073478 * std::exp(-0.1) * sum / weights, "lights");
}

TEST(WhatCounts, FogScattersLightOnceAsForWhitted) {
    test::SceneBuilder b;
    b.square({0, 0, 0}, {0, 1, 0}, 4, b.material(test::matte(0.5F)));
    b.square({0.5F, 1, 0}, {0, 1, 0}, 0.3F, b.material(test::matte(0)));
    b.scene.lights = {test::pointLight({0.6F, 2, 0.3F}, 5)};
    b.scene.fog = thinFog({0.9F, 0.5F, 0.1F});
    b.scene.fog.colour = {0.1F, 0.2F, 0.3F};
    b.scene.fog.emission = {0.01F, 0.02F, 0.03F};
    const test::PathScene scene(b.finish());
    RenderSettings fine = test::exactSettings();
    fine.fog.shafts = 64;
    for (const Vec3 to : {Vec3{0, 0.4F, 0}, Vec3{0.5F, 0.5F, 0}, Vec3{-1, 3, -4}}) {
        const Vec3 eye{0.2F, 1.5F, 5};
        const auto seen = scene.see(eye, to - eye, 16384, test::bouncesAlone(0));
        const Colour whitted = scene.traced.trace(eye, to - eye, fine).radiance;
        // Whitted's 64 shadow rays along the ray are a sum of their own.
        EXPECT_NEAR(seen.mean[0], whitted.r, 5 * seen.error[0] + 0.01 * whitted.r) << to.y;
        EXPECT_NEAR(seen.mean[2], whitted.b, 5 * seen.error[2] + 0.01 * whitted.b) << to.y;
    }
}

} // namespace
} // namespace what_counts
} // namespace rtcore
