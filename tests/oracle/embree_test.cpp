// The kernels and Embree trace the same rays; where they differ, brute force in double precision decides.
// The kernels' hits of whole waves have the same bits as those of single rays. RT_TEST_SCENES is the folder
// of models; RT_ORACLE_RAYS sets how many rays of each kind (200,000 by default), RT_ISA the instruction set.
#include "rtcore/accel/builder.h"
#include "rtcore/kernels/ray_tracer.h"
#include "rtcore/kernels/single_ray.h"
#include "rtcore/simd/instruction_set.h"
#include "support/embree_scene.h"
#include "support/exact_rays.h"
#include "support/mesh_files.h"
#include "support/view_rays.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <ostream>
#include <string>
#include <vector>

using rtcore::Hit;
using rtcore::Ray;

namespace test {

std::ostream& operator<<(std::ostream& out, const View& view) { return out << view.name; }

} // namespace test

namespace {

std::size_t rayCount() {
    const char* const text = std::getenv("RT_ORACLE_RAYS");
    const long long count = text != nullptr ? std::atoll(text) : 0;
    return count > 0 ? static_cast<std::size_t>(count) : 200'000;
}

/// Verdicts over the rays on which the two differ.
struct Verdicts {
    std::size_t rays = 0, hits = 0, differences = 0;
    std::size_t otherBits = 0; ///< ours in waves, compared with our single rays
    std::size_t oursWrong = 0, theirsWrong = 0;
    std::size_t undecidable = 0; ///< both are right within the rounding of single precision
    /// Undecidable ones where ours, or theirs, is within 1e-4 of the answer in double, edges included.
    std::size_t oursExact = 0, theirsExact = 0;

    void count(bool hit, bool asAlone) {
        ++rays;
        hits += hit ? 1 : 0;
        otherBits += asAlone ? 0 : 1;
    }

    void print(const char* scene, const char* kind) const {
        std::printf("%-8s %-8s %-6s %8zu rays, %8zu hits, %4zu differ: ours wrong %zu, Embree wrong %zu, "
                    "within rounding "
                    "%zu (within 1e-4 of double: ours %zu, Embree %zu)\n",
                    scene, kind, rtcore::instructionSet().c_str(), rays, hits, differences, oursWrong,
                    theirsWrong, undecidable, oursExact, theirsExact);
    }
};

struct Answer {
    bool found = false;
    Hit hit;
};

bool sameBits(const Answer& a, const Answer& b) {
    const auto bits = [](float x) { return std::bit_cast<std::uint32_t>(x); };
    if (!a.found || !b.found) return a.found == b.found;
    return a.hit.triangle == b.hit.triangle && bits(a.hit.t) == bits(b.hit.t) &&
           bits(a.hit.u) == bits(b.hit.u) && bits(a.hit.v) == bits(b.hit.v);
}

bool differ(const Answer& a, const Answer& b) {
    if (a.found != b.found) return true;
    return a.found && std::fabs(a.hit.t - b.hit.t) > 1e-4F * std::max(a.hit.t, b.hit.t);
}

bool isExact(const Answer& answer, double nearest) {
    if (!answer.found || std::isinf(nearest)) return !answer.found && std::isinf(nearest);
    return std::fabs(answer.hit.t - nearest) <= 1e-4 * nearest;
}

/// A ray on which the two differ.
struct Dispute {
    Ray ray;
    Answer ours, theirs;
};

class AgainstEmbree : public testing::TestWithParam<test::View> {
  protected:
    static void SetUpTestSuite() { rtcore::useInstructionSetOfEnvironment(); }

    void SetUp() override {
        const char* const folder = std::getenv("RT_TEST_SCENES");
        if (folder == nullptr) GTEST_SKIP() << "RT_TEST_SCENES is not set";
        sample_ = test::readMesh(std::filesystem::path(folder) / GetParam().file);
        mesh_ = sample_.view();
        tree_ = buildKdTree(mesh_, {});
        tracer_ = std::make_unique<rtcore::KdRayTracer>(tree_, mesh_);
        embree_ = std::make_unique<test::EmbreeScene>(mesh_);
    }

    std::vector<Hit> compareClosest(const char* kind, const std::vector<Ray>& rays) const {
        std::vector<Hit> hits;
        std::vector<Dispute> disputes;
        Verdicts verdicts;
        forEachWave(rays, [&](const rtcore::RayWave& wave) {
            rtcore::HitWave found;
            tracer_->intersect(rtcore::RayKind::Scattered, wave, found);
            for (std::size_t i = 0; i < wave.size(); ++i) {
                Dispute d{wave.ray(i), {}, {}};
                if (found.isHit(i)) d.ours = {true, found.hit(i)};
                Answer single;
                single.found = intersect(tree_, mesh_, d.ray, single.hit);
                d.theirs.found = embree_->intersect(d.ray, d.theirs.hit);
                hits.push_back(d.ours.hit);
                verdicts.count(d.ours.found, sameBits(d.ours, single));
                if (differ(d.ours, d.theirs)) disputes.push_back(d);
            }
        });
        decide(disputes, verdicts, [&](const test::ExactAnswer& answer, const Ray& ray, const Answer& given) {
            return test::faultOfClosest(answer, mesh_, ray, given.found, given.hit);
        });
        expectRight(kind, verdicts);
        return hits;
    }

