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
    // Of any closed shape: rho phi / (pi A (1 - rho)), gi 5.3.
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

// --- The closed Cornell cube; the table was made by an independent program ---

struct CornellPoint {
    Vec3 place, normal;
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

void expectCornell(const test::PathScene& scene, LightFinding finding, std::uint32_t samples) {
    for (const CornellPoint& point : kCornell) {
        const Vec3 eye = point.place + point.normal * 0.1F;
        const std::array<double, 3> albedo{point.albedo.r, point.albedo.g, point.albedo.b};
        for (const int bounces : {0, 1, 2, 40}) {
            test::PathLimits limits = test::bouncesAlone(bounces);
            limits.rouletteFrom = 3;
            limits.finding = finding;
            const auto seen = scene.see(eye, -point.normal, samples, limits);
            for (std::size_t c = 0; c < 3; ++c) {
                const double irradiance = seen.mean[c] * test::kPi / albedo[c];
                double expected = point.direct;
                if (bounces > 0) expected += point.first[c];
                if (bounces > 1) expected += point.second[c];
                if (bounces > 2) expected = point.all[c];
                EXPECT_NEAR(irradiance, expected, 5 * seen.error[c] * test::kPi / albedo[c] + 1e-4)
                    << point.place.x << ' ' << point.place.y << " bounces " << bounces << " channel " << c;
            }
        }
    }
}

TEST(CornellCube, HasTheLightOfEachBounceByAnEmitter) {
    const test::PathScene scene(cornell(true));
    expectCornell(scene, LightFinding::Both, 16384);
    expectCornell(scene, LightFinding::NextEvent, 8192);
    expectCornell(scene, LightFinding::ScatteredRays, 16384);
}

TEST(CornellCube, HasTheLightOfEachBounceByARectangle) {
    const test::PathScene scene(cornell(false));
    expectCornell(scene, LightFinding::Both, 16384);
    expectCornell(scene, LightFinding::NextEvent, 8192);
    expectCornell(scene, LightFinding::ScatteredRays, 16384);
}

} // namespace
} // namespace rtcore
