// Fog in whole images: what is known in closed form of surfaces, mirrors, glass and shadows in it.
#include "support/small_scene.h"

#include <gtest/gtest.h>

#include <cmath>

namespace rtcore {
namespace {

using test::SceneBuilder;
using test::TracedScene;

constexpr double kSource = 0.5;

void addFog(Scene& scene, float density, FogKind kind = FogKind::Homogeneous) {
    scene.fog.kind = kind;
    scene.fog.density = density;
    scene.fog.colour = kWhite * static_cast<float>(kSource);
}
double through(double light, double depth) {
    return light * std::exp(-depth) + (1 - std::exp(-depth)) * kSource;
}

/// An emissive wall, 20 away from the origin along +x.
SceneBuilder emissiveWall(float radiance) {
    SceneBuilder b;
    b.square({20, 0, 0}, {-1, 0, 0}, 50, b.material(test::emitter({radiance, radiance, radiance})));
    return b;
}

TEST(FogScene, AWallAtAKnownDistance) {
    SceneBuilder b = emissiveWall(2);
    addFog(b.scene, 0.05F);
    const TracedScene traced(b.finish());
    EXPECT_NEAR(traced.see({}, {1, 0, 0}), 1.051819, 1e-5);
    RenderSettings settings = test::exactSettings();
    settings.fog.on = false;
    EXPECT_EQ(traced.see({}, {1, 0, 0}, settings), 2);
}

TEST(FogScene, HidesTheSkyWhereItHasNoEnd) {
    SceneBuilder b = emissiveWall(2);
    b.scene.background = {3, 3, 3};
    addFog(b.scene, 0.05F);
    EXPECT_NEAR(TracedScene(b.finish()).see({}, {-1, 0, 0}), kSource, 1e-6);

    SceneBuilder e = emissiveWall(2);
    e.scene.background = {3, 3, 3};
    addFog(e.scene, 0.1F, FogKind::Exponential);
    e.scene.fog.scaleHeight = 10;
    const TracedScene traced(e.finish());
    EXPECT_NEAR(traced.see({}, {0, 1, 0}), through(3, 1), 1e-5);
    EXPECT_NEAR(traced.see({}, {-1, 0, 0}), kSource, 1e-6);
    EXPECT_NEAR(traced.see({}, {-0.5F, -0.1F, 0}), kSource, 1e-6);
}

TEST(FogScene, IsSeenThroughEnvironmentMapsUpwardsOnly) {
    SceneBuilder b = emissiveWall(2);
    HdrImage image(8, 4);
    for (Colour& pixel : image.pixels) pixel = {3, 3, 3};
    b.scene.environments.push_back(
        std::make_shared<Environment>(Environment::fromEquirectangular(image, "even")));
    addFog(b.scene, 0.1F, FogKind::Exponential);
    b.scene.fog.scaleHeight = 10;
    b.scene.fog.surroundings = 0.5F;
    const TracedScene traced(b.finish());
    const double source = kSource + 1.5; // its mean is 3
    EXPECT_NEAR(traced.see({}, {-1, 0, 0}), source, 1e-5);
    EXPECT_NEAR(traced.see({}, {0, 1, 0}), 3 * std::exp(-1) + source * (1 - std::exp(-1)), 1e-5);
}

TEST(FogScene, GoesOnBehindAMirror) {
    SceneBuilder b = emissiveWall(2);
    b.square({-10, 0, 0}, {1, 0, 0}, 50, b.material(test::mirror(0.5F)));
    addFog(b.scene, 0.05F);
    const TracedScene traced(b.finish());
    EXPECT_NEAR(traced.see({}, {-1, 0, 0}), through(0.5 * through(2, 30 * 0.05), 0.5), 1e-5);
}

TEST(FogScene, ThereIsNoneInsideOfSolids) {
    const auto seen = [](float thickness, bool thing) {
        SceneBuilder b = emissiveWall(2);
        Material clear = test::glass(1);
        clear.indexOfRefraction = 1.0001F;
        b.box({5, -3, -3}, {5 + thickness, 3, 3}, b.material(clear));
        if (thing) b.square({7, 0, 0}, {-1, 0, 0}, 1, b.material(test::emitter({2, 2, 2})));
        addFog(b.scene, 0.05F);
        return TracedScene(b.finish()).see({}, {1, 0, 0});
    };
    EXPECT_NEAR(seen(10, false), through(2, 10 * 0.05), 1e-4);
    EXPECT_NEAR(seen(1, false), through(2, 19 * 0.05), 1e-4);
    EXPECT_NEAR(seen(10, true), through(2, 5 * 0.05), 1e-4); // an object cast into the glass
}

/// A floor under a light 4 above it, seen from 3 above it: where it reflects all.
double litFloor(FogKind kind, bool pane, const Light& light) {
    SceneBuilder b;
    b.square({0, 0, 0}, {0, 1, 0}, 30, b.material(test::matte(1)));
    Material clear = test::glass(1.0001F);
    if (pane) b.box({-30, 1, -30}, {30, 2, 30}, b.material(clear));
    b.scene.lights = {light};
    addFog(b.scene, 0.05F, kind);
    b.scene.fog.scaleHeight = 4;
    b.scene.fog.colour = {};
    b.scene.fog.albedo = {};
    return TracedScene(b.finish()).see({0, 3, 0}, {});
}

TEST(FogScene, WeakensLights) {
    const Light light = test::pointLight({0, 4, 0}, 16);
    const double pi = test::kPi;
    EXPECT_NEAR(litFloor(FogKind::Homogeneous, false, light), std::exp(-0.35) / pi, 1e-5);
    EXPECT_NEAR(litFloor(FogKind::Homogeneous, true, light), std::exp(-0.25) / pi, 1e-4);
    const auto depth = [](double d) { return 0.05 * 4 * (1 - std::exp(-d / 4)); };
    EXPECT_NEAR(litFloor(FogKind::Exponential, false, light), std::exp(-depth(4) - depth(3)) / pi, 1e-5);
    const double glass = depth(2) - depth(1);
    EXPECT_NEAR(litFloor(FogKind::Exponential, true, light), std::exp(-depth(4) - depth(3) + 2 * glass) / pi,
                1e-4);
    Light sun;
    sun.kind = LightKind::Directional;
    sun.direction = {0, -1, 0};
    EXPECT_NEAR(litFloor(FogKind::Homogeneous, false, sun), std::exp(-0.15) / pi, 1e-5);
    EXPECT_NEAR(litFloor(FogKind::Exponential, false, sun), std::exp(-0.2 - depth(3)) / pi, 1e-5);
    EXPECT_NEAR(litFloor(FogKind::Exponential, true, sun), std::exp(-0.2 - depth(3) + 2 * glass) / pi, 1e-4);
}

TEST(FogScene, AWallHidesALightFromHalfOfTheRay) {
    const auto seen = [](bool wall, int shafts, bool shadows = true) {
        SceneBuilder b = emissiveWall(0);
        // The light stands at x = 10, beside the ray; the wall shades all beyond.
        if (wall) b.square({10.01F, 1.5F, 0}, {-1, 0, 0}, 1.4F, b.material(test::matte(0)));
        b.scene.lights = {test::pointLight({10, 2, 0}, 100)};
        addFog(b.scene, 1e-4F);
        b.scene.fog.colour = {};
        RenderSettings settings = test::exactSettings();
        settings.fog.shafts = shafts;
        settings.shadows = shadows;
        return TracedScene(b.finish()).see({}, {1, 0, 0}, settings);
    };
    const double free = seen(false, 0);
    EXPECT_GT(free, 1e-4);
    EXPECT_EQ(seen(true, 0), free);
    EXPECT_NEAR(seen(false, 1000) / free, 1, 1e-3);
    EXPECT_NEAR(seen(true, 1000) / free, 0.5, 2e-2);
    EXPECT_NEAR(seen(true, 1000, false) / free, 1, 1e-3);
}

TEST(FogScene, ShaftsAreTintedByGlass) {
    const auto seen = [](bool pane) {
        SceneBuilder b = emissiveWall(0);
        Material red = test::glass(1.0001F);
        red.transmission = {0.5F, 0.25F, 0};
        if (pane) b.square({10, 1, 0}, {0, 1, 0}, 50, b.material(red));
        b.scene.lights = {test::pointLight({10, 2, 0}, 100)};
        addFog(b.scene, 0.02F);
        b.scene.fog.colour = {};
        RenderSettings settings = test::exactSettings();
        settings.fog.shafts = 64;
        return TracedScene(b.finish()).trace({}, {1, 0, 0}, settings).radiance;
    };
    const Colour free = seen(false), tinted = seen(true);
    EXPECT_NEAR(tinted.r / free.r, 0.5, 1e-3);
    EXPECT_NEAR(tinted.g / free.g, 0.25, 1e-3);
    EXPECT_EQ(tinted.b, 0);
}

} // namespace
} // namespace rtcore
