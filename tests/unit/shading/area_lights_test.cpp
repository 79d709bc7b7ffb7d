// AreaLights with a size: their light in closed form, their shadows, and their samples.
#include "support/small_scene.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

namespace rtcore {
namespace {

using test::kPi;
using test::SceneBuilder;
using test::TracedScene;

Light sphere(Vec3 position, float radius) {
    Light light;
    light.kind = LightKind::Sphere;
    light.position = position;
    light.radius = radius;
    // One unit of radiance.
    light.intensity = Colour{1, 1, 1} * (static_cast<float>(kPi) * radius * radius);
    return light;
}

/// A rectangle of radiance 1.
Light rectangle(Vec3 position, Vec3 direction, Vec3 right, float width, float height) {
    Light light;
    light.kind = LightKind::Rectangle;
    light.position = position;
    light.direction = direction;
    light.right = right;
    light.width = width;
    light.height = height;
    light.intensity = Colour{1, 1, 1} * (width * height);
    return light;
}

/// The irradiance at the origin on a floor that faces up, by its radiance: white and matte.
double irradiance(const Light& light, int samples) {
    SceneBuilder b;
    b.square({}, {0, 1, 0}, 0.01F, b.material(test::matte(1)));
    b.scene.lights.push_back(light);
    const TracedScene s(b.finish());
    RenderSettings settings = test::exactSettings();
    settings.areaLights.samples = samples;
    return s.see({0.001F, 1, 0.002F}, {}, settings) * kPi;
}

Vec3 towards(double cosine) {
    return {static_cast<float>(std::sqrt(1 - cosine * cosine)), static_cast<float>(cosine), 0};
}

// Notes on optics: the irradiance of a sphere of radiance 1 with r / d = 1/2, also half below the horizon.
TEST(SphereLight, HasTheIrradianceOfTheClosedForm) {
    const std::array<std::array<double, 2>, 4> expected{
        {{1, 0.785398}, {0.3, 0.247292}, {0, 0.090586}, {-0.3, 0.011672}}};
    for (const auto& [cosine, value] : expected)
        EXPECT_NEAR(irradiance(sphere(towards(cosine) * 2, 1), 4096), value, 0.002 * value + 2e-4) << cosine;
}

TEST(SphereLight, IsAPointFromAfarAndWhenItsSamplesAreOff) {
    Light point;
    point.position = towards(0.5) * 2;
    point.intensity = {8, 8, 8};
    Light small = point;
    small.kind = LightKind::Sphere;
    small.radius = 1e-4F;
    EXPECT_NEAR(irradiance(small, 16), 1, 1e-4);
    EXPECT_NEAR(irradiance(small, 0), irradiance(point, 0), 1e-5);
    small.radius = 0;
    EXPECT_NEAR(irradiance(small, 16), 1, 1e-5);
}

TEST(SphereLight, InsideOfItThereIsLightButNoInfiniteLight) {
    const double inside = irradiance(sphere({0, 0.05F, 0}, 1), 64);
    EXPECT_GT(inside, 1);
    EXPECT_LT(inside, 2.1 * kPi);
}

// Notes on optics: a square of side 1 one above, its corner above, and upright beside the point.
TEST(RectangleLight, HasTheIrradianceOfTheClosedForm) {
    EXPECT_NEAR(irradiance(rectangle({0, 1, 0}, {0, -1, 0}, {1, 0, 0}, 1, 1), 4096), 0.752275, 0.002);
    EXPECT_NEAR(irradiance(rectangle({0.5F, 1, 0.5F}, {0, -1, 0}, {1, 0, 0}, 1, 1), 4096), 0.435210, 0.002);
    EXPECT_NEAR(irradiance(rectangle({1, 0.5F, 0}, {-1, 0, 0}, {0, 0, 1}, 1, 1), 4096), 0.223347, 0.002);
    EXPECT_NEAR(irradiance(rectangle({1, 0, 0}, {-1, 0, 0}, {0, 0, 1}, 1, 1), 4096), 0.087510, 0.002);
}

TEST(RectangleLight, IsDarkBehindAndNarrowOnItsSide) {
    EXPECT_EQ(irradiance(rectangle({0, 1, 0}, {0, 1, 0}, {1, 0, 0}, 1, 1), 64), 0);
    const double wide = irradiance(rectangle({0, 1, 0}, {0, -1, 0}, {1, 0, 0}, 4, 0.1F), 4096);
    const double turned = irradiance(rectangle({0, 1, 0}, {0, -1, 0}, {0, 0, 1}, 4, 0.1F), 4096);
    EXPECT_NEAR(wide, turned, 0.01 * wide);
}

/// A floor under a square light, with a screen over the half x > 0 right between; seen from below the screen.
struct Penumbra {
    static double at(float x, int samples) {
        SceneBuilder b;
        b.square({}, {0, 1, 0}, 10, b.material(test::matte(1)));
        b.box({0, 1, -50}, {50, 1.001F, 50}, b.material(test::matte(1)));
        Light light = rectangle({0, 2, 0}, {0, -1, 0}, {1, 0, 0}, 0.2F, 0.2F);
        b.scene.lights.push_back(light);
        const TracedScene s(b.finish());
        RenderSettings settings = test::exactSettings();
        settings.areaLights.samples = samples;
        const double shadowed = s.see({x, 0.5F, 0}, {x, 0, 0}, settings);
        settings.shadows = false;
        return shadowed / s.see({x, 0.5F, 0}, {x, 0, 0}, settings);
    }
};

TEST(RectangleLight, ThrowsAPenumbraAsWideAsItself) {
    EXPECT_EQ(Penumbra::at(0.11F, 256), 0);
    EXPECT_NEAR(Penumbra::at(-0.11F, 256), 1, 1e-5);
    for (const float x : {-0.06F, -0.02F, 0.03F, 0.07F})
        EXPECT_NEAR(Penumbra::at(x, 1024), 0.5 - 5 * static_cast<double>(x), 0.01) << x;
}

/// A wave of samples of the pixels around (40, 30), all at the same place under a light.
std::vector<float> seenBy(const TracedScene& s, int samples, int side) {
    RenderSettings settings = test::exactSettings();
    settings.areaLights.samples = samples;
    RayWave wave;
    std::vector<SampleId> names;
    for (int i = 0; i < side * side; ++i) {
        wave.push({{-0.02F, 0.5F, 0}, 0, {0, -1, 0}, 100});
        names.push_back(
            {static_cast<std::uint16_t>(40 + i % side), static_cast<std::uint16_t>(30 + i / side), 0});
    }
    WhittedIntegrator integrator(s.scene, s.tracer, settings);
    integrator.trace(wave, names);
    std::vector<float> seen;
    for (std::size_t i = 0; i < wave.size(); ++i) seen.push_back(integrator.radiance().at(i).x);
    return seen;
}

TEST(AreaLights, AreSampledAlikeInEveryFrameAndDifferentlyInEachPixel) {
    SceneBuilder b;
    b.square({}, {0, 1, 0}, 10, b.material(test::matte(1)));
    b.box({0, 1, -50}, {50, 1.001F, 50}, b.material(test::matte(1)));
    b.scene.lights.push_back(rectangle({0, 2, 0}, {0, -1, 0}, {1, 0, 0}, 0.2F, 0.2F));
    const TracedScene s(b.finish());
    const std::vector<float> first = seenBy(s, 4, 8);
    EXPECT_EQ(first, seenBy(s, 4, 8));
    EXPECT_NE(std::count(first.begin(), first.end(), first[0]), 64);
    // Evenly spread samples: with four, the fraction of the light is off by a quarter at most.
    for (const float seen : first) EXPECT_NEAR(seen / seenBy(s, 4096, 1)[0], 1, 0.6);
}

TEST(AreaLights, AreMirroredWithoutSpecksByGlossySurfaces) {
    SceneBuilder b;
    Material polished = test::matte(0);
    polished.specular = {1, 1, 1};
    polished.shininess = 2000;
    b.square({}, {0, 1, 0}, 10, b.material(polished));
    b.scene.lights.push_back(sphere({-0.02F, 1, 0}, 0.2F));
    const TracedScene s(b.finish());
    const double exact = static_cast<double>(seenBy(s, 4096, 1)[0]);
    EXPECT_NEAR(exact, 1, 0.05); // the light's own radiance
    double sum = 0;
    for (const float seen : seenBy(s, 16, 16)) {
        EXPECT_LT(seen, 2 * exact);
        EXPECT_GT(seen, 0.3 * exact);
        sum += static_cast<double>(seen);
    }
    EXPECT_NEAR(sum / 256, exact, 0.1 * exact);
}

TEST(AreaLights, SamplesOfOnePixelShareItsPattern) {
    SceneBuilder b;
    b.square({}, {0, 1, 0}, 10, b.material(test::matte(1)));
    b.box({0, 1, -50}, {50, 1.001F, 50}, b.material(test::matte(1)));
    b.scene.lights.push_back(rectangle({0, 2, 0}, {0, -1, 0}, {1, 0, 0}, 0.2F, 0.2F));
    const TracedScene s(b.finish());
    RenderSettings settings = test::exactSettings();
    const auto mean = [&](int samples, std::uint32_t subs) {
        settings.areaLights.samples = samples;
        RayWave wave;
        std::vector<SampleId> names;
        for (std::uint32_t sub = 0; sub < subs; ++sub) {
            wave.push({{-0.02F, 0.5F, 0}, 0, {0, -1, 0}, 100});
            names.push_back({7, 9, sub});
        }
        WhittedIntegrator integrator(s.scene, s.tracer, settings);
        integrator.trace(wave, names);
        double sum = 0;
        for (std::size_t i = 0; i < subs; ++i) sum += static_cast<double>(integrator.radiance().at(i).x);
        return sum / subs;
    };
    EXPECT_NEAR(mean(4, 64), mean(256, 1), 1e-6 * mean(256, 1) + 1e-7);
}

} // namespace
} // namespace rtcore
