// Closed rooms whose light has a closed form.

#include "path_support.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace rtcore {
namespace {

/// A cube [0,1]^3 seen from inside, all faces of one material.
Scene cube(const Material& material) {
    test::SceneBuilder b;
    const auto m = b.material(material);
    b.quad({0, 0, 0}, {0, 0, 1}, {1, 0, 1}, {1, 0, 0}, m);
    b.quad({0, 1, 0}, {1, 1, 0}, {1, 1, 1}, {0, 1, 1}, m);
    b.quad({0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, m);
    b.quad({0, 0, 1}, {0, 1, 1}, {1, 1, 1}, {1, 0, 1}, m);
    b.quad({0, 0, 0}, {0, 1, 0}, {0, 1, 1}, {0, 0, 1}, m);
    b.quad({1, 0, 0}, {1, 0, 1}, {1, 1, 1}, {1, 1, 0}, m);
    return b.finish();
}

TEST(Enclosure, ThatGlowsSumsAGeometricSeries) {
    for (const double albedo : {0.5, 0.8}) {
        Material m = test::matte(static_cast<float>(albedo));
        m.emission = {1, 1, 1};
        const test::PathScene scene(cube(m));
        for (const int bounces : {0, 1, 8, 16}) {
            const auto seen =
                scene.see({0.4F, 0.5F, 0.6F}, {0.3F, -0.5F, 0.2F}, 20000, test::bouncesAlone(bounces));
            // Light that scatters once is direct light: bounces + 1 scatterings.
            const double expected = (1 - std::pow(albedo, bounces + 2)) / (1 - albedo);
            EXPECT_NEAR(seen.mean[0], expected, 5 * seen.error[0] + 1e-5) << albedo << ' ' << bounces;
        }
    }
}

TEST(Enclosure, ThatGlowsIsTheSameWithRouletteFromAnyBounce) {
    Material m = test::matte(0.5F);
    m.emission = {1, 1, 1};
    const test::PathScene scene(cube(m));
    for (const int from : {0, 1, 3, 8, 1000}) {
        test::PathLimits limits = test::bouncesAlone(64);
        limits.rouletteFrom = from;
        const auto seen = scene.see({0.4F, 0.5F, 0.6F}, {0.3F, -0.5F, 0.2F}, 40000, limits);
        EXPECT_NEAR(seen.mean[0], 2, 5 * seen.error[0] + 1e-5) << from;
        EXPECT_GT(seen.error[0], 0);
    }
}

TEST(Enclosure, WithAPointLightHasTheMeanOfItsPower) {
    // For any closed shape: rho phi / (pi A (1 - rho)), gi 5.3.
    Scene lit = cube(test::matte(0.5F));
    lit.lights = {test::pointLight({0.3F, 0.6F, 0.45F}, 1)};
    const test::PathScene scene(std::move(lit));
    test::PathLimits limits = test::bouncesAlone(40);
    limits.rouletteFrom = 3;
    const auto seen = scene.mean(120000, limits, [](std::uint32_t i) {
        const SampleId id{static_cast<std::uint16_t>(i), 7, i >> 16};
        const SquarePoint p = randomShift(id, SampleDimension::Occlusion);
        const float far = static_cast<float>(i % 2), near = 0.5F;
        const std::array<Vec3, 3> from{Vec3{near, p.u, p.v}, Vec3{p.u, near, p.v}, Vec3{p.u, p.v, near}};
        const std::array<Vec3, 3> to{Vec3{far, p.u, p.v}, Vec3{p.u, far, p.v}, Vec3{p.u, p.v, far}};
        const std::size_t axis = i / 2 % 3;
        return std::pair(from[axis], to[axis] - from[axis]);
    });
    EXPECT_NEAR(seen.mean[0], 2.0 / 3, 5 * seen.error[0]);
    EXPECT_LT(seen.error[0], 0.01);
}

/// A unit sphere seen from inside; `cap` is the share of its area, around its highest point, of the first
/// material.
Scene hollowSphere(const Material& first, const Material& rest, double cap) {
    test::SceneBuilder b;
    const auto above = b.material(first), below = b.material(rest);
    constexpr int kSlices = 96, kCapRings = 12, kRings = 60;
    const double edge = std::acos(1 - 2 * cap);
    const auto polar = [&](int ring) {
        if (ring <= kCapRings) return edge * ring / kCapRings;
        return edge + (test::kPi - edge) * (ring - kCapRings) / (kRings - kCapRings);
    };
    const auto at = [&](int ring, int slice) {
        const double azimuth = 2 * test::kPi * (slice % kSlices) / kSlices, across = std::sin(polar(ring));
        return Vec3{static_cast<float>(across * std::cos(azimuth)), static_cast<float>(std::cos(polar(ring))),
                    static_cast<float>(across * std::sin(azimuth))};
    };
    for (int slice = 0; slice < kSlices; ++slice) {
        b.triangle(at(0, 0), at(1, slice), at(1, slice + 1), above);
        b.triangle(at(kRings, 0), at(kRings - 1, slice + 1), at(kRings - 1, slice), below);
        for (int ring = 1; ring + 1 < kRings; ++ring) {
            b.quad(at(ring, slice), at(ring + 1, slice), at(ring + 1, slice + 1), at(ring, slice + 1),
                   ring < kCapRings ? above : below);
        }
    }
    return b.finish();
}

TEST(Enclosure, SphereWithABlackCapIsAsBrightEverywhere) {
    // E / pi = f Le / (1 - (1 - f) rho); the facets of the sphere change it by less than 0.0005.
    constexpr double kFraction = 0.1, kAlbedo = 0.7;
    const double expected = kAlbedo * kFraction / (1 - (1 - kFraction) * kAlbedo);
    const test::PathScene scene(
        hollowSphere(test::emitter({1, 1, 1}), test::matte(static_cast<float>(kAlbedo)), kFraction));
    test::PathLimits limits = test::bouncesAlone(64);
    limits.rouletteFrom = 4;
    for (const Vec3 to : {Vec3{0.1F, -1, 0.2F}, Vec3{1, 0.3F, 0.2F}}) {
        test::expectLight(scene, {0.05F, 0.1F, 0.02F}, to, 30000, limits, expected,
                          "towards y = " + std::to_string(to.y), 5e-4);
    }
}

TEST(Enclosure, SphereWithALightInItsMiddleIsAsBrightEverywhere) {
    // rho I / (pi R^2 (1 - rho)); facets are a little nearer, and here seen where they are nearest.
    Scene lit = hollowSphere(test::matte(0.5F), test::matte(0.5F), 0.1);
    lit.lights = {test::pointLight({0, 0, 0}, static_cast<float>(test::kPi))};
    const test::PathScene scene(std::move(lit));
    const auto seen = scene.see({0.2F, 0.1F, 0}, {1, 0.2F, 0.1F}, 40000, test::bouncesAlone(40));
    EXPECT_NEAR(seen.mean[0], 1, 5 * seen.error[0] + 0.003);
    EXPECT_LT(seen.error[0], 0.003);
}

// --- The closed Cornell cube; the table was made by an independent program ---

struct CornellPoint {
    Vec3 position, normal;
    Colour albedo;
    double direct;
    std::array<double, 3> first, second, all;
};

constexpr Colour kWhiteWall{0.725F, 0.71F, 0.68F}, kRedWall{0.63F, 0.065F, 0.05F},
    kGreenWall{0.14F, 0.45F, 0.091F};
const std::array<CornellPoint, 5> kCornell{{
    {{.5F, 0, .5F},
     {0, 1, 0},
     kWhiteWall,
     .151918,
     {.04382, .03819, .02963},
     {.02976, .02406, .01620},
     {.26302, .23790, .20829}},
    {{.1F, 0, .1F},
     {0, 1, 0},
     kWhiteWall,
     .090775,
     {.03517, .02525, .02130},
     {.03291, .02005, .01536},
     {.20414, .15494, .13719}},
    {{0, .5F, .5F},
     {1, 0, 0},
     kRedWall,
     .150559,
     {.05098, .05761, .04683},
     {.02780, .02663, .01775},
     {.26685, .26377, .22836}},
    {{.5F, .5F, 0},
     {0, 0, 1},
     kWhiteWall,
     .150559,
     {.05110, .04502, .03574},
     {.02784, .02230, .01471},
     {.26742, .24196, .21184}},
    {{.1F, 1, .5F},
     {0, -1, 0},
     kWhiteWall,
     0,
     {.07631, .04701, .04132},
     {.02734, .01570, .01086},
     {.14859, .08166, .06164}},
}};

Scene cornell(bool emitter) {
    test::SceneBuilder b;
    const auto wall = [&](Colour albedo) {
        Material m = test::matte(0);
        m.diffuse = albedo;
        return b.material(m);
    };
    const auto white = wall(kWhiteWall), red = wall(kRedWall), green = wall(kGreenWall);
    b.quad({0, 0, 0}, {0, 0, 1}, {1, 0, 1}, {1, 0, 0}, white);
    b.quad({0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, white);
    b.quad({0, 0, 1}, {0, 1, 1}, {1, 1, 1}, {1, 0, 1}, white);
    b.quad({0, 0, 0}, {0, 1, 0}, {0, 1, 1}, {0, 0, 1}, red);
    b.quad({1, 0, 0}, {1, 0, 1}, {1, 1, 1}, {1, 1, 0}, green);
    // The ceiling around the emitter, whose place is black.
    b.quad({0, 1, 0}, {1, 1, 0}, {1, 1, .3F}, {0, 1, .3F}, white);
    b.quad({0, 1, .7F}, {1, 1, .7F}, {1, 1, 1}, {0, 1, 1}, white);
    b.quad({0, 1, .3F}, {.3F, 1, .3F}, {.3F, 1, .7F}, {0, 1, .7F}, white);
    b.quad({.7F, 1, .3F}, {1, 1, .3F}, {1, 1, .7F}, {.7F, 1, .7F}, white);
    b.quad({.3F, 1, .3F}, {.7F, 1, .3F}, {.7F, 1, .7F}, {.3F, 1, .7F},
           b.material(emitter ? test::emitter({1, 1, 1}) : test::matte(0)));
    Scene scene = b.finish();
    if (emitter) return scene;
    Light light;
    light.kind = LightKind::Rectangle;
    light.position = {.5F, 0.99999F, .5F};
    light.direction = {0, -1, 0};
    light.right = {1, 0, 0};
    light.width = light.height = 0.4F;
    light.intensity = kWhite * (0.4F * 0.4F); // of radiance 1
    scene.lights = {light};
    return scene;
}

void expectCornell(const test::PathScene& scene, SamplingStrategy strategy, std::uint32_t samples) {
    for (const CornellPoint& point : kCornell) {
        const Vec3 eye = point.position + point.normal * 0.1F;
        const std::array<double, 3> albedo{point.albedo.r, point.albedo.g, point.albedo.b};
        for (const int bounces : {0, 1, 2, 40}) {
            test::PathLimits limits = test::bouncesAlone(bounces);
            limits.rouletteFrom = 3;
            limits.strategy = strategy;
            const auto seen = scene.see(eye, -point.normal, samples, limits);
            for (std::size_t c = 0; c < 3; ++c) {
                const double irradiance = seen.mean[c] * test::kPi / albedo[c];
                double expected = point.direct;
                if (bounces > 0) expected += point.first[c];
                if (bounces > 1) expected += point.second[c];
                if (bounces > 2) expected = point.all[c];
                EXPECT_NEAR(irradiance, expected, 5 * seen.error[c] * test::kPi / albedo[c] + 1e-4)
                    << point.position.x << ' ' << point.position.y << " bounces " << bounces << " channel "
                    << c;
            }
        }
    }
}

TEST(CornellCube, HasTheLightOfEachBounceByAnEmitter) {
    const test::PathScene scene(cornell(true));
    expectCornell(scene, SamplingStrategy::Both, 16384);
    expectCornell(scene, SamplingStrategy::NextEvent, 8192);
    expectCornell(scene, SamplingStrategy::ScatteredRays, 16384);
}

TEST(CornellCube, HasTheLightOfEachBounceByARectangle) {
    const test::PathScene scene(cornell(false));
    expectCornell(scene, SamplingStrategy::Both, 16384);
    expectCornell(scene, SamplingStrategy::NextEvent, 8192);
    expectCornell(scene, SamplingStrategy::ScatteredRays, 16384);
}

TEST(CornellCube, SamplesOfOnePixelConvergeFasterThanIndependentOnes) {
    // Root mean square error of the first bounce by means of 256 samples.
    constexpr std::uint32_t kPixels = 512, kSamples = 256;
    const test::PathScene scene(cornell(true));
    const CornellPoint& point = kCornell[0];
    const double expected = point.first[0] * point.albedo.r / test::kPi;
    test::PathLimits direct = test::bouncesAlone(0), both = test::bouncesAlone(1);
    direct.strategy = both.strategy = SamplingStrategy::NextEvent;
    const auto error = [&](bool ofOnePixel) {
        double squares = 0;
        for (std::uint32_t pixel = 0; pixel < kPixels; ++pixel) {
            RayWave rays;
            std::vector<SampleId> ids;
            for (std::uint32_t i = 0; i < kSamples; ++i) {
                rays.push({point.position + point.normal * 0.1F, 0, -point.normal,
                           std::numeric_limits<float>::max()});
                const auto x = static_cast<std::uint16_t>(pixel), y = static_cast<std::uint16_t>(i);
                ids.push_back(ofOnePixel ? SampleId{x, 0, i} : SampleId{x, y, 0});
            }
            double sum = 0;
            for (const Colour c : scene.trace(rays, ids, both)) sum += c.r;
            for (const Colour c : scene.trace(rays, ids, direct)) sum -= c.r;
            squares += std::pow(sum / kSamples - expected, 2);
        }
        return std::sqrt(squares / kPixels);
    };
    const double independent = error(false);
    EXPECT_LT(error(true), 0.6 * independent);
    EXPECT_LT(independent, 0.1 * expected);
}

} // namespace
} // namespace rtcore
