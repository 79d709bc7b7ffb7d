// Many transparent layers one behind the other: each is passed by a chance of its own.

#include "path_support.h"

#include "rtcore/pathtracing/path_numbers-inl.h"

#include <gtest/gtest.h>

#include <set>
#include <utility>

namespace rtcore {
namespace {

/// Squares across the z axis, from z = 0 on, before surroundings of radiance 1 that are seen through them
/// alone.
Scene layers(int count, const Material& material, test::SceneBuilder b = {}) {
    const std::uint32_t of = b.material(material);
    for (int i = 0; i < count; ++i) b.square({0, 0, 0.05F * static_cast<float>(i)}, {0, 0, 1}, 1, of);
    b.square({0, 0, -1}, {0, 0, 1}, 5, b.material(test::emitter({1, 1, 1})));
    return b.finish();
}

Material veil(float opacity) {
    Material m = test::glass(1);
    m.opacity = opacity;
    return m;
}

/// A leaf of an alpha texture that covers so much everywhere.
Scene leaves(int count, std::uint8_t alpha) {
    test::SceneBuilder b;
    Material m = test::matte(0);
    m.alphaTexture = b.texture(1, 1, {{alpha, alpha, alpha, 255}});
    return layers(count, m, std::move(b));
}

test::PathMean seenThrough(const test::PathScene& scene, std::uint32_t samples) {
    return scene.see({0.1F, 0.2F, 8}, {0, 0, -1}, samples, test::bouncesAlone(4));
}

TEST(PathLayers, VeilsLetPassWhatTheyLetPassTogether) {
    for (const int count : {16, 20, 40, 60}) {
        const test::PathScene scene(layers(count, veil(0.03F)));
        const auto seen = seenThrough(scene, 30000);
        const double expected = std::pow(0.97, count);
        EXPECT_NEAR(seen.mean[0], expected, std::min(4 * seen.error[0], 0.011)) << count;
        EXPECT_NEAR(scene.traced.see({0.1F, 0.2F, 8}, {0.1F, 0.2F, 0}), expected, 1e-5) << count;
    }
}

TEST(PathLayers, HolesOfManyLeavesAreIndependent) {
    for (const int count : {20, 60}) {
        const test::PathScene scene(leaves(count, 13));
        const auto seen = seenThrough(scene, 30000);
        EXPECT_NEAR(seen.mean[0], std::pow(1 - 13 / 255.0, count), 4 * seen.error[0]) << count;
        EXPECT_LT(seen.error[0], 0.003);
    }
}

/// Stokes 1862: what 2 n faces of reflectance r let pass, all reflections between them counted.
TEST(PathLayers, PanesMirrorEachOther) {
    for (const int count : {8, 30, 40}) {
        const test::PathScene scene(layers(count, test::glass()), test::exactSettings(1000));
        const auto seen = seenThrough(scene, 40000);
        const double expected = 0.96 / (1 + (2 * count - 1) * 0.04);
        EXPECT_NEAR(seen.mean[0], expected, 4 * seen.error[0] + 1e-3 * expected) << count;
        EXPECT_LT(seen.error[0], 0.01 * expected);
    }
}

/// Light of an emitter comes through veils to a floor: by shadow rays, by rays that are scattered, by both.
TEST(PathLayers, VeilsBeforeALightDimItHoweverItIsFound) {
    test::SceneBuilder b;
    b.square({0, 0, 0}, {0, 1, 0}, 2, b.material(test::matte(1)));
    const std::uint32_t material = b.material(veil(0.03F));
    for (int i = 0; i < 40; ++i)
        b.square({0, 0.5F + 0.01F * static_cast<float>(i), 0}, {0, 1, 0}, 3, material);
    b.square({0, 1.2F, 0}, {0, -1, 0}, 1, b.material(test::emitter({1, 1, 1})));
    const test::PathScene scene(b.finish());
    test::PathLimits limits = test::bouncesAlone(0);
    const double bare =
        4 * test::lambertSum<4>({{{0, 1.2, 0}, {1, 1.2, 0}, {1, 1.2, 1}, {0, 1.2, 1}}}, {0, 1, 0});
    test::expectLight(scene, {0, 0.1F, 0}, {0, -1, 0}, 30000, limits, bare * std::pow(0.97, 40),
                      "through 40");
}

/// As many as settings and the bound on panes allow.
TEST(PathNumbers, TellAllPointsOfAPathApart) {
    std::set<std::pair<std::uint32_t, std::uint32_t>> known;
    std::set<std::uint32_t> names;
    std::size_t count = 0;
    for (std::uint32_t scatters = 0; scatters <= 129; scatters += 3) {
        for (std::uint32_t depth = 0; depth <= 1000; depth += 25) {
            for (std::uint32_t passes = 0; passes <= 1001; passes += passes < 40 ? 1 : 37) {
                const auto visit = HWY_NAMESPACE::visitOf(scatters, depth | passes << 16);
                known.insert({visit.usual, visit.beyond});
                names.insert(HWY_NAMESPACE::nameOfNumbers(12345U, SampleDimension::Glass, visit));
                EXPECT_LT(visit.usual, 1U << 24U);
                EXPECT_EQ(visit.beyond == 0, passes < 16) << "paths of few layers keep their numbers";
                ++count;
            }
        }
    }
    EXPECT_EQ(known.size(), count);
    EXPECT_GT(names.size(), count - 10) << "but for chance";
}

} // namespace
} // namespace rtcore
