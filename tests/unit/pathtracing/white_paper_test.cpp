// White paper that is not there is lit as a white surface that is, whatever is around.
#include "path_support.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace rtcore {
namespace white_paper {
namespace {

struct PaperCase {
    std::string name;
    std::function<void(test::SceneBuilder&)> furnish;
};

Light ball(Vec3 position) {
    Light light = test::pointLight(position, 3);
    light.kind = LightKind::Sphere;
    light.radius = 0.3F;
    return light;
}

void addLit(test::SceneBuilder& b) {
    b.scene.lights = {ball({0.5F, 2, 0}), test::pointLight({-2, 3, 1}, 5)};
    b.scene.background = {0.5F, 0.7F, 1};
    b.quad({-2, 1, -2}, {-1, 1, -2}, {-1, 1, -1}, {-2, 1, -1}, b.material(test::emitter({2, 1, 1})));
    b.box({1, 0, -1}, {2, 1.5F, 1}, b.material(test::matte(0.7F)));
}

void addPane(test::SceneBuilder& b) {
    addLit(b);
    Material pane = test::glass(1.5F);
    pane.transmission = {0.6F, 0.8F, 0.9F};
    b.square({0, 0.8F, 0}, {0, 1, 0}, 0.7F, b.material(pane));
}

void addMetal(test::SceneBuilder& b) {
    addLit(b);
    Material metal;
    metal.diffuse = {0.9F, 0.6F, 0.3F};
    metal.roughness = 0.4F;
    metal.metallic = 1;
    metal.coat = 0.5F;
    metal.coatRoughness = 0.2F;
    b.square({-0.8F, 0.5F, 0}, {1, 0, 0}, 0.6F, b.material(metal));
    b.square({0, 0.5F, 0.8F}, {0, 0, -1}, 0.6F, b.material(test::mirror(0.9F)));
}

void addFog(test::SceneBuilder& b) {
    addLit(b);
    b.scene.fog.kind = FogKind::Homogeneous;
    b.scene.fog.density = 0.3F;
    b.scene.fog.colour = {0.2F, 0.2F, 0.3F};
}

void addWater(test::SceneBuilder& b) {
    addLit(b);
    Material water = test::glass(1.33F);
    water.attenuationDistance = 0.5F;
    water.transmission = {0.7F, 0.8F, 0.9F};
    b.box({-0.6F, -0.5F, -0.6F}, {0.6F, 0.4F, 0.6F}, b.material(water));
}

void addManyLights(test::SceneBuilder& b) {
    for (int i = 0; i < 50; ++i)
        b.scene.lights.emplace_back(
            test::pointLight({static_cast<float>(i % 10) - 4.5F, 2, static_cast<float>(i / 10) - 2}, 1));
}

/// Of paths that light a point just above the origin.
test::PathMean onPaper(const test::PathScene& scene, std::uint32_t count) {
    test::PathMean result;
    std::array<double, 3> sum{}, squares{};
    PathIntegrator integrator;
    integrator.begin(
        {scene.traced.scene, scene.traced.tracer, scene.settings, scene.materials, scene.lights});
    for (std::uint32_t first = 0; first < count; first += 4096) {
        const std::vector<WhitePoint> points(4096, {{0, 1e-4F, 0}, {0, 1, 0}});
        std::vector<SampleId> ids;
        for (std::uint32_t i = first; i < first + 4096; ++i)
            ids.push_back({static_cast<std::uint16_t>(i), 1, 0});
        integrator.traceWhite(points, ids);
        for (std::size_t i = 0; i < points.size(); ++i) {
            const Colour c = integrator.radiance().colourAt(i);
            const std::array<double, 3> values{c.r, c.g, c.b};
            for (std::size_t k = 0; k < 3; ++k) {
                sum[k] += values[k];
                squares[k] += values[k] * values[k];
            }
        }
    }
    for (std::size_t k = 0; k < 3; ++k) {
        result.mean[k] = sum[k] / count;
        const double variance = std::max(squares[k] / count - result.mean[k] * result.mean[k], 0.0);
        result.error[k] = std::sqrt(variance / count);
    }
    return result;
}

TEST(WhitePaper, IsLitAsAWhiteSurface) {
    constexpr std::uint32_t kPaths = 16384;
    const std::vector<PaperCase> cases{{"in the open", addLit}, {"below a pane", addPane},
                                       {"by metal", addMetal},  {"in fog", addFog},
                                       {"in water", addWater},  {"by many lights", addManyLights}};
    for (const PaperCase& each : cases) {
        test::SceneBuilder b;
        each.furnish(b);
        b.square({0, 0, 0}, {0, 1, 0}, 0.02F, b.material(test::matte(1)));
        const test::PathScene scene(b.finish());
        const test::PathMean surface = scene.see({0, 1e-3F, 0}, {0, -1, 0}, kPaths);
        const test::PathMean paper = onPaper(scene, kPaths);
        for (std::size_t k = 0; k < 3; ++k) {
            EXPECT_GT(surface.mean[k], 0.01) << each.name;
            EXPECT_NEAR(paper.mean[k], surface.mean[k],
                        5 * std::hypot(paper.error[k], surface.error[k]) + 1e-3 * surface.mean[k])
                << each.name;
            EXPECT_LT(surface.error[k], 0.03 * surface.mean[k]) << each.name << ": it says little";
        }
    }
}

/// Points of one wave may differ, and a point's light depends on nothing but its name.
TEST(WhitePaper, DependsOnItsOwnPointAlone) {
    test::SceneBuilder b;
    addLit(b);
    const test::PathScene scene(b.finish());
    PathIntegrator integrator;
    integrator.begin(
        {scene.traced.scene, scene.traced.tracer, scene.settings, scene.materials, scene.lights});
    std::vector<WhitePoint> points;
    std::vector<SampleId> ids;
    for (int i = 0; i < 5000; ++i) {
        points.push_back({{0.001F * static_cast<float>(i), 0.1F, 0}, {0, i % 2 == 0 ? 1.0F : -1.0F, 0}});
        ids.push_back({static_cast<std::uint16_t>(i), 0, 3});
    }
    integrator.traceWhite(points, ids);
    std::vector<Colour> together;
    for (std::size_t i = 0; i < points.size(); ++i) together.push_back(integrator.radiance().colourAt(i));
    for (const std::size_t i : {0U, 63U, 64U, 2047U, 2048U, 4999U}) {
        integrator.traceWhite({&points[i], 1}, {&ids[i], 1});
        EXPECT_EQ(integrator.radiance().colourAt(0), together[i]) << i;
    }
}

} // namespace
} // namespace white_paper
} // namespace rtcore
