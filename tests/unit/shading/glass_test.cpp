#include "support/small_scene.h"
#include "support/steps.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace rtcore {
namespace {

using test::atAngle;
using test::SceneBuilder;
using test::TracedScene;

constexpr double kR = 0.04; ///< of glass, straight on

/// A closed slab, its faces at y = 0 and y = -1, over a floor of light at y = -2; above it `sky`.
TracedScene slab(const Material& material, float sky = 0, float floor = 1) {
    SceneBuilder b;
    b.box({-5, -1, -5}, {5, 0, 5}, b.material(material));
    b.square({0, -2, 0}, {0, 1, 0}, 1000, b.material(test::emitter({floor, floor, floor})));
    b.scene.background = {sky, sky, sky};
    return TracedScene(b.finish());
}
/// Light leaves e^-1/2 of itself in the slab.
Material absorbing() {
    Material m = test::glass();
    m.transmission = {0.25F, 0.25F, 0.25F};
    m.attenuationDistance = static_cast<float>(std::log(4) / 0.5);
    return m;
}

constexpr Vec3 kAbove{0.3F, 3, 0.1F}, kDown{0, -1, 0};

TEST(GlassSlab, LetsThroughWhatTheClosedFormSays) {
    EXPECT_NEAR(slab(test::glass()).trace(kAbove, kDown).radiance.r, (1 - kR) / (1 + kR), 1e-5);
    const double a = std::exp(-0.5);
    const double closed = (1 - kR) * (1 - kR) * a / (1 - kR * kR * a * a);
    EXPECT_NEAR(closed, 0.559308, 1e-6);
    EXPECT_NEAR(slab(absorbing()).trace(kAbove, kDown).radiance.r, closed, 1e-5);
    EXPECT_NEAR(slab(absorbing()).trace(kAbove, kDown, test::exactSettings(2)).radiance.r, 0.558979, 1e-5);
    EXPECT_EQ(slab(absorbing()).trace(kAbove, kDown, test::exactSettings(1)).radiance.r, 0);
}

TEST(GlassSlab, MirrorsTheRest) {
    const double r = slab(test::glass(), 1, 0).trace(kAbove, kDown).radiance.r;
    EXPECT_NEAR(r, 2 * kR / (1 + kR), 1e-5);
    const double a = std::exp(-0.5);
    EXPECT_NEAR(slab(absorbing(), 1, 0).trace(kAbove, kDown).radiance.r,
                kR + (1 - kR) * (1 - kR) * kR * a * a / (1 - kR * kR * a * a), 1e-5);
}

TEST(GlassSlab, TintsOnceWithoutAnAttenuationDistance) {
    Material m = test::glass();
    m.transmission = {0.5F, 0.25F, 1};
    const Colour seen = slab(m).trace(kAbove, kDown).radiance;
    EXPECT_NEAR(seen.r, 0.5 * (1 - kR) / (1 + kR), 1e-5);
    EXPECT_NEAR(seen.g, 0.25 * (1 - kR) / (1 + kR), 1e-5);
    EXPECT_NEAR(seen.b, (1 - kR) / (1 + kR), 1e-5);
}

TEST(GlassSlab, ShiftsWhatIsSeenAside) {
    // 45 degrees: inside 28.125 degrees, out again at 45 degrees.
    const double exit = std::tan(std::asin(std::sin(test::kPi / 4) / 1.5));
    const auto centre = static_cast<float>(exit + 1);
    SceneBuilder b;
    b.box({-5, -1, -5}, {5, 0, 5}, b.material(test::glass()));
    b.square({centre, -2, 0}, {0, 1, 0}, 0.01F, b.material(test::emitter({1, 1, 1})));
    const TracedScene s(b.finish());
    const auto seen = [&](float shift) { return s.see(atAngle(-45) * 2 + Vec3{shift, 0, 0}, {shift, 0, 0}); };
    EXPECT_NEAR(seen(0), (1 - 0.050240) * (1 - 0.050240), 1e-5);
    EXPECT_NEAR(seen(0.009F), seen(0), 1e-5);
    EXPECT_EQ(seen(0.011F), 0);
    EXPECT_EQ(seen(-0.011F), 0);
}

TEST(GlassSlab, PartOfItScattersWhenItIsHalfOpaque) {
    Material m = test::glass();
    m.opacity = 0.25F;
    m.diffuse = {1, 1, 1};
    SceneBuilder b;
    b.square({0, 0, 0}, {0, 1, 0}, 50, b.material(m)); // thin
    b.square({0, -2, 0}, {0, 1, 0}, 1000, b.material(test::emitter({1, 1, 1})));
    b.scene.ambient = {10, 10, 10};
    const double rest = (1 - kR) / (1 + kR);
    EXPECT_NEAR(TracedScene(b.finish()).trace(kAbove, kDown).radiance.r, rest * 0.75 + rest * 0.25 * 10,
                1e-5);
}

TEST(ThinGlass, LetsPassUnbentAndTints) {
    SceneBuilder b;
    Material m = test::glass();
    m.transmission = {0.5F, 1, 1};
    b.square({0, 0, 0}, {0, 1, 0}, 50, b.material(m));
    b.square({2, -2, 0}, {0, 1, 0}, 0.01F, b.material(test::emitter({1, 1, 1})));
    const TracedScene s(b.finish());
    const double r = 0.050240;
    const Colour seen = s.trace(atAngle(-45) * 2, -atAngle(-45)).radiance;
    EXPECT_NEAR(seen.r, 0.5 * (1 - r) / (1 + r), 1e-5);
    EXPECT_NEAR(seen.g, (1 - r) / (1 + r), 1e-5);
    EXPECT_EQ(s.see(Vec3{0.012F, 0, 0} + atAngle(-45) * 2, {0.012F, 0, 0}), 0);
}

TEST(ThinGlass, CostsNoDepth) {
    SceneBuilder b;
    const auto glass = b.material(test::glass());
    for (int i = 0; i < 20; ++i) b.square({0, -0.1F * static_cast<float>(i), 0}, {0, 1, 0}, 50, glass);
    b.square({0, -5, 0}, {0, 1, 0}, 50, b.material(test::emitter({1, 1, 1})));
    const double seen = TracedScene(b.finish()).trace(kAbove, kDown, test::exactSettings(0)).radiance.r;
    EXPECT_NEAR(seen, std::pow((1 - kR) / (1 + kR), 20), 1e-5);
}

/// A block of glass around the origin, its top at y = 1; the viewer is inside.
SceneBuilder block() {
    SceneBuilder b;
    b.box({-9, -9, -9}, {9, 1, 9}, b.material(test::glass()));
    return b;
}

TEST(InsideGlass, LightLeavesUnderSnellsLaw) {
    SceneBuilder b = block();
    // Up at 40 degrees through (0,1,0), on at 74.618568 degrees.
    const Vec3 outside = Vec3{0, 1, 0} + atAngle(74.618568) * 2;
    b.square(outside, -atAngle(74.618568), 0.01F, b.material(test::emitter({1, 1, 1})));
    const TracedScene s(b.finish());
    const Vec3 eye = Vec3{0, 1, 0} - atAngle(40);
    EXPECT_NEAR(s.see(eye, {0, 1, 0}), 1 - 0.245291, 1e-5);
    EXPECT_EQ(s.see(eye, {0.05F, 1, 0}), 0);
}

TEST(InsideGlass, AllIsMirroredBeyondTheCriticalAngle) {
    SceneBuilder b = block();
    b.scene.background = {1, 1, 1};
    const TracedScene s(b.finish());
    const Vec3 top{0, 1, 0};
    const auto refractedRays = [&](double degrees) {
        return s.trace(top - atAngle(degrees), atAngle(degrees), test::exactSettings(1))
            .statistics.rays[static_cast<std::size_t>(RayKind::Refracted)];
    };
    EXPECT_EQ(refractedRays(41.7), 1U);
    EXPECT_EQ(refractedRays(41.9), 0U);
    EXPECT_EQ(refractedRays(80), 0U);
    // Mirrored at the top, it leaves through a side, where it arrives at 20 degrees from the normal.
    const double side = 70, f = [&] {
        const double ci = std::cos(20 * test::kPi / 180), eta = 1 / 1.5;
        const double ct = std::sqrt(1 - (1 - ci * ci) / eta / eta);
        const double rs = (ci - eta * ct) / (ci + eta * ct), rp = (eta * ci - ct) / (eta * ci + ct);
        return (rs * rs + rp * rp) / 2;
    }();
    EXPECT_NEAR(s.trace(top - atAngle(side), atAngle(side), test::exactSettings(2)).radiance.r, 1 - f, 1e-5);
}

TEST(GlassFurnace, ASlabGivesBackAllOfAnEvenLight) {
    const TracedScene s = slab(test::glass(), 1, 1);
    for (const double degrees : {0, 30, 60, 85}) {
        const Vec3 eye = Vec3{0.3F, 0, 0.1F} + atAngle(degrees) * 3;
        EXPECT_NEAR(s.see(eye, {0.3F, 0, 0.1F}, test::exactSettings(60)), 1, 1e-4) << degrees;
    }
}

TEST(GlassFurnace, ASphereGivesBackAllOfAnEvenLight) {
    SceneBuilder b;
    b.sphere({0, 0, 0}, 1, 64, b.material(test::glass()));
    b.scene.background = {1, 1, 1};
    const TracedScene s(b.finish());
    double sum = 0;
    int count = 0;
    for (const float y : test::steps(-0.985F, 1.0F, 0.0371F)) {
        for (const float x : test::steps(-0.983F, 1.0F, 0.0373F)) {
            if (x * x + y * y > 0.98F) continue;
            const float seen = s.trace({x, y, 5}, {0, 0, -1}, test::exactSettings(60)).radiance.r;
            EXPECT_LE(seen, 1.0001F) << x << ' ' << y;
            EXPECT_GE(seen, 0.98F) << x << ' ' << y;
            sum += seen;
            ++count;
        }
    }
    EXPECT_NEAR(sum / count, 1, 1e-3);
}

TEST(GlassOff, WithoutRefractionsGlassIsOpaque) {
    RenderSettings settings = test::exactSettings();
    settings.refractions = false;
    const auto seen = slab(test::glass()).trace(kAbove, kDown, settings);
    EXPECT_EQ(seen.radiance, Colour{});
}

TEST(GlassOff, WithoutReflectionsAllOfTheLightPasses) {
    RenderSettings settings = test::exactSettings();
    settings.reflections = false;
    EXPECT_NEAR(slab(test::glass()).trace(kAbove, kDown, settings).radiance.r, 1, 1e-5);
}

} // namespace
} // namespace rtcore
