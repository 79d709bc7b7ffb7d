// Glass and mirrors on paths: furnaces, caustics, and what is counted once.

#include "path_support.h"

#include "rtcore/scattering/fresnel.h"
#include "rtcore/scattering/ggx-inl.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

namespace rtcore {
namespace {

TEST(PathFurnace, ClearGlassAndWhiteMirrorsVanishInEvenSurroundings) {
    for (const int kind : {0, 1, 2}) {
        test::SceneBuilder b;
        if (kind == 0) b.sphere({0, 0, 0}, 1, 24, b.material(test::glass()));
        if (kind == 1) b.sphere({0, 0, 0}, 1, 24, b.material(test::mirror(1)));
        if (kind == 2) b.square({0, 0, 0}, {0, 0, 1}, 3, b.material(test::glass()));
        b.scene.background = {1, 1, 1};
        const test::PathScene scene(b.finish(), test::exactSettings(200));
        for (const float x : {0.0F, 0.3F, 0.7F}) {
            const auto seen = scene.see({x, 0.1F, 4}, {0, 0, -1}, 4000, test::bouncesAlone(16));
            EXPECT_NEAR(seen.mean[0], 1, 5 * seen.error[0] + 1e-3) << kind << ' ' << x;
        }
    }
}

Material frosted(float roughness) {
    Material m = test::glass();
    m.roughness = roughness;
    return m;
}

TEST(PathFurnace, FrostedGlassVanishesInEvenSurroundings) {
    for (const float roughness : {0.1F, 0.4F, 1.0F}) {
        for (const bool solid : {false, true}) {
            test::SceneBuilder b;
            if (solid) b.sphere({0, 0, 0}, 1, 24, b.material(frosted(roughness)));
            if (!solid) b.square({0, 0, 0}, {0, 0, 1}, 3, b.material(frosted(roughness)));
            b.scene.background = {1, 1, 1};
            const test::PathScene scene(b.finish(), test::exactSettings(1000));
            for (const float x : {0.0F, 0.3F, 0.7F}) {
                const auto seen = scene.see({x, 0.1F, 4}, {0, 0, -1}, 4000, test::bouncesAlone(16));
                EXPECT_NEAR(seen.mean[0], 1, 5 * seen.error[0] + 2e-3)
                    << roughness << ' ' << solid << ' ' << x;
            }
        }
    }
}

/// A pane in front of a bright square, seen straight on: the part of the light that facets send there, by
/// their density (GGX) and by paths.
TEST(PathFurnace, FrostedPanesSpreadLightAsTheirFacetsDo) {
    for (const float roughness : {0.2F, 0.5F, 0.8F}) {
        test::SceneBuilder b;
        b.square({0, 0, 0}, {0, 0, 1}, 3, b.material(frosted(roughness)));
        b.square({0, 0, -1}, {0, 0, 1}, 0.5F, b.material(test::emitter({1, 1, 1})));
        const test::PathScene scene(b.finish());
        const int side = 400;
        double expected = 0;
        for (int y = 0; y < side; ++y) {
            for (int x = 0; x < side; ++x) {
                const auto at = [](int k) { return (static_cast<float>(k) + 0.5F) / side - 0.5F; };
                const Vec3 to{at(x), at(y), 1};
                const float distance = length(to);
                const auto facets = HWY_NAMESPACE::scatterGgx<float>({0, 0, 1}, {0, 0, 1}, to / distance,
                                                                     roughness * roughness);
                const float reflected = thinWallReflectance(fresnelDielectric(facets.fresnelCosine, 1.5F));
                const double solidAngle = 1.0 / side / side / std::pow(distance, 3);
                expected += facets.density * (1 - reflected) * solidAngle;
            }
        }
        const auto seen = scene.see({0, 0, 2}, {0, 0, -1}, 200000, test::bouncesAlone(4));
        EXPECT_NEAR(seen.mean[0], expected, 4 * seen.error[0] + 0.002 * expected) << roughness;
    }
}

/// A square that shines inside of a block of frosted glass that absorbs half of the light along 1, 1 below
/// its face: what facets send there of a ray straight on, by their density (GGX), Snell's and Fresnel's laws.
double throughFacets(double roughness, double half) {
    const double a2 = std::pow(roughness, 4);
    const int steps = 1500, turns = 180;
    double sum = 0;
    for (int i = 0; i < steps; ++i) {
        const double theta = (i + 0.5) / steps * test::kPi / 2, c = std::cos(theta), s = std::sin(theta);
        const double density = a2 / (test::kPi * std::pow((a2 - 1) * c * c + 1, 2)) * c * s;
        const double ct = std::sqrt(1 - s * s / 2.25);
        const double rs = (c - 1.5 * ct) / (c + 1.5 * ct), rp = (1.5 * c - ct) / (1.5 * c + ct);
        const double bent = theta - std::asin(s / 1.5);
        const double passes = (1 - (rs * rs + rp * rp) / 2) * std::pow(0.5, 1 / std::cos(bent));
        for (int k = 0; k < turns; ++k) {
            const double phi = 2 * test::kPi * (k + 0.5) / turns;
            const double edge = half / std::max(std::abs(std::cos(phi)), std::abs(std::sin(phi)));
            if (std::tan(bent) <= edge) sum += density * passes;
        }
    }
    return sum * (test::kPi / 2 / steps) * (2 * test::kPi / turns);
}

TEST(PathFurnace, FrostedSolidsBendLightAsTheirFacetsDo) {
    for (const float roughness : {0.3F, 0.6F}) {
        Material m = frosted(roughness);
        m.transmission = kWhite * 0.5F;
        m.attenuationDistance = 1;
        test::SceneBuilder b;
        b.box({-20, -20, -3}, {20, 20, 0}, b.material(m));
        b.square({0, 0, -1}, {0, 0, 1}, 0.1F, b.material(test::emitter({1, 1, 1})));
        const test::PathScene scene(b.finish(), test::exactSettings(1));
        const double expected = throughFacets(roughness, 0.1);
        const auto seen = scene.see({0, 0, 2}, {0, 0, -1}, 200000, test::bouncesAlone(2));
        EXPECT_LT(seen.error[0], 0.005 * expected);
        EXPECT_NEAR(seen.mean[0], expected, 3 * seen.error[0] + 0.002 * expected) << roughness;

        RayWave rays;
        std::vector<SampleId> ids;
        for (std::uint32_t i = 0; i < 16384; ++i) {
            rays.push({{0, 0, 2}, 0, {0, 0, -1}, std::numeric_limits<float>::max()});
            ids.push_back({static_cast<std::uint16_t>(i % 128), static_cast<std::uint16_t>(i / 128), 0});
        }
        WhittedIntegrator whitted(scene.traced.scene, scene.traced.tracer, scene.settings);
        whitted.trace(rays, ids);
        double sum = 0;
        for (std::size_t i = 0; i < rays.size(); ++i) sum += whitted.radiance().colourAt(i).r;
        const double deviation = std::sqrt(expected * (1 - expected) / 16384);
        EXPECT_NEAR(sum / 16384, expected, 4 * deviation) << roughness;
    }
}

TEST(PathFurnace, PhongHasItsAlbedo) {
    // c = .5 of the notes' table: the lobe alone, by next event and by scattered rays.
    for (const auto& [exponent, albedo] : std::array<std::pair<float, double>, 4>{
             {{1.0F, .6090}, {5.0F, .5194}, {20.0F, .5005}, {100.0F, .5000}}}) {
        test::SceneBuilder b;
        Material m = test::matte(0);
        m.specular = kWhite;
        m.shininess = exponent;
        b.square({0, 0, 0}, {0, 1, 0}, 1, b.material(m));
        b.scene.background = {1, 1, 1};
        const test::PathScene scene(b.finish());
        const Vec3 eye = test::atAngle(60);
        for (const SamplingStrategy strategy :
             {SamplingStrategy::Both, SamplingStrategy::NextEvent, SamplingStrategy::ScatteredRays}) {
            test::PathLimits limits = test::bouncesAlone(0);
            limits.strategy = strategy;
            const auto seen = scene.see(eye, -eye, 65536, limits);
            EXPECT_NEAR(seen.mean[0], albedo, 5 * seen.error[0] + 1e-4) << exponent;
        }
    }
}

/// A floor, a bright square above it, and a pane or a solid of glass between them.
Scene behindGlass(bool solid) {
    test::SceneBuilder b;
    b.square({0, 0, 0}, {0, 1, 0}, 2, b.material(test::matte(1)));
    b.quad({-.5F, 2, -.5F}, {.5F, 2, -.5F}, {.5F, 2, .5F}, {-.5F, 2, .5F},
           b.material(test::emitter({1, 1, 1})));
    const auto glass = b.material(test::glass());
    if (solid) b.box({-2, 1, -2}, {2, 1.2F, 2}, glass);
    if (!solid) b.square({0, 1, 0}, {0, 1, 0}, 2, glass);
    return b.finish();
}

TEST(PathCaustics, APaneLetsTheSameLightPassByBothWaysToCount) {
    const test::PathScene scene(behindGlass(false));
    test::PathLimits limits = test::bouncesAlone(0);
    const auto straight = scene.see({0, 0.1F, 0}, {0.2F, -1, 0}, 60000, limits);
    limits.caustics = true;
    const auto found = scene.see({0, 0.1F, 0}, {0.2F, -1, 0}, 60000, limits);
    EXPECT_GT(straight.mean[0], 0.05);
    EXPECT_NEAR(straight.mean[0], found.mean[0], 5 * std::hypot(straight.error[0], found.error[0]) + 2e-4);
}

TEST(PathCaustics, ASolidBendsItsLightOnlyWhereTheyCount) {
    const test::PathScene scene(behindGlass(true));
    test::PathLimits limits = test::bouncesAlone(0);
    limits.caustics = true;
    const auto bent = scene.see({0, 0.1F, 0}, {0.2F, -1, 0}, 60000, limits);
    limits.caustics = false;
    const auto straight = scene.see({0, 0.1F, 0}, {0.2F, -1, 0}, 60000, limits);
    // A slab moves light a little nearer: somewhat brighter than straight through it.
    EXPECT_GT(straight.mean[0], 0.04);
    EXPECT_NEAR(bent.mean[0], straight.mean[0], 0.15 * straight.mean[0]);
    limits.strategy = SamplingStrategy::ScatteredRays;
    const auto without = scene.see({0, 0.1F, 0}, {0.2F, -1, 0}, 20000, limits);
    EXPECT_NEAR(without.mean[0], straight.mean[0], 5 * std::hypot(straight.error[0], without.error[0]))
        << "rays that are bent are dropped, and next event has all of the light";
}

TEST(PathClamp, ClampBoundsWhatComesAfterTheFirstBounce) {
    test::SceneBuilder b;
    b.square({0, 0, 0}, {0, 1, 0}, 2, b.material(test::matte(0.9F)));
    b.square({0, 1, 0}, {0, -1, 0}, 2, b.material(test::matte(0.9F)));
    b.scene.lights = {test::pointLight({0, 0.5F, 0.3F}, 1)};
    const test::PathScene scene(b.finish());
    test::PathLimits limits = test::bouncesAlone(3);
    const Vec3 eye{1.5F, 0.5F, 0};
    const auto whole = scene.see(eye, {-1, -0.8F, 0}, 8000, limits);
    limits.clampIndirect = 0.05F;
    const auto clamped = scene.see(eye, {-1, -0.8F, 0}, 8000, limits);
    const auto direct = scene.see(eye, {-1, -0.8F, 0}, 8000, test::bouncesAlone(0));
    EXPECT_LT(clamped.mean[0], whole.mean[0] - 0.01);
    EXPECT_GT(clamped.mean[0], direct.mean[0]);
    EXPECT_LE(clamped.mean[0], direct.mean[0] + 3 * 0.05);
}

TEST(PathEmission, LightsNothingWhereALightStandsForIt) {
    test::SceneBuilder b;
    b.square({0, 0, 0}, {0, 1, 0}, 2, b.material(test::matte(0.5F)));
    b.sphere({0, 1, 0}, 0.1F, 8, b.material(test::emitter({30, 30, 30})));
    Scene flame = b.finish();
    const test::PathScene alone(flame, test::exactSettings(), EmitterLight::Automatic);
    flame.lights = {test::pointLight({0, 1, 0}, 1)};
    flame.lights[0].light.radius = 0.2F;
    const test::PathScene both(flame, test::exactSettings(), EmitterLight::Automatic);
    const test::PathScene counted(flame, test::exactSettings(), EmitterLight::On);
    const auto floor = [](const test::PathScene& scene) {
        return scene.see({1, 0.5F, 0}, {0, -1, 0}, 20000, test::bouncesAlone(0)).mean[0];
    };
    EXPECT_GT(floor(alone), 0.01);
    EXPECT_NEAR(floor(both), 0.5 / test::kPi / (2 * std::sqrt(2.0)), 1e-3) << "the light alone";
    EXPECT_NEAR(floor(counted), floor(alone) + floor(both), 0.01);
    EXPECT_EQ(both.see({0, 1, 3}, {0, 0, -1}, 10).mean[0], 30) << "it is seen all the same";
}

} // namespace
} // namespace rtcore
