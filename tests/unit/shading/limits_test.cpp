// Depth and contribution bound the work, and hostile scenes bound it still.
#include "support/small_scene.h"

#include <gtest/gtest.h>

#include <cmath>

#include <sys/resource.h>

namespace rtcore {
namespace {

using test::SceneBuilder;
using test::TracedScene;

std::uint64_t rays(const TracedScene::Result& result, RayKind kind) {
    return result.statistics.rays[static_cast<std::size_t>(kind)];
}

TracedScene facingMirrors(float reflectance) {
    SceneBuilder b;
    const auto m = b.material(test::mirror(reflectance));
    b.square({0, 0, 0}, {1, 0, 0}, 10, m);
    b.square({1, 0, 0}, {-1, 0, 0}, 10, m);
    return TracedScene(b.finish());
}

TEST(Limits, DepthBoundsMirroredRays) {
    const TracedScene s = facingMirrors(1);
    for (const int depth : {0, 1, 7, 1000}) {
        const auto result = s.trace({0.5F, 0.3F, 0.2F}, {1, 0, 0}, test::exactSettings(depth));
        EXPECT_EQ(rays(result, RayKind::Primary), 1U);
        EXPECT_EQ(rays(result, RayKind::Mirror), static_cast<std::uint64_t>(depth));
    }
}

TEST(Limits, RaysThatMatterLittleAreNotTraced) {
    const TracedScene s = facingMirrors(0.5F);
    RenderSettings settings = test::exactSettings(100);
    settings.minContribution = 0.1F; // 0.5, 0.25, 0.125
    EXPECT_EQ(rays(s.trace({0.5F, 0.3F, 0.2F}, {1, 0, 0}, settings), RayKind::Mirror), 3U);
    settings.minContribution = 0.125F;
    EXPECT_EQ(rays(s.trace({0.5F, 0.3F, 0.2F}, {1, 0, 0}, settings), RayKind::Mirror), 3U);
    settings.minContribution = 1;
    EXPECT_EQ(rays(s.trace({0.5F, 0.3F, 0.2F}, {1, 0, 0}, settings), RayKind::Mirror), 0U);
}

TEST(Limits, BlackMirrorsSendNoRays) {
    const TracedScene s = facingMirrors(0);
    EXPECT_EQ(rays(s.trace({0.5F, 0.3F, 0.2F}, {1, 0, 0}), RayKind::Mirror), 0U);
}

TEST(Limits, SurfacesTurnedFromALightSendNoShadowRays) {
    SceneBuilder b;
    b.square({0, 0, 0}, {0, 1, 0}, 10, b.material(test::matte(1)));
    b.scene.lights = {test::pointLight({0, -1, 0}, 1), test::pointLight({0, 1, 0}, 0),
                      test::pointLight({0, 2, 0}, 1)};
    EXPECT_EQ(rays(TracedScene(b.finish()).trace({1, 2, 0}, {0, -1, 0}), RayKind::Shadow), 1U);
}

/// Most memory that the process ever had, in MiB.
double peakMemory() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return static_cast<double>(usage.ru_maxrss) / 1024;
}

/// As many rays as a tile has, all through the same stack.
double traceTile(const TracedScene& s, const RenderSettings& settings, std::uint64_t& total) {
    RayWave wave;
    for (int i = 0; i < 1024; ++i) {
        const auto x = static_cast<float>(i % 32) * 0.01F, y = static_cast<float>(i >> 5) * 0.01F;
        wave.push({{x, y, 5}, 0, normalize({0.1F * x, 0.1F * y, -1}), 1e30F});
    }
    std::vector<Colour> radiance(wave.size());
    std::vector<std::uint8_t> hit(wave.size());
    const double before = peakMemory();
    WhittedIntegrator integrator(s.scene, s.tracer, settings);
    integrator.trace(wave, radiance, hit);
    total = integrator.statistics().total();
    for (const Colour c : radiance) EXPECT_TRUE(isFinite(c));
    return peakMemory() - before;
}

TracedScene stackOfPanes(const Material& material) {
    SceneBuilder b;
    const auto glass = b.material(material);
    for (int i = 0; i < 1000; ++i) b.square({0, 0, -0.01F * static_cast<float>(i)}, {0, 0, 1}, 50, glass);
    b.scene.background = {1, 1, 1};
    b.scene.lights.push_back(test::pointLight({0, 0, 6}, 10));
    return TracedScene(b.finish());
}

TEST(Limits, AThousandPanesEnd) {
    RenderSettings settings;
    settings.maxDepth = 1000;
    std::uint64_t total = 0;
    const double memory = traceTile(stackOfPanes(test::glass()), settings, total);
    RecordProperty("rays", std::to_string(total));
    RecordProperty("megabytes", std::to_string(memory));
    EXPECT_LT(memory, 200);
    EXPECT_GT(total, 1024U * 100);
}

TEST(Limits, AThousandPanesWithoutFresnelPassTheirLight) {
    Material m = test::glass(1);
    m.transmission = {0.999F, 0.999F, 0.999F};
    const TracedScene s = stackOfPanes(m);
    const float seen = s.trace({0.1F, 0.2F, 5}, {0, 0, -1}, test::exactSettings(1000)).radiance.r;
    EXPECT_NEAR(seen, std::pow(0.999, 1000), 1e-4);
}

TEST(Limits, AThousandShinyHolesEnd) {
    // Each leaf half covers, scatters, mirrors and lets pass.
    SceneBuilder b;
    Material m = test::glass();
    m.opacity = 0.5F;
    m.diffuse = {0.5F, 0.5F, 0.5F};
    m.alphaTexture = b.texture(1, 1, {{250, 0, 0, 255}});
    const auto leaf = b.material(m);
    for (int i = 0; i < 1000; ++i) b.square({0, 0, -0.01F * static_cast<float>(i)}, {0, 0, 1}, 50, leaf);
    b.scene.lights.push_back(test::pointLight({0, 0, 6}, 10));
    RenderSettings settings;
    settings.maxDepth = 1000;
    std::uint64_t total = 0;
    EXPECT_LT(traceTile(TracedScene(b.finish()), settings, total), 200);
}

} // namespace
} // namespace rtcore
