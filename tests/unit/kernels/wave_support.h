/// A tree whose waves are traced by every kernel on every instruction set.
#pragma once

#include "kernel_support.h"

#include "rtcore/kernels/ray_tracer.h"
#include "rtcore/simd/instruction_set.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace test {

/// Leaves the fastest instruction set in use, whatever a test forced.
class InstructionSetGuard {
  public:
    InstructionSetGuard() = default;
    InstructionSetGuard(const InstructionSetGuard&) = delete;
    InstructionSetGuard& operator=(const InstructionSetGuard&) = delete;
    ~InstructionSetGuard() { rtcore::useInstructionSet("auto"); }
};

/// The hits along each ray of a wave.
struct WaveAnswer {
    rtcore::HitWave hits;
    std::vector<std::uint8_t> occluded;

    /// An answer for `count` rays, all initialised with values that no ray can find.
    explicit WaveAnswer(std::size_t count) : occluded(count, 0xAA) {
        constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
        hits.t.assign(count, kNan);
        hits.u.assign(count, kNan);
        hits.v.assign(count, kNan);
        hits.triangle.assign(count, 0xAAAAAAAAU);
    }
    void set(std::size_t i, bool found, const rtcore::Hit& hit, bool any) {
        hits.triangle[i] = found ? hit.triangle : rtcore::kNoTriangle;
        hits.t[i] = hit.t;
        hits.u[i] = hit.u;
        hits.v[i] = hit.v;
        occluded[i] = any ? 1 : 0;
    }
    std::size_t hitCount() const {
        std::size_t count = 0;
        for (std::size_t i = 0; i < hits.size(); ++i) count += hits.isHit(i) ? 1 : 0;
        return count;
    }
};

inline WaveAnswer bySingleRays(const rtcore::KdTree& tree, const rtcore::Mesh& mesh,
                               const rtcore::RayWave& wave) {
    WaveAnswer answer(wave.size());
    for (std::size_t i = 0; i < wave.size(); ++i) {
        const rtcore::Ray ray = wave.ray(i);
        rtcore::Hit hit;
        const bool found = intersect(tree, mesh, ray, hit);
        answer.set(i, found, hit, occluded(tree, mesh, ray));
    }
    return answer;
}

inline WaveAnswer byBruteForce(const rtcore::Mesh& mesh, const rtcore::RayWave& wave) {
    WaveAnswer answer(wave.size());
    for (std::size_t i = 0; i < wave.size(); ++i) {
        rtcore::Hit hit;
        const bool found = bruteForce(mesh, wave.ray(i), hit);
        answer.set(i, found, hit, found);
    }
    return answer;
}

inline WaveAnswer byWave(const rtcore::RayTracer& tracer, const rtcore::RayWave& wave) {
    WaveAnswer answer(wave.size());
    tracer.intersect(rtcore::RayKind::Scattered, wave, answer.hits);
    tracer.occluded(rtcore::RayKind::Shadow, wave, answer.occluded);
    return answer;
}

/// How many rays differ in any bit, and the first of them; empty when none does.
inline std::string difference(const WaveAnswer& given, const WaveAnswer& expected,
                              const rtcore::RayWave& wave) {
    if (given.hits.size() != wave.size() || given.occluded.size() != wave.size()) return "another length";
    std::size_t count = 0;
    std::ostringstream first;
    for (std::size_t i = 0; i < wave.size(); ++i) {
        const rtcore::Hit a = given.hits.hit(i);
        const rtcore::Hit b = expected.hits.hit(i);
        const bool same = expected.hits.isHit(i) ? sameBits(a, b) : !given.hits.isHit(i);
        if (same && given.occluded[i] == expected.occluded[i]) continue;
        if (++count > 1) continue;
        const auto print = [&](const WaveAnswer& answer, const rtcore::Hit& hit) {
            first << std::hexfloat << "t " << hit.t << " u " << hit.u << " v " << hit.v << " triangle "
                  << std::dec << static_cast<std::int32_t>(hit.triangle) << " any "
                  << int{answer.occluded[i]};
        };
        print(given, a);
        first << " instead of ";
        print(expected, b);
        first << " at ray " << i << ": " << text(wave.ray(i));
    }
    return count == 0 ? "" : std::to_string(count) + " rays differ, the first with " + first.str();
}

