#include "rtcore/kernels/narrow_noise.h"
#include "support/random_numbers.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace {

using rtcore::Vec3;

/// A triangle of size 1e-12 to 1e12, up to 1e4 sizes off the origin, round to 1e6 times as long as wide.
std::array<Vec3, 3> anyTriangle(test::Random& random) {
    const auto power = [&](float lo, float hi) { return std::pow(10.0F, random.number(lo, hi)); };
    const float size = power(-12, 12);
    const Vec3 from = random.vector(size * power(-4, 4));
    const Vec3 along = random.vector(size);
    return {from, from + along, from + along * 0.5F + random.vector(size * power(-6, 0))};
}

rtcore::Float4 wide(Vec3 v) { return rtcore::Float4{v.x, v.y, v.z, std::nanf("")}; }

} // namespace

TEST(NarrowNoise, NoNarrowTriangleIsTakenForACommonOne) {
    constexpr int kTriangles = 200'000;
    test::Random random(11);
    int common = 0, narrow = 0;
    for (int i = 0; i < kTriangles; ++i) {
        const auto [a, b, c] = anyTriangle(random);
        const float noise = rtcore::narrowNoise(a, b, c);
        narrow += noise != 0 ? 1 : 0;
        if (!rtcore::isSurelyCommon(wide(a), wide(b), wide(c))) continue;
        ++common;
        ASSERT_EQ(noise, 0) << i;
    }
    EXPECT_GT(common, kTriangles / 20);
    EXPECT_GT(narrow, kTriangles / 20);
}
