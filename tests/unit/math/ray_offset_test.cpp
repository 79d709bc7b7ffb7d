#include "rtcore/math/ray_offset.h"

#include <gtest/gtest.h>

#include <array>
#include <limits>

namespace rtcore {
namespace {

float offset1(float p, float n) { return offsetRayOrigin({p, 0, 0}, {n, 0, 0}).x; }

TEST(RayOffset, KnownValues) {
    EXPECT_FLOAT_EQ(offset1(1, 1), 1.00003052F);
    EXPECT_FLOAT_EQ(offset1(1000, 1), 1000.015625F);
    EXPECT_FLOAT_EQ(offset1(0.01F, 1), 0.0100152586F);
    EXPECT_FLOAT_EQ(offset1(-2, 1), -1.99996948F);
}

TEST(RayOffset, MovesToTheSideOfTheNormalForPointsOfAnySign) {
    const std::array<float, 12> places{-1e18F, -1000, -2,     -1.0F / 32, -0.01F, -1e-44F,
                                       -0.0F,  0,     1e-44F, 0.02F,      3,      1e18F};
    for (const float p : places) {
        for (const float n : {-1.0F, -0.25F, 0.25F, 1.0F}) {
            const float moved = offset1(p, n);
            EXPECT_EQ(moved > p, n > 0) << p << ' ' << n;
            EXPECT_NE(moved, p) << p << ' ' << n;
        }
        EXPECT_EQ(offset1(p, 0), p);
    }
}

TEST(RayOffset, TheStepIsOfTheSizeOfTheRoundingError) {
    for (const float p : {0.05F, 1.0F, 77.7F, 1e6F, -1e6F}) {
        const float unit = std::fabs(std::nextafter(p, std::numeric_limits<float>::infinity()) - p);
        const float step = std::fabs(offset1(p, 1) - p);
        EXPECT_GE(step, 127 * unit);
        EXPECT_LE(step, 512 * unit);
    }
}

TEST(SurfaceClearance, GrowsWithTheCornersMostAlongTheNormal) {
    constexpr float kRounding = 0x1p-24F;
    EXPECT_EQ(surfaceClearance({1, 1, 1}, {1, 0, 0}), 80 * kRounding);
    EXPECT_EQ(surfaceClearance({1000, 1000, 1000}, {0, -1, 0}), 80000 * kRounding);
    EXPECT_EQ(surfaceClearance({1000, 0, 1000}, {0, 1, 0}), 16000 * kRounding); // a floor through the origin
    EXPECT_EQ(surfaceClearance({0, 0, 0}, {0, 1, 0}), 0);
}

TEST(RayOffset, EachAxisByItself) {
    const Vec3 moved = offsetRayOrigin({1, -2, 1000}, {0, 1, 0});
    EXPECT_EQ(moved.x, 1);
    EXPECT_FLOAT_EQ(moved.y, -1.99996948F);
    EXPECT_EQ(moved.z, 1000);
}

} // namespace
} // namespace rtcore
