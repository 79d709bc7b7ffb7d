#include "rtcore/math/triangle.h"

#include <gtest/gtest.h>

namespace rtcore {
namespace {

constexpr float kRounding = 0x1p-24F;

float clearance(Vec3 corner, Vec3 normal) { return surfaceClearance({}, corner, {}, normal); }

TEST(SurfaceClearance, GrowsWithTheCornersMostAlongTheNormal) {
    EXPECT_EQ(clearance({1, 1, 1}, {1, 0, 0}), 80 * kRounding);
    EXPECT_EQ(clearance({-1000, 1000, -1000}, {0, -1, 0}), 80000 * kRounding);
    EXPECT_EQ(clearance({1000, 0, 1000}, {0, 1, 0}), 16000 * kRounding); // a floor through the origin
    EXPECT_EQ(clearance({0, 0, 0}, {0, 1, 0}), 0);
}

TEST(SurfaceClearance, CountsTheLargestOfAllCorners) {
    const Vec3 normal{0, 0, 1};
    EXPECT_EQ(surfaceClearance({1, 0, 0}, {0, 5, 0}, {0, 0, 3}, normal), (4 * 3 + 5) * 16 * kRounding);
    EXPECT_EQ(surfaceClearance({0, 0, 3}, {1, 0, 0}, {0, 5, 0}, normal),
              surfaceClearance({1, 0, 0}, {0, 5, 0}, {0, 0, 3}, normal));
}

} // namespace
} // namespace rtcore