    void compareAny(const char* kind, const std::vector<Ray>& rays) const {
        std::vector<Dispute> disputes;
        Verdicts verdicts;
        forEachWave(rays, [&](const rtcore::RayWave& wave) {
            std::vector<std::uint8_t> found;
            tracer_->occluded(rtcore::RayKind::Shadow, wave, found);
            for (std::size_t i = 0; i < wave.size(); ++i) {
                Dispute d{wave.ray(i), {}, {}};
                d.ours.found = found[i] != 0;
                d.theirs.found = embree_->occluded(d.ray);
                verdicts.count(d.ours.found, d.ours.found == occluded(tree_, mesh_, d.ray));
                if (d.ours.found != d.theirs.found) disputes.push_back(d);
            }
        });
        decide(disputes, verdicts, [](const test::ExactAnswer& answer, const Ray&, const Answer& given) {
            return test::faultOfAny(answer, given.found);
        });
        expectRight(kind, verdicts);
    }

    /// Calls `work` with the rays, in waves as long as those of a renderer.
    template <typename Work>
    static void forEachWave(const std::vector<Ray>& rays, Work&& work) {
        constexpr std::size_t kLongest = 16384;
        rtcore::RayWave wave;
        for (std::size_t i = 0; i < rays.size(); ++i) {
            wave.push(rays[i]);
            if (wave.size() < kLongest && i + 1 < rays.size()) continue;
            work(wave);
            wave.clear();
        }
    }

    static void expectRight(const char* kind, const Verdicts& verdicts) {
        verdicts.print(GetParam().name, kind);
        EXPECT_EQ(verdicts.oursWrong, 0U);
        EXPECT_EQ(verdicts.otherBits, 0U) << kind << " rays find other things in waves than alone";
    }

    template <typename FaultOf>
    void decide(const std::vector<Dispute>& disputes, Verdicts& verdicts, FaultOf&& faultOf) const {
        verdicts.differences = disputes.size();
#pragma omp parallel for schedule(dynamic)
        for (std::size_t i = 0; i < disputes.size(); ++i) {
            const Dispute& d = disputes[i];
            const test::ExactAnswer answer = test::exactAnswer(mesh_, d.ray);
            const std::string ourFault = faultOf(answer, d.ray, d.ours);
            const std::string theirFault = faultOf(answer, d.ray, d.theirs);
#pragma omp critical
            count(ourFault, theirFault, isExact(d.ours, answer.nearestInside),
                  isExact(d.theirs, answer.nearestInside), verdicts);
        }
    }

    static void count(const std::string& ourFault, const std::string& theirFault, bool oursExact,
                      bool theirsExact, Verdicts& verdicts) {
        verdicts.oursWrong += ourFault.empty() ? 0 : 1;
        verdicts.theirsWrong += theirFault.empty() ? 0 : 1;
        if (!ourFault.empty()) std::printf("ours: %s\n", ourFault.c_str());
        if (!ourFault.empty() || !theirFault.empty()) return;
        ++verdicts.undecidable;
        verdicts.oursExact += oursExact ? 1 : 0;
        verdicts.theirsExact += theirsExact ? 1 : 0;
    }

    test::SampleMesh sample_;
    rtcore::Mesh mesh_;
    rtcore::KdTree tree_;
    std::unique_ptr<rtcore::KdRayTracer> tracer_;
    std::unique_ptr<test::EmbreeScene> embree_;
};

std::string nameOfView(const testing::TestParamInfo<test::View>& view) { return view.param.name; }

} // namespace

TEST_P(AgainstEmbree, OursIsNeverTheWrongOne) {
    const int side = (static_cast<int>(std::sqrt(static_cast<double>(rayCount()))) + 3) / 4 * 4;
    const std::vector<Ray> primary = primaryRays(GetParam(), side);
    const std::vector<Hit> hits = compareClosest("primary", primary);
    // As many of the other kinds, however few pixels show the model.
    const auto points = test::surfacePoints(mesh_, primary, hits);
    ASSERT_FALSE(points.empty());
    std::vector<Ray> shadows = test::shadowRays(points, GetParam().light);
    std::vector<Ray> bounces;
    for (std::uint64_t seed = 0; bounces.size() < rayCount(); ++seed) {
        const std::vector<Ray> more = test::diffuseRays(points, seed);
        bounces.insert(bounces.end(), more.begin(), more.end());
    }
    bounces.resize(rayCount());
    // Shadows seen from the points that the bounces reach, too.
    const std::vector<Hit> second = compareClosest("diffuse", bounces);
    const std::vector<Ray> farther =
        test::shadowRays(test::surfacePoints(mesh_, bounces, second), GetParam().light);
    shadows.insert(shadows.end(), farther.begin(), farther.end());
    compareAny("shadow", shadows);
}

INSTANTIATE_TEST_SUITE_P(Scenes, AgainstEmbree, testing::ValuesIn(test::kViews), nameOfView);
