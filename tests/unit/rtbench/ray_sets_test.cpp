/// The rays that are raced.
#include "bench/rtbench/ray_sets.h"

#include "rtcore/accel/builder.h"
#include "support/sample_meshes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace {

using rtbench::kRayTests;
using rtbench::RaySet;
using rtcore::Ray;

std::vector<Ray> raysOf(const RaySet& set) {
    std::vector<Ray> rays;
    for (const rtcore::RayWave& wave : set.waves) {
        for (std::size_t i = 0; i < wave.size(); ++i) rays.push_back(wave.ray(i));
    }
    return rays;
}

class RaySets : public testing::Test {
  protected:
    rtbench::BenchView view() const {
        return {.name = "", .eye = {0, 0, 4}, .at = {0, 0, 0}, .fov = 45, .light = {3, 5, 7}};
    }
    RaySet make(std::size_t kind, int size) const {
        return rtbench::RaySource(sphere.view(), tracer, view(), size).make(kRayTests.at(kind));
    }

    test::SampleMesh sphere = test::icosphere(3);
    rtcore::KdTree tree = rtcore::buildKdTree(sphere.view(), {});
    rtcore::KdRayTracer tracer{tree, sphere.view()};
};

TEST_F(RaySets, EverySixteenPrimaryRaysAreASquare) {
    const std::vector<Ray> rays = raysOf(make(0, 64));
    ASSERT_EQ(rays.size(), 64U * 64U);
    const float pixel = 2 * std::tan(45 * 3.14159265F / 360) / 64;
    for (std::size_t first = 0; first < rays.size(); first += 16) {
        float lo[2] = {9, 9}, hi[2] = {-9, -9};
        for (std::size_t i = first; i < first + 16; ++i) {
            for (int axis = 0; axis < 2; ++axis) {
                const float at = rays[i].direction[axis] / -rays[i].direction.z;
                lo[axis] = std::min(lo[axis], at);
                hi[axis] = std::max(hi[axis], at);
            }
        }
        EXPECT_NEAR(hi[0] - lo[0], 3 * pixel, 1e-4F);
        EXPECT_NEAR(hi[1] - lo[1], 3 * pixel, 1e-4F);
    }
}

TEST_F(RaySets, SizesNeedNotBeWholeBlocks) {
    EXPECT_EQ(make(0, 37).rays, 37U * 37U);
    EXPECT_EQ(raysOf(make(0, 37)).size(), 37U * 37U);
}

TEST_F(RaySets, WavesHaveNoGaps) {
    const RaySet set = make(2, 256);
    ASSERT_GT(set.waves.size(), 1U);
    for (std::size_t i = 0; i + 1 < set.waves.size(); ++i) {
        EXPECT_EQ(set.waves[i].size(), rtbench::kWaveRays);
    }
    EXPECT_EQ(raysOf(set).size(), set.rays);
}

TEST_F(RaySets, SecondaryRaysStartOutside) {
    const std::size_t hits = make(1, 64).rays;
    EXPECT_GT(hits, 1000U);
    EXPECT_LT(hits, 64U * 64U);
    EXPECT_EQ(make(3, 64).rays, hits);
    EXPECT_EQ(make(4, 64).rays, hits);
    EXPECT_NEAR(static_cast<double>(make(2, 64).rays), 9.0 * static_cast<double>(hits) / 4,
                static_cast<double>(hits) / 4);
    // Nothing else is there to be hit, apart from the sphere itself.
    for (const std::size_t kind : {2U, 3U, 4U}) {
        for (const Ray& ray : raysOf(make(kind, 64))) {
            rtcore::RayWave wave;
            wave.push(ray);
            std::vector<std::uint8_t> occluded;
            tracer.occluded(kRayTests[kind].kind, wave, occluded);
            EXPECT_EQ(occluded[0], 0);
        }
    }
}

TEST_F(RaySets, EndWhereTheyShould) {
    for (const Ray& ray : raysOf(make(1, 32))) {
        EXPECT_LT(rtcore::length(ray.origin + ray.direction * ray.tMax - view().light), 1e-5F);
    }
    const float diagonal = sphere.view().bounds().diagonal();
    for (const Ray& ray : raysOf(make(2, 32))) EXPECT_FLOAT_EQ(ray.tMax, 0.15F * diagonal);
}

TEST_F(RaySets, AreTheSameAgain) {
    for (std::size_t kind = 0; kind < kRayTests.size(); ++kind) {
        const std::vector<Ray> a = raysOf(make(kind, 32));
        const std::vector<Ray> b = raysOf(make(kind, 32));
        ASSERT_EQ(a.size(), b.size());
        for (std::size_t i = 0; i < a.size(); ++i) {
            EXPECT_EQ(a[i].origin, b[i].origin);
            EXPECT_EQ(a[i].direction, b[i].direction);
        }
    }
}

} // namespace
