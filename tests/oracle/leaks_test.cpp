// Do closed meshes leak? Rays from inside are aimed where cells and triangles meet; each must hit something,
// whichever kernel traces it. RT_LEAK_RAYS sets how many each kernel gets (200,000 unless told; 100,000,000
// in the long check), RT_ISA the instruction set.
#include "leak_waves.h"

#include "rtcore/accel/builder.h"
#include "rtcore/kernels/ray_tracer.h"
#include "rtcore/kernels/single_ray.h"
#include "rtcore/simd/instruction_set.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <tuple>
#include <vector>

using rtcore::KdRayTracer;
using rtcore::LeafRecords;
using rtcore::Ray;
using rtcore::RayWave;
using test::Kernel;
using test::LeakAim;
using test::Random;
using test::Solid;

namespace {

constexpr std::uint64_t kCases = 9, kTreesOfCase = 2;

std::uint64_t raysOfKernel() {
    const char* const text = std::getenv("RT_LEAK_RAYS");
    const long long count = text != nullptr ? std::atoll(text) : 0;
    return count > 0 ? static_cast<std::uint64_t>(count) : 200'000;
}

struct Count {
    std::uint64_t rays = 0, leaks = 0, strayGroups = 0;

    void add(const Count& other) {
        rays += other.rays;
        leaks += other.leaks;
        strayGroups += other.strayGroups;
    }
};

/// A mesh in a tree, traced by every kernel.
class Subject {
  public:
    Subject(const LeakAim& aim, const rtcore::BuildOptions& options)
        : aim_(aim),
          tree_(buildKdTree(aim.mesh(), options)), tracers_{
                                                       KdRayTracer(tree_, aim.mesh(), LeafRecords::Inline),
                                                       KdRayTracer(tree_, aim.mesh(), LeafRecords::Shared)} {}

    /// At least `rays` rays. Which ones does not depend on the number of threads.
    Count trace(Kernel kernel, std::uint64_t rays) const {
        const std::size_t length = rays >= 1'000'000 ? 16384 : 2048;
        const std::uint64_t waves = (rays + length - 1) / length;
        Count all;
#pragma omp parallel for schedule(dynamic)
        for (std::uint64_t number = 0; number < waves; ++number) {
            const Count count = traceWaves(kernel, number, length);
#pragma omp critical
            all.add(count);
        }
        return all;
    }

  private:
    /// `count` rays; fewer at once where more would go another way. Closest and any hit by turns, from
    /// records and from the mesh by turns.
    Count traceWaves(Kernel kernel, std::uint64_t number, std::size_t count) const {
        constexpr std::size_t kFew = 448;
        Random random(1000 * number + static_cast<std::uint64_t>(kernel));
        const bool closest = number % 2 == 0;
        const KdRayTracer& tracer = tracers_[number / 2 % 2];
        const std::size_t length = kernel == Kernel::Packet ? kFew : count;
        Count sum;
        RayWave wave;
        for (std::size_t first = 0; first < count; first += length) {
            wave.clear();
            fill(kernel, length, random, wave);
            sum.add(countLeaks(kernel, closest, tracer, wave));
        }
        return sum;
    }

    void fill(Kernel kernel, std::size_t count, Random& random, RayWave& wave) const {
        if (kernel == Kernel::AxisPacket || kernel == Kernel::OriginPacket) {
            pushCoherent(aim_, kernel == Kernel::AxisPacket, count, random, wave);
        } else {
            pushScattered(aim_, count, random, wave);
        }
    }

    Count countLeaks(Kernel kernel, bool closest, const KdRayTracer& tracer, const RayWave& wave) const {
        Count count;
        count.rays = wave.size();
        const std::vector<std::uint8_t> found = hitsOf(kernel, closest, tracer, wave);
        for (std::size_t i = 0; i < wave.size(); ++i) {
            if (found[i] != 0) continue;
            if (++count.leaks <= 3) describe(kernel, closest, wave.ray(i));
        }
        if (kernel == Kernel::Single) return count;
        for (std::size_t first = 0; first < wave.size(); first += test::kRaysOfGroup) {
            if (!isFor(kernel, wave, first)) ++count.strayGroups;
        }
        return count;
    }

