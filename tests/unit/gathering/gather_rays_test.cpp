#include "rtcore/gathering/gather_rays.h"

#include "rtcore/simd/instruction_set.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <set>

namespace rtcore {
namespace {

GatherPass passNumber(std::uint32_t number) {
    return {0, {1, 2, 3}, normalize(Vec3{1, 2, -0.5F}), 77, number};
}

TEST(GatherRays, AreUnitVectorsBeforeTheSurfaceWithTheDensityOfTheCosine) {
    RayWave rays;
    constexpr int kPasses = 64;
    for (std::uint32_t i = 0; i < kPasses; ++i) addGatherRays(passNumber(i), rays);
    ASSERT_EQ(rays.size(), kPasses * kPassRays);
    const Vec3 normal = passNumber(0).normal;
    double mean = 0, square = 0;
    Vec3d sum;
    for (std::size_t i = 0; i < rays.size(); ++i) {
        const Ray ray = rays.ray(i);
        EXPECT_EQ(ray.origin, (Vec3{1, 2, 3}));
        EXPECT_NEAR(length(ray.direction), 1, 1e-6);
        const float cosine = dot(ray.direction, normal);
        EXPECT_GT(cosine, 0);
        mean += cosine / static_cast<double>(rays.size());
        square += cosine * cosine / static_cast<double>(rays.size());
        sum = sum + Vec3d{ray.direction.x, ray.direction.y, ray.direction.z};
    }
    EXPECT_NEAR(mean, 2.0 / 3, 1e-4); // of the density cos / pi
    EXPECT_NEAR(square, 0.5, 1e-4);
    const Vec3d along = Vec3d{normal.x, normal.y, normal.z} * (2.0 / 3 * static_cast<double>(rays.size()));
    EXPECT_LT(length(sum - along) / static_cast<double>(rays.size()), 1e-4);
}

TEST(GatherRays, EachPassHasOneInEachStratum) {
    // Of the square of cosines, which is even, in eight parts.
    for (const std::uint32_t number : {0U, 1U, 5U, 1000U}) {
        RayWave rays;
        addGatherRays(passNumber(number), rays);
        double mean = 0;
        std::set<float> different;
        for (std::size_t i = 0; i < rays.size(); ++i) {
            const float cosine = dot(rays.ray(i).direction, passNumber(0).normal);
            mean += cosine / 64.0;
            different.insert(rays.dx[i]);
        }
        EXPECT_NEAR(mean, 2.0 / 3, 0.01); // 0.03 of random ones
        EXPECT_EQ(different.size(), kPassRays);
    }
}

TEST(GatherRays, PassesDiffer) {
    RayWave one, other;
    addGatherRays(passNumber(0), one);
    addGatherRays(passNumber(1), other);
    for (std::size_t i = 0; i < kPassRays; ++i) EXPECT_NE(one.dx[i], other.dx[i]);
}

TEST(GatherRays, TheSameBitsByEveryInstructionSet) {
    RayWave expected;
    ASSERT_TRUE(useInstructionSet("scalar"));
    addGatherRays(passNumber(3), expected);
    for (const std::string& name : instructionSets()) {
        ASSERT_TRUE(useInstructionSet(name));
        RayWave rays;
        addGatherRays(passNumber(3), rays);
        EXPECT_EQ(rays.dx, expected.dx) << name;
        EXPECT_EQ(rays.dy, expected.dy) << name;
        EXPECT_EQ(rays.dz, expected.dz) << name;
    }
    useInstructionSet("auto");
}

} // namespace
} // namespace rtcore
