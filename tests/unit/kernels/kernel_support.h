/// A mesh with its trees, and what must hold of every ray traced against them.
#pragma once

#include "rtcore/accel/builder.h"
#include "rtcore/kernels/single_ray.h"
#include "support/exact_rays.h"
#include "support/sample_meshes.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdio>
#include <limits>
#include <string>
#include <utility>

namespace test {

inline bool sameBits(const rtcore::Hit& a, const rtcore::Hit& b) {
    const auto bits = [](float x) { return std::bit_cast<std::uint32_t>(x); };
    return a.triangle == b.triangle && bits(a.t) == bits(b.t) && bits(a.u) == bits(b.u) &&
           bits(a.v) == bits(b.v);
}

inline std::string text(const rtcore::Ray& ray) {
    char line[256];
    std::snprintf(line, sizeof line, "origin %a %a %a direction %a %a %a from %a to %a", double{ray.origin.x},
                  double{ray.origin.y}, double{ray.origin.z}, double{ray.direction.x},
                  double{ray.direction.y}, double{ray.direction.z}, double{ray.tMin}, double{ray.tMax});
    return line;
}

class TracedMesh {
  public:
    explicit TracedMesh(SampleMesh sample) : sample_(std::move(sample)), mesh_(sample_.view()) {
        rtcore::BuildOptions options;
        exact_ = buildKdTree(mesh_, options);
        options.method = rtcore::BuildMethod::Fast;
        options.intersectionCost = 4; // deep, with many planes
        fast_ = buildKdTree(mesh_, options);
    }
    TracedMesh(const TracedMesh&) = delete;
    TracedMesh& operator=(const TracedMesh&) = delete;

    const rtcore::Mesh& mesh() const { return mesh_; }
    const rtcore::KdTree& tree() const { return exact_; }

    /// Both trees find what all triangles one by one give, bit for bit; so do any-hit rays. Returns that hit.
    rtcore::Hit expectBruteForce(const rtcore::Ray& ray) const {
        rtcore::Hit expected;
        const bool exists = bruteForce(mesh_, ray, expected);
        hits_ += exists ? 1 : 0;
        for (const rtcore::KdTree* tree : {&exact_, &fast_}) {
            rtcore::Hit hit;
            EXPECT_EQ(intersect(*tree, mesh_, ray, hit), exists) << text(ray);
            EXPECT_TRUE(sameBits(hit, expected))
                << hit.triangle << " instead of " << expected.triangle << ", t " << hit.t << " instead of "
                << expected.t << ", " << text(ray);
            EXPECT_EQ(occluded(*tree, mesh_, ray), exists) << text(ray);
        }
        return expected;
    }

    /// The answer is right by brute force in double precision, too.
    void expectRight(const rtcore::Ray& ray) const {
        const rtcore::Hit hit = expectBruteForce(ray);
        const bool found = hit.triangle != rtcore::kNoTriangle;
        const ExactAnswer answer = exactAnswer(mesh_, ray);
        EXPECT_EQ(faultOfClosest(answer, mesh_, ray, found, hit), "") << text(ray);
        EXPECT_EQ(faultOfAny(answer, found), "") << text(ray);
    }

    int hits() const { return hits_; } ///< so far, to see that rays were worth tracing

  private:
    SampleMesh sample_;
    rtcore::Mesh mesh_;
    rtcore::KdTree exact_, fast_;
    mutable int hits_ = 0;
};

inline constexpr float kForever = std::numeric_limits<float>::infinity();

inline rtcore::Ray rayFrom(rtcore::Vec3 origin, rtcore::Vec3 direction) {
    return {origin, 0, direction, kForever};
}

} // namespace test
