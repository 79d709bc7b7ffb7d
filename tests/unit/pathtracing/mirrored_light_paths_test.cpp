// Lights that mirrors show, in path tracing: each way of their light counts once, whatever finds it.
#include "path_support.h"

#include "rtcore/scene/metallic_roughness.h"

#include <gtest/gtest.h>

namespace rtcore {
namespace mirrored_light_paths {
namespace {

constexpr float kSide = 2, kIntensity = 12;
constexpr double kRadiance = static_cast<double>(kIntensity / (kSide * kSide));

Light softbox(Vec3 middle, Vec3 towards, bool mirrored = true) {
    Light light;
    light.kind = LightKind::Rectangle;
    light.position = middle;
    light.direction = normalize(towards);
    light.right = basisAround(light.direction).tangent;
    light.width = light.height = kSide;
    light.intensity = kWhite * kIntensity;
    light.mirrored = mirrored ? 1 : 0;
    return light;
}

test::PathScene facing(const Material& material, const Light& light) {
    test::SceneBuilder b;
    b.square({0, 0, 0}, {0, 0, 1}, 5, b.material(material));
    b.scene.lights = {light};
    return test::PathScene(b.finish());
}

TEST(MirroredLightPaths, MirrorsAndGlassThatBendsShowIt) {
    constexpr Vec3 kEye{0, 0, 4}, kAhead{0, 0, -1};
    for (const bool caustics : {false, true}) {
        test::PathLimits limits;
        limits.caustics = caustics;
        const auto expect = [&](const test::PathScene& scene, double radiance, const char* what) {
            test::expectLight(scene, kEye, kAhead, 20'000, limits, radiance, what, 0.01 * kRadiance);
        };
        expect(facing(test::mirror(0.5F), softbox({0, 0, 6}, {0, 0, -1})), 0.5 * kRadiance, "mirror");
        expect(facing(test::mirror(0.5F), softbox({0, 0, 6}, {0, 0, -1}, false)), 0, "not to be seen");
        expect(facing(test::mirror(0.5F), softbox({0, 0, 6}, {0, 0, 1})), 0, "from behind");
        expect(facing(test::glass(1), softbox({0, 0, -6}, {0, 0, 1})), 0, "pane");
        test::SceneBuilder b;
        b.box({-1, -1, -1}, {1, 1, 0}, b.material(test::glass()));
        b.scene.lights = {softbox({0, 0, -6}, {0, 0, 1})};
        expect(test::PathScene(b.finish()), 0.96 * 0.96 * kRadiance, "solid");
    }
}

/// Lobes find the light as before: next event estimation and scattered rays share it.
TEST(MirroredLightPaths, LobesSeeWhatTheySawBefore) {
    for (const float roughness : {0.1F, 0.3F, 0.6F}) {
        Material metal;
        setMetallicRoughness(metal, kWhite * 0.8F, 1, roughness);
        const auto seen = [&](bool mirrored) {
            return facing(metal, softbox({0, 0, 3}, {0, 0, -1}, mirrored))
                .see({1, 0, 4}, normalize({-1, 0, -4}), 40'000, test::bouncesAlone(0));
        };
        EXPECT_EQ(seen(true).mean, seen(false).mean) << roughness;
    }
}

/// A floor beside a mirrored wall: the light that the wall throws down is a caustic.
TEST(MirroredLightPaths, ByAMirrorToAMatteFloorItIsACaustic) {
    test::SceneBuilder b;
    b.square({0, 0, 0}, {0, 1, 0}, 50, b.material(test::matte(1)));
    b.square({-1, 0, 0}, {1, 0, 0}, 50, b.material(test::mirror(1)));
    b.scene.lights = {softbox({0, 4, 0}, {0, -1, 0})};
    const test::PathScene scene(b.finish());
    test::PathLimits limits = test::bouncesAlone(0);
    const auto at = [&](float x) { return scene.see({x, 1, 0}, {0, -1, 0}, 200'000, limits); };
    const test::PathMean once = at(0);
    // The wall shows the light as far behind it as it is before it.
    test::SceneBuilder image;
    image.square({0, 0, 0}, {0, 1, 0}, 50, image.material(test::matte(1)));
    image.scene.lights = {softbox({-2, 4, 0}, {0, -1, 0})};
    const test::PathMean thrown =
        test::PathScene(image.finish()).see({0, 1, 0}, {0, -1, 0}, 200'000, test::bouncesAlone(0));
    limits.caustics = true;
    const test::PathMean both = at(0);
    EXPECT_NEAR(both.mean[0], once.mean[0] + thrown.mean[0],
                5 * (both.error[0] + once.error[0] + thrown.error[0]));
}

/// Light passes a closed block of glass straight on, or bent where caustics count, never both.
TEST(MirroredLightPaths, ThroughGlassItCountsOnce) {
    test::SceneBuilder b;
    b.square({0, 0, 0}, {0, 1, 0}, 50, b.material(test::matte(1)));
    b.box({-40, 1, -40}, {40, 1.1F, 40}, b.material(test::glass()));
    b.scene.lights = {softbox({0, 6, 0}, {0, -1, 0})};
    const test::PathScene scene(b.finish());
    test::PathLimits limits = test::bouncesAlone(0);
    const test::PathMean straight = scene.see({0, 0.5F, 0}, {0, -1, 0}, 100'000, limits);
    limits.caustics = true;
    const test::PathMean bent = scene.see({0, 0.5F, 0}, {0, -1, 0}, 400'000, limits);
    EXPECT_GT(straight.mean[0], 0.05);
    EXPECT_NEAR(bent.mean[0], straight.mean[0], 5 * bent.error[0] + 0.02 * straight.mean[0]);
}

} // namespace
} // namespace mirrored_light_paths
} // namespace rtcore
