// Materials of the metallic-roughness model: the same light by paths and by Whitted's ray tracing, and none
// that is lost or gained.

#include "path_support.h"

#include "support/steps.h"

#include "rtcore/scene/metallic_roughness.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

namespace rtcore {
namespace {

Material metallicMaterial(Colour base, float metallic, float roughness) {
    Material m;
    setMetallicRoughness(m, base, metallic, roughness);
    return m;
}

Material varnished(Colour base, float metallic, float roughness, float coat, float coatRoughness) {
    Material m = metallicMaterial(base, metallic, roughness);
    m.coat = coat;
    m.coatRoughness = coatRoughness;
    return m;
}

/// Metal and plastic from nearly smooth to rough, one with a texture of both, some varnished.
Scene metallicScene() {
    test::SceneBuilder b;
    b.square({0, 0, 0}, {0, 1, 0}, 4, b.material(metallicMaterial({0.6F, 0.5F, 0.4F}, 0, 0.5F)));
    b.sphere({-1.5F, 1, 0}, 0.7F, 16, b.material(metallicMaterial({0.9F, 0.6F, 0.3F}, 1, 0.1F)));
    b.sphere({1, 0.8F, 0.5F}, 0.7F, 16, b.material(metallicMaterial({0.2F, 0.4F, 0.9F}, 0.3F, 0.8F)));
    b.sphere({-0.2F, 0.5F, 1.5F}, 0.4F, 16,
             b.material(varnished({0.1F, 0.3F, 0.5F}, 0.5F, 0.6F, 0.9F, 0.15F)));
    b.sphere({2, 0.4F, 1.5F}, 0.4F, 16, b.material(varnished({0.8F, 0.3F, 0.1F}, 0, 0.3F, 0.6F, 0.7F)));
    Material varied = metallicMaterial({0.8F, 0.8F, 0.6F}, 1, 1);
    varied.metallicRoughnessTexture =
        b.texture(2, 2, {{0, 60, 255, 255}, {0, 255, 0, 255}, {0, 128, 128, 255}, {0, 200, 30, 255}});
    b.square({0, 1, -1}, {0, 0, 1}, 1, b.material(varied));
    return b.finish();
}

Light metallicSun() {
    Light light;
    light.kind = LightKind::Directional;
    light.direction = normalize({-1, -2, -1.5F});
    light.intensity = {3, 2, 1};
    return light;
}

TEST(MetallicPaths, DirectLightIsThatOfWhitted) {
    for (const Light& light : {test::pointLight({2, 3, 3}, 30), metallicSun()}) {
        Scene lit = metallicScene();
        lit.lights = {light};
        RenderSettings settings = test::exactSettings();
        settings.reflections = false; // of smooth surfaces Whitted's rays show the surroundings
        const test::PathScene scene(std::move(lit), settings);
        RayWave rays;
        std::vector<SampleId> ids;
        const Vec3 eye{0.3F, 2.5F, 6};
        for (const float y : test::steps(-1.0F, 2.0F, 0.11F)) {
            for (const float x : test::steps(-2.5F, 2.5F, 0.13F)) {
                rays.push({eye, 0, normalize(Vec3{x, y, 0} - eye), std::numeric_limits<float>::max()});
                ids.push_back({static_cast<std::uint16_t>(ids.size()), 0, 0});
            }
        }
        const std::vector<Colour> seen = scene.trace(rays, ids, test::bouncesAlone(0));
        std::size_t lightened = 0;
        for (std::size_t i = 0; i < seen.size(); ++i) {
            const Ray ray = rays.ray(i);
            const Colour whitted = scene.traced.trace(ray.origin, ray.direction, settings).radiance;
            EXPECT_NEAR(seen[i].r, whitted.r, 1e-5 * whitted.r + 1e-7) << i;
            EXPECT_NEAR(seen[i].b, whitted.b, 1e-5 * whitted.b + 1e-7) << i;
            lightened += whitted.r > 0 ? 1 : 0;
        }
        EXPECT_GT(lightened, seen.size() / 2);
    }
}

/// Of an even light, at several angles.
void expectAllGivenOff(const Material& m, double tolerance) {
    test::SceneBuilder b;
    b.square({0, 0, 0}, {0, 1, 0}, 100, b.material(m));
    Scene lit = b.finish();
    lit.background = kWhite;
    const test::PathScene scene(std::move(lit));
    for (const double angle : {0.0, 60.0, 80.0}) {
        const Vec3 to = -test::atAngle(angle);
        const test::PathMean seen = scene.see(-to, to, 8192, test::bouncesAlone(3));
        EXPECT_NEAR(seen.mean[1], 1, 5 * seen.error[1] + tolerance)
            << m.metallic << ' ' << m.roughness << ' ' << m.coatRoughness << ' ' << angle;
    }
}

TEST(MetallicPaths, WhiteSurfacesGiveOffAllLight) {
    for (const float metallic : {0.0F, 0.5F, 1.0F}) {
        for (const float roughness : {0.0F, 0.1F, 0.3F, 0.6F, 1.0F})
            expectAllGivenOff(metallicMaterial(kWhite, metallic, roughness), 0.006);
    }
}

TEST(MetallicPaths, VarnishedWhiteSurfacesGiveOffAllLight) {
    for (const float metallic : {0.0F, 1.0F}) {
        for (const float roughness : {0.0F, 0.2F, 0.7F})
            expectAllGivenOff(varnished(kWhite, metallic, 0.4F, 1, roughness), 0.008);
    }
}

/// By paths and by Whitted's rays: Schlick's curve of 0.04.
/// GGX of a dielectric, times the cosine of the light, in double. Both in the plane y = 0, or the light
/// turned about the normal z by `phi`.
double coatLobe(double roughness, double viewer, double light, double phi) {
    const double a2 = std::pow(roughness, 4), cv = std::cos(viewer), cl = std::cos(light);
    const double x = std::sin(viewer) + std::sin(light) * std::cos(phi), y = std::sin(light) * std::sin(phi);
    const double size = std::sqrt(x * x + y * y + (cv + cl) * (cv + cl)), ch = (cv + cl) / size;
    const double half = std::sqrt((1 + cv * cl + std::sin(viewer) * std::sin(light) * std::cos(phi)) /
                                  2); // between light and facet
    const auto lambda = [&](double c) { return (std::sqrt(1 + a2 * (1 / (c * c) - 1)) - 1) / 2; };
    const double d = a2 / (test::kPi * std::pow((a2 - 1) * ch * ch + 1, 2));
    return (0.04 + 0.96 * std::pow(1 - half, 5)) * d / (1 + lambda(cv) + lambda(cl)) / (4 * cv);
}

TEST(MetallicPaths, VarnishAddsItsLobeToWhatItLeaves) {
    const double roughness = 0.4, weight = 0.8, towards = 0.5;
    const auto seen = [&](double coat, double viewer) {
        test::SceneBuilder b;
        b.square({0, 0, 0}, {0, 0, 1}, 9,
                 b.material(varnished({0.05F, 0.05F, 0.05F}, 0, 1, static_cast<float>(coat), 0.4F)));
        b.scene.lights.emplace_back(test::pointLight(
            {-4 * static_cast<float>(std::sin(towards)), 0, 4 * static_cast<float>(std::cos(towards))}, 16));
        const test::PathScene scene(b.finish());
        const Vec3 eye{static_cast<float>(std::sin(viewer)), 0, static_cast<float>(std::cos(viewer))};
        const auto paths = scene.see(eye, -eye, 100, test::bouncesAlone(0));
        const double whitted = scene.traced.see(eye, {0, 0, 0});
        EXPECT_NEAR(paths.mean[0] / whitted, 1, 1e-4);
        return whitted;
    };
    for (const double viewer : {0.1, 0.5, 0.9}) {
        double albedo = 0;
        const int steps = 400;
        for (int i = 0; i < steps; ++i) {
            for (int k = 0; k < steps; ++k) {
                const double light = (i + 0.5) / steps * test::kPi / 2,
                             phi = 2 * test::kPi * (k + 0.5) / steps;
                albedo += coatLobe(roughness, viewer, light, phi) * std::sin(light);
            }
        }
        albedo *= test::kPi / 2 / steps * 2 * test::kPi / steps;
        const double below = seen(0, viewer) * (1 - weight * albedo);
        const double expected = weight * coatLobe(roughness, viewer, towards, test::kPi) + below;
        EXPECT_NEAR(seen(weight, viewer) / expected, 1, 0.005) << viewer;
    }
}

TEST(MetallicPaths, SmoothVarnishMirrors) {
    test::SceneBuilder b;
    b.square({0, 0, 0}, {0, 1, 0}, 2, b.material(varnished({0, 0, 0}, 1, 1, 0.8F, 0)));
    b.square({0, 3, 0}, {0, -1, 0}, 30, b.material(test::emitter({1, 2, 3})));
    const test::PathScene scene(b.finish());
    for (const double angle : {0.0, 60.0}) {
        const Vec3 to = -test::atAngle(angle), eye = to * -1.0F;
        const double x = 1 - std::cos(angle * std::numbers::pi / 180);
        const double expected = 2 * 0.8 * (0.04 + 0.96 * x * x * x * x * x);
        RenderSettings settings = test::exactSettings();
        EXPECT_NEAR(scene.traced.trace(eye, to, settings).radiance.g, expected, 0.02 * expected) << angle;
        const test::PathMean paths = scene.see(eye, to, 4096, test::bouncesAlone(1));
        // Black metal of roughness 1 mirrors at grazing angles, too.
        EXPECT_NEAR(paths.mean[1], expected, 0.1) << angle;
        EXPECT_GT(paths.mean[1], expected - 4 * paths.error[1] - 1e-3) << angle;
    }
}

TEST(MetallicPaths, SmoothMetalsAreMirrors) {
    const Colour base{0.9F, 0.6F, 0.3F};
    test::SceneBuilder b;
    b.square({0, 0, 0}, {0, 1, 0}, 2, b.material(metallicMaterial(base, 1, 0.02F)));
    b.square({0, 3, 0}, {0, -1, 0}, 3, b.material(test::emitter({1, 2, 3})));
    const test::PathScene scene(b.finish());
    const Vec3 eye{0.5F, 1, 0}, to = normalize(Vec3{-0.1F, -1, 0.1F});
    const test::PathMean paths = scene.see(eye, to, 64);
    const Colour whitted = scene.traced.trace(eye, to).radiance;
    const std::array<float, 3> expected{0.9F, 1.2F, 0.9F};
    const std::array<float, 3> live{whitted.r, whitted.g, whitted.b};
    for (std::size_t k = 0; k < 3; ++k) {
        EXPECT_NEAR(paths.mean[k], expected[k], 2e-3);
        EXPECT_NEAR(live[k], expected[k], 2e-3);
        EXPECT_LT(paths.error[k], 1e-4) << "no path misses it";
    }
}

TEST(MetallicPaths, GlossySurfacesShowMirrorsAndMatteOnesGetNoCaustics) {
    for (const bool glossy : {true, false}) {
        test::SceneBuilder b;
        b.square({0, 0, 0}, {0, 1, 0}, 1,
                 b.material(glossy ? metallicMaterial(kWhite, 1, 0.1F) : test::matte(0.8F)));
        b.square({0, 2, 0}, {0, -1, 0}, 20, b.material(test::mirror(1)));
        b.square({0, -0.5F, 0}, {0, 1, 0}, 20, b.material(test::emitter(kWhite)));
        const test::PathScene scene(b.finish());
        const Vec3 eye{2, 1, 0};
        test::PathLimits limits = test::bouncesAlone(1);
        const test::PathMean without = scene.see(eye, -eye, 8192, limits);
        limits.caustics = true;
        const test::PathMean with = scene.see(eye, -eye, 8192, limits);
        EXPECT_GT(with.mean[0], 0.3);
        if (glossy) {
            EXPECT_EQ(without.mean[0], with.mean[0]);
        } else {
            EXPECT_EQ(without.mean[0], 0);
        }
    }
}

TEST(MetallicPaths, MirroredRaysFadeWithTheRoughness) {
    float last = 1;
    for (const float roughness : {0.0F, 0.05F, 0.1F, 0.2F, 0.29F, 0.31F}) {
        test::SceneBuilder b;
        b.square({0, 0, 0}, {0, 1, 0}, 2, b.material(metallicMaterial(kWhite, 1, roughness)));
        b.square({0, 3, 0}, {0, -1, 0}, 3, b.material(test::emitter(kWhite)));
        const test::TracedScene scene(b.finish());
        const float seen = scene.trace({0.5F, 1, 0}, {0, -1, 0}).radiance.g;
        if (roughness <= 0.0F) {
            EXPECT_NEAR(seen, 1, 1e-3);
        } else {
            EXPECT_LT(seen, last) << roughness;
        }
        last = seen;
    }
    EXPECT_EQ(last, 0);
}

TEST(MetallicPaths, TheTextureOfRoughnessCountsAtEachPoint) {
    test::SceneBuilder b;
    Material m = metallicMaterial(kWhite, 1, 1);
    m.metallicRoughnessTexture = b.texture(1, 1, {{0, 0, 255, 255}});
    Material rough = m;
    rough.metallicRoughnessTexture = b.texture(1, 1, {{0, 255, 255, 255}});
    b.square({-2, 0, 0}, {0, 1, 0}, 1, b.material(m));
    b.square({2, 0, 0}, {0, 1, 0}, 1, b.material(rough));
    b.square({0, 3, 0}, {0, -1, 0}, 9, b.material(test::emitter(kWhite)));
    const test::TracedScene scene(b.finish());
    EXPECT_NEAR(scene.trace({-2, 1, 0}, {0, -1, 0}).radiance.g, 1, 1e-3) << "a mirror";
    EXPECT_EQ(scene.trace({2, 1, 0}, {0, -1, 0}).radiance.g, 0);
}

} // namespace
} // namespace rtcore
