/// Who is fastest, and whether all found the same.
#include "bench/rtbench/race.h"

#include "bench/rtbench/agreement.h"

#include "rtcore/accel/builder.h"
#include "support/sample_meshes.h"

#include <gtest/gtest.h>

#include <stdexcept>

namespace {

using rtbench::Contender;
using rtbench::RayFigures;

/// As another one, a given number of times, and with every `wrongEach`-th answer wrong.
class Altered final : public rtcore::RayTracer {
  public:
    Altered(const rtcore::RayTracer& tracer, int times, std::size_t wrongEach)
        : tracer_(tracer), times_(times), wrongEach_(wrongEach) {}

    void intersect(rtcore::RayKind kind, const rtcore::RayWave& rays, rtcore::HitWave& hits) const override {
        for (int i = 0; i < times_; ++i) tracer_.intersect(kind, rays, hits);
        for (std::size_t i = 0; wrongEach_ > 0 && i < rays.size(); i += wrongEach_) {
            hits.triangle[i] = hits.isHit(i) ? rtcore::kNoTriangle : 0;
        }
    }
    void occluded(rtcore::RayKind kind, const rtcore::RayWave& rays,
                  std::vector<std::uint8_t>& occluded) const override {
        for (int i = 0; i < times_; ++i) tracer_.occluded(kind, rays, occluded);
        for (std::size_t i = 0; wrongEach_ > 0 && i < rays.size(); i += wrongEach_) occluded[i] ^= 1U;
    }
    rtcore::Box3 bounds() const override { return tracer_.bounds(); }

  private:
    const rtcore::RayTracer& tracer_;
    int times_;
    std::size_t wrongEach_;
};

class Races : public testing::Test {
  protected:
    rtbench::RaySet rays(std::size_t kind) const {
        const rtbench::BenchView view{
            .name = "", .eye = {0, 0, 4}, .at = {0, 0, 0}, .fov = 45, .light = {3, 5, 7}};
        return rtbench::RaySource(sphere.view(), tracer, view, 64).make(rtbench::kRayTests.at(kind));
    }
    void add(const std::string& name, bool robust, int times, std::size_t wrongEach) {
        contenders.push_back({name, robust, std::make_unique<Altered>(tracer, times, wrongEach)});
    }

    test::SampleMesh sphere = test::icosphere(3);
    rtcore::KdTree tree = rtcore::buildKdTree(sphere.view(), {});
    rtcore::KdRayTracer tracer{tree, sphere.view()};
    std::vector<Contender> contenders;
};

TEST_F(Races, FindTheBestOfEachClass) {
    add("ours", false, 4, 0);
    add("slow", false, 40, 0);
    add("quick", false, 1, 0);
    add("robust", true, 10, 0);
    add("robust, slow", true, 40, 0);
    for (const std::size_t kind : {0U, 1U}) {
        const RayFigures f = rtbench::race(rays(kind), contenders, {.rounds = 4});
        ASSERT_TRUE(f.best && f.robust);
        EXPECT_EQ(f.best->mode, "quick");
        EXPECT_EQ(f.robust->mode, "robust");
        EXPECT_LT(f.best->ratio, 0.7); // ours does four times the work
        EXPECT_GT(f.robust->ratio, 1.2);
        EXPECT_NEAR(f.speed / f.best->speed, f.best->ratio, 1e-9);
        EXPECT_EQ(f.modes.size(), 4U);
        EXPECT_GE(f.spread, 0);
        EXPECT_EQ(f.best->differences, 0U);
    }
}

TEST_F(Races, SeveralThreadsTraceAllWaves) {
    add("ours", false, 1, 0);
    add("robust", true, 1, 8);
    const rtbench::RaySet set = rays(0);
    const RayFigures f = rtbench::race(set, contenders, {.threads = 3, .rounds = 2});
    EXPECT_EQ(f.rays, 64U * 64U);
    EXPECT_GT(f.speed, 0);
    ASSERT_TRUE(f.robust);
    EXPECT_EQ(f.robust->differences, 64U * 64U / 8);
}

TEST_F(Races, CountWrongAnswers) {
    add("ours", false, 1, 0);
    add("robust", true, 1, 64);
    for (std::size_t kind = 0; kind < rtbench::kRayTests.size(); ++kind) {
        const rtbench::RaySet set = rays(kind);
        const RayFigures f = rtbench::race(set, contenders, {.rounds = 2});
        ASSERT_TRUE(f.robust);
        EXPECT_EQ(f.robust->differences, (set.rays + 63) / 64);
        EXPECT_TRUE(rtbench::areMany(f.robust->differences, set.rays));
    }
    EXPECT_FALSE(rtbench::areMany(10, 1000));
    EXPECT_FALSE(rtbench::areMany(1000, 1'000'000));
}

TEST_F(Races, OursAloneHasNoRivals) {
    add("ours", false, 1, 0);
    const RayFigures f = rtbench::race(rays(0), contenders, {.rounds = 2});
    EXPECT_FALSE(f.best);
    EXPECT_FALSE(f.robust);
    EXPECT_GT(f.speed, 0);
}

TEST_F(Races, CanBeStopped) {
    add("ours", false, 1, 0);
    rtbench::RaceOptions options;
    options.onProgress = [](double) { throw std::runtime_error("stop"); };
    EXPECT_THROW(rtbench::race(rays(0), contenders, options), std::runtime_error);
}

} // namespace
