// Rays that leave a surface must not hit it again, whatever its size and place: else lit floors are speckled.
#include "support/small_scene.h"
#include "support/steps.h"

#include <gtest/gtest.h>

namespace rtcore {
namespace {

using test::SceneBuilder;
using test::TracedScene;

/// Fraction of 41 x 41 points around `position`, over a width of 2 * `half`, on which the light of a light
/// does not arrive.
double darkFraction(const TracedScene& s, Vec3 position, Vec3 normal, float half) {
    const auto [t, b] = basisAround(normal);
    int dark = 0, all = 0;
    for (int y = -20; y <= 20; ++y) {
        for (int x = -20; x <= 20; ++x) {
            const Vec3 p = position + t * (half * static_cast<float>(x) / 20.3F) +
                           b * (half * static_cast<float>(y) / 19.7F);
            if (s.see(p + normal * half, p) == 0) ++dark;
            ++all;
        }
    }
    return static_cast<double>(dark) / all;
}

TEST(SelfShadow, AFloorThatIsLargeBesideItsDistanceFromTheOrigin) {
    for (const Vec3 normal : {Vec3{0, 1, 0}, normalize({1, 2, 3}), normalize({-5, 1, 0.1F})}) {
        for (const float size : {2.0F, 100.0F, 1e3F, 1e4F}) {
            SceneBuilder b;
            const auto [t, u] = basisAround(normal);
            b.square((t * 0.31F + u * 0.17F) * size, normal, size, b.material(test::matte(1)));
            b.scene.lights.push_back(test::pointLight(normal * 3 + t, 9));
            EXPECT_EQ(darkFraction(TracedScene(b.finish()), {}, normal, 1), 0) << size;
        }
    }
}

TEST(SelfShadow, AFloorFarFromTheOrigin) {
    const Vec3 normal = normalize({1, 2, 3});
    for (const float distance : {10.0F, 1e3F, 1e5F}) {
        const Vec3 position{distance, -0.3F * distance, 0.7F * distance};
        SceneBuilder b;
        b.square(position, normal, 5, b.material(test::matte(1)));
        b.scene.lights.push_back(test::pointLight(position + normal * 3, 9));
        EXPECT_EQ(darkFraction(TracedScene(b.finish()), position, normal, 1), 0) << distance;
    }
}

TEST(SelfShadow, APictureDoesNotDependOnTheUnitOfLength) {
    const auto scene = [](float unit) {
        SceneBuilder b;
        b.sphere({0, 0, 0}, unit, 16, b.material(test::matte(1)));
        b.sphere({1.5F * unit, 0, unit}, 0.4F * unit, 16, b.material(test::glass()));
        b.square({0.3F * unit, -unit, 0.1F * unit}, {0, 1, 0}, 5 * unit, b.material(test::matte(1)));
        b.scene.lights.push_back(test::pointLight(Vec3{3, 4, 5} * unit, unit * unit));
        return b.finish();
    };
    const TracedScene metres(scene(1));
    for (const float unit : {1e-7F, 1e-3F, 39.37F, 1e6F}) {
        const TracedScene other(scene(unit));
        int different = 0;
        for (const float y : test::steps(-1.2F, 1.2F, 0.083F)) {
            for (const float x : test::steps(-1.2F, 2.0F, 0.079F)) {
                const float here = metres.trace({x, y, 5}, {0, -0.1F, -1}).radiance.r;
                const float there = other.trace(Vec3{x, y, 5} * unit, {0, -0.1F, -1}).radiance.r;
                if (std::fabs(there - here) > 1e-3F * std::max(here, 1e-3F)) ++different;
            }
        }
        EXPECT_LE(different, 2) << unit; // of 1189; edges of shadows move by a rounding
    }
}

} // namespace
} // namespace rtcore
