#include "rtcore/math/octahedron-inl.h"

#include "support/random_numbers.h"

#include <gtest/gtest.h>

#include <cmath>

namespace rtcore {
namespace octahedron {
namespace {

namespace plain = HWY_NAMESPACE;

TEST(Octahedron, DirectionIsTheWayBackFromThePoint) {
    test::Random random(1);
    for (int i = 0; i < 20000; ++i) {
        const Vec3 d = random.unitVector();
        const auto p = plain::octahedronPoint<float>(d);
        const Vec3 back = plain::octahedronDirection<float>(p.x, p.y);
        ASSERT_NEAR(std::fabs(back.x) + std::fabs(back.y) + std::fabs(back.z), 1, 1e-6);
        ASSERT_LT(length(normalize(back) - d), 1e-6F);
    }
}

TEST(Octahedron, HasItsPolesInTheMiddleAndInTheCorners) {
    EXPECT_EQ(plain::octahedronDirection<float>(0.5F, 0.5F), (Vec3{0, 1, 0}));
    for (const float x : {0.0F, 1.0F})
        for (const float y : {0.0F, 1.0F}) EXPECT_EQ(plain::octahedronDirection<float>(x, y).y, -1);
    EXPECT_EQ(plain::octahedronDirection<double>(1, 0.5), (Vec3d{1, 0, 0}));
}

} // namespace
} // namespace octahedron
} // namespace rtcore
