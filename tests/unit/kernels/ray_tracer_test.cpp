#include "rtcore/kernels/ray_tracer.h"

#include "kernel_support.h"
#include "rtcore/kernels/ray_statistics.h"

#include <thread>
#include <vector>

using rtcore::HitWave;
using rtcore::KdRayTracer;
using rtcore::RayKind;
using rtcore::RayWave;
using test::TracedMesh;

namespace {

constexpr RayKind kAllKinds[] = {RayKind::Primary,   RayKind::Shadow,    RayKind::Mirror,
                                 RayKind::Refracted, RayKind::Occlusion, RayKind::Scattered};

RayWave randomWave(std::size_t count, std::uint64_t seed) {
    test::Random random(seed);
    RayWave wave;
    for (std::size_t i = 0; i < count; ++i) {
        const float tMin = random.number(0, 0.2F);
        wave.push({random.vector(1.2F), tMin, random.unitVector(), tMin + random.number(0, 3)});
    }
    return wave;
}

/// Expects the answers of single calls for each ray.
void expectSingleCalls(const TracedMesh& scene, const RayWave& wave, const HitWave& hits,
                       const std::vector<std::uint8_t>& occluded) {
    ASSERT_EQ(hits.size(), wave.size());
    ASSERT_EQ(occluded.size(), wave.size());
    for (std::size_t i = 0; i < wave.size(); ++i) {
        rtcore::Hit single;
        const bool found = intersect(scene.tree(), scene.mesh(), wave.ray(i), single);
        EXPECT_EQ(hits.isHit(i), found);
        EXPECT_EQ(occluded[i], found ? 1 : 0);
        if (!found) continue;
        EXPECT_TRUE(test::sameBits(hits.hit(i), single));
    }
}

} // namespace

TEST(RayTracer, WavesOfAnySizeAgreeWithSingleCalls) {
    const TracedMesh scene(test::soup(2000, 0.15F, 1));
    const KdRayTracer tracer(scene.tree(), scene.mesh());
    HitWave hits;
    std::vector<std::uint8_t> occluded;
    for (const std::size_t count : {0UL, 1UL, 7UL, 64UL, 65UL, 1000UL, 5000UL, 3UL}) {
        const RayWave wave = randomWave(count, count);
        for (const RayKind kind : kAllKinds) {
            tracer.intersect(kind, wave, hits);
            tracer.occluded(kind, wave, occluded);
            expectSingleCalls(scene, wave, hits, occluded);
        }
    }
}

TEST(RayTracer, ManyThreadsMayTraceAtOnce) {
    const TracedMesh scene(test::icosphere(4));
    const KdRayTracer tracer(scene.tree(), scene.mesh());
    std::vector<HitWave> hits(4);
    std::vector<std::vector<std::uint8_t>> occluded(4);
    {
        std::vector<std::jthread> threads;
        for (std::size_t i = 0; i < hits.size(); ++i) {
            threads.emplace_back([&, i] {
                const RayWave wave = randomWave(2000, i);
                tracer.intersect(RayKind::Scattered, wave, hits[i]);
                tracer.occluded(RayKind::Shadow, wave, occluded[i]);
            });
        }
    }
    for (std::size_t i = 0; i < hits.size(); ++i) {
        expectSingleCalls(scene, randomWave(2000, i), hits[i], occluded[i]);
    }
}

TEST(RayTracer, TheEmptySceneIsNeverHit) {
    const TracedMesh scene(test::SampleMesh{});
    const KdRayTracer tracer(scene.tree(), scene.mesh());
    const RayWave wave = randomWave(100, 2);
    HitWave hits;
    std::vector<std::uint8_t> occluded;
    tracer.intersect(RayKind::Primary, wave, hits);
    tracer.occluded(RayKind::Shadow, wave, occluded);
    expectSingleCalls(scene, wave, hits, occluded);
}

TEST(RayWave, KeepsWhatIsPushed) {
    RayWave wave;
    EXPECT_TRUE(wave.empty());
    wave.push({{1, 2, 3}, 4, {5, 6, 7}, 8});
    wave.push({{9, 10, 11}, 12, {13, 14, 15}, 16});
    ASSERT_EQ(wave.size(), 2U);
    EXPECT_EQ(wave.ray(1).origin, (rtcore::Vec3{9, 10, 11}));
    EXPECT_EQ(wave.ray(1).tMin, 12);
    EXPECT_EQ(wave.ray(1).direction, (rtcore::Vec3{13, 14, 15}));
    EXPECT_EQ(wave.ray(1).tMax, 16);
    wave.resize(1);
    ASSERT_EQ(wave.size(), 1U);
    EXPECT_EQ(wave.ray(0).direction, (rtcore::Vec3{5, 6, 7}));
    const std::size_t memory = wave.ox.capacity();
    wave.clear();
    EXPECT_TRUE(wave.empty());
    EXPECT_EQ(wave.ox.capacity(), memory);
}

TEST(RayStatistics, AddUpByKind) {
    rtcore::RayStatistics a;
    a.count(RayKind::Primary, 10);
    a.count(RayKind::Shadow, 3);
    rtcore::RayStatistics b;
    b.count(RayKind::Shadow, 4);
    a.add(b);
    EXPECT_EQ(a.rays[static_cast<std::size_t>(RayKind::Shadow)], 7U);
    EXPECT_EQ(a.total(), 17U);
}