    std::vector<std::uint8_t> hitsOf(Kernel kernel, bool closest, const KdRayTracer& tracer,
                                     const RayWave& wave) const {
        std::vector<std::uint8_t> found(wave.size());
        if (kernel == Kernel::Single) {
            for (std::size_t i = 0; i < wave.size(); ++i) {
                rtcore::Hit hit;
                found[i] = closest ? intersect(tree_, aim_.mesh(), wave.ray(i), hit)
                                   : occluded(tree_, aim_.mesh(), wave.ray(i));
            }
        } else if (closest) {
            rtcore::HitWave hits;
            tracer.intersect(rtcore::RayKind::Scattered, wave, hits);
            for (std::size_t i = 0; i < wave.size(); ++i) found[i] = hits.isHit(i);
        } else {
            tracer.occluded(rtcore::RayKind::Shadow, wave, found);
        }
        return found;
    }

    static void describe(Kernel kernel, bool closest, const Ray& ray) {
        std::printf("leak (%s, %s hit): origin %a %a %a direction %a %a %a\n", nameOf(kernel),
                    closest ? "closest" : "any", double{ray.origin.x}, double{ray.origin.y},
                    double{ray.origin.z}, double{ray.direction.x}, double{ray.direction.y},
                    double{ray.direction.z});
    }

    const LeakAim& aim_;
    rtcore::KdTree tree_;
    KdRayTracer tracers_[2];
};

std::string nameOfCase(const testing::TestParamInfo<std::tuple<Solid, float>>& testCase) {
    const auto [solid, offset] = testCase.param;
    const std::string name = solid == Solid::Box ? "box" : solid == Solid::Sphere ? "sphere" : "torus";
    return name + std::to_string(static_cast<int>(offset));
}

/// The sum of all cases of one run.
Count& totalOf(Kernel kernel) {
    static Count totals[std::size(test::kKernels)];
    return totals[static_cast<std::size_t>(kernel)];
}

class Leaks : public testing::TestWithParam<std::tuple<Solid, float>> {
  protected:
    static void SetUpTestSuite() { rtcore::useInstructionSetOfEnvironment(); }

    static void TearDownTestSuite() {
        for (const Kernel kernel : test::kKernels) {
            const Count& total = totalOf(kernel);
            std::printf("all cases, %s, %s: %llu rays, %llu leaks\n", rtcore::instructionSet().c_str(),
                        nameOf(kernel), static_cast<unsigned long long>(total.rays),
                        static_cast<unsigned long long>(total.leaks));
        }
    }
};

} // namespace

TEST_P(Leaks, NoneInTheExactNorInTheFastTree) {
    const auto [solid, offset] = GetParam();
    const test::ClosedMesh closed = test::makeSolid(solid, offset);
    const LeakAim aim(closed);
    for (const auto method : {rtcore::BuildMethod::Exact, rtcore::BuildMethod::Fast}) {
        rtcore::BuildOptions options;
        options.method = method;
        const Subject subject(aim, options);
        for (const Kernel kernel : test::kKernels) {
            const auto start = std::chrono::steady_clock::now();
            const Count count = subject.trace(kernel, raysOfKernel() / (kCases * kTreesOfCase) + 1);
            const double seconds =
                std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
            std::printf("%zu triangles, %s tree, %s: %llu rays, %.2f million per second, %llu leaks\n",
                        aim.mesh().triangles.size(), method == rtcore::BuildMethod::Exact ? "exact" : "fast",
                        nameOf(kernel), static_cast<unsigned long long>(count.rays),
                        static_cast<double>(count.rays) / seconds * 1e-6,
                        static_cast<unsigned long long>(count.leaks));
            EXPECT_EQ(count.leaks, 0U) << nameOf(kernel);
            EXPECT_EQ(count.strayGroups, 0U) << nameOf(kernel);
            totalOf(kernel).add(count);
        }
    }
}

INSTANTIATE_TEST_SUITE_P(ClosedMeshes, Leaks,
                         testing::Combine(testing::Values(Solid::Box, Solid::Sphere, Solid::Torus),
                                          testing::Values(0.0F, 1e2F, 1e4F)),
                         nameOfCase);