/// A mesh and a tree of it, with tracers for both kinds of records.
class WaveScene {
  public:
    explicit WaveScene(SampleMesh sample, const rtcore::BuildOptions& options = {})
        : sample_(std::move(sample)), mesh_(sample_.view()), tree_(buildKdTree(mesh_, options)),
          byRecords_(tree_, mesh_, rtcore::LeafRecords::Inline),
          byMesh_(tree_, mesh_, rtcore::LeafRecords::Shared) {}
    WaveScene(const WaveScene&) = delete;
    WaveScene& operator=(const WaveScene&) = delete;

    const rtcore::Mesh& mesh() const { return mesh_; }
    const rtcore::KdTree& tree() const { return tree_; }
    std::size_t longestLeaf() const {
        std::size_t longest = 0;
        for (const rtcore::KdNode node : tree_.nodes) {
            if (node.isLeaf()) longest = std::max<std::size_t>(longest, node.count());
        }
        return longest;
    }

    /// Every instruction set and both kinds of records find in the wave what single rays find, bit for bit.
    /// Returns how many rays hit something.
    std::size_t expectSingleRays(const std::string& name, const rtcore::RayWave& wave) const {
        return expectEverywhere(name, wave, bySingleRays(tree_, mesh_, wave));
    }

    /// The same, and single rays find what all triangles one by one give. For small meshes.
    std::size_t expectBruteForce(const std::string& name, const rtcore::RayWave& wave) const {
        const WaveAnswer expected = byBruteForce(mesh_, wave);
        EXPECT_EQ(difference(bySingleRays(tree_, mesh_, wave), expected, wave), "")
            << name << ", single rays";
        return expectEverywhere(name, wave, expected);
    }

    /// Every instruction set and both kinds of records find something possible, whatever it is.
    void expectAnswers(const std::string& name, const rtcore::RayWave& wave) const {
        forEachVariant([&](const rtcore::RayTracer& tracer, const std::string& variant) {
            const WaveAnswer answer = byWave(tracer, wave);
            std::size_t wrong = 0;
            for (std::size_t i = 0; i < wave.size(); ++i) {
                const bool known = !answer.hits.isHit(i) || answer.hits.triangle[i] < mesh_.triangles.size();
                const bool inRange = !answer.hits.isHit(i) || answer.hits.t[i] >= wave.tMin[i];
                if (!known || !inRange || answer.occluded[i] > 1) ++wrong;
            }
            EXPECT_EQ(wrong, 0U) << name << variant;
        });
    }

  private:
    template <typename Work>
    void forEachVariant(Work&& work) const {
        const InstructionSetGuard guard;
        for (const std::string& instructions : rtcore::instructionSets()) {
            EXPECT_TRUE(rtcore::useInstructionSet(instructions));
            work(byRecords_, ", " + instructions + ", inline records");
            work(byMesh_, ", " + instructions + ", shared vertices");
        }
    }

    std::size_t expectEverywhere(const std::string& name, const rtcore::RayWave& wave,
                                 const WaveAnswer& expected) const {
        forEachVariant([&](const rtcore::RayTracer& tracer, const std::string& variant) {
            EXPECT_EQ(difference(byWave(tracer, wave), expected, wave), "") << name << variant;
        });
        return expected.hitCount();
    }

    SampleMesh sample_;
    rtcore::Mesh mesh_;
    rtcore::KdTree tree_;
    rtcore::KdRayTracer byRecords_, byMesh_;
};

} // namespace test
