#include "rtcore/math/box.h"
#include "rtcore/math/vec.h"

#include <gtest/gtest.h>

#include <limits>
#include <random>

namespace rtcore {
namespace {

constexpr float kMax = std::numeric_limits<float>::max();
constexpr float kInf = std::numeric_limits<float>::infinity();
constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

class Directions {
  public:
    Vec3 next() { return normalize({normal_(random_), normal_(random_), normal_(random_)}); }

  private:
    std::mt19937 random_{7};
    std::normal_distribution<float> normal_;
};

TEST(Normalize, UnitLengthAtAnySize) {
    for (const float size : {1e-45F, 1e-40F, 1e-30F, 1e-16F, 1e-15F, 1.0F, 1e15F, 1e16F, 1e30F, kMax}) {
        for (const Vec3 d : {Vec3{1, 0, 0}, {0, -1, 0}, {1, 1, 1}, {1, -1, 0}}) {
            const Vec3 unit = normalize(d * size);
            EXPECT_NEAR(length(unit), 1, 3e-7) << size;
            EXPECT_NEAR(dot(unit, d), length(d), 1e-6) << size;
        }
    }
}

TEST(Normalize, ZeroWhereThereIsNoDirection) {
    for (const Vec3 v :
         {Vec3{}, {-0.0F, 0, 0}, {kNan, 1, 0}, {0, kInf, 0}, {1, 1, -kInf}, {kNan, kNan, kNan}}) {
        EXPECT_EQ(normalize(v), Vec3{});
    }
}

TEST(BasisAround, IsOrthonormalAndRightHanded) {
    Directions directions;
    const auto check = [](Vec3 n) {
        const auto [t, b] = basisAround(n);
        EXPECT_NEAR(length(t), 1, 1e-6);
        EXPECT_NEAR(length(b), 1, 1e-6);
        EXPECT_NEAR(dot(t, n), 0, 1e-6);
        EXPECT_NEAR(dot(b, n), 0, 1e-6);
        EXPECT_NEAR(dot(t, b), 0, 1e-6);
        EXPECT_NEAR(dot(cross(t, b), n), 1, 1e-6);
    };
    for (int i = 0; i < 10000; ++i) check(directions.next());
    for (const Vec3 n :
         {Vec3{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {-1, 0, 0}, {0, -1, 0}, {0, 0, -1}, {0, 0, -0.0F}}) {
        if (length(n) > 0) check(n);
    }
    check(normalize({1e-5F, 0, -1})); // where the older construction breaks down
    check(normalize({1, 0, -0.0F}));
}

TEST(Vec, ProductsAndIndices) {
    EXPECT_EQ(cross(Vec3{1, 0, 0}, {0, 1, 0}), (Vec3{0, 0, 1}));
    EXPECT_EQ(dot(Vec3{1, 2, 3}, {4, 5, 6}), 32);
    Vec3 v{1, 2, 3};
    v[1] = 7;
    EXPECT_EQ(v[0] + v[1] + v[2], 11);
    EXPECT_FALSE(isFinite(Vec3{0, kNan, 0}));
}

TEST(Box, GrowsFromNothing) {
    Box3 box;
    EXPECT_TRUE(box.empty());
    EXPECT_EQ(box.diagonal(), 0);
    box.extend(Vec3{1, 2, 3});
    EXPECT_FALSE(box.empty());
    EXPECT_EQ(box.diagonal(), 0);
    box.extend(Vec3{2, 4, 6});
    EXPECT_EQ(box.size(), (Vec3{1, 2, 3}));
    EXPECT_EQ(box.halfArea(), 1 * 2 + 2 * 3 + 3 * 1);
    EXPECT_EQ(box.centre(), (Vec3{1.5F, 3, 4.5F}));
}

} // namespace
} // namespace rtcore
