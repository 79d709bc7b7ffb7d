// Hits where triangles are hidden or have holes: those of a search through all triangles one by one, by every
// kernel on every instruction set.
#include "rtcore/kernels/candidate_filter.h"

#include "kinds_of_waves.h"
#include "wave_support.h"

#include "rtcore/kernels/hit_distance.h"
#include "support/mesh_triangle.h"

#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

using rtcore::CandidateFilter;
using rtcore::Hit;
using rtcore::KdRayTracer;
using rtcore::kNoTriangle;
using rtcore::Obstacle;
using rtcore::Ray;
using rtcore::RayWave;
using test::kGroup;
using test::Random;

namespace {

/// Every second triangle is a chessboard of holes.
class Chessboards final : public rtcore::Holes {
  public:
    bool isHole(std::uint32_t triangle, float u, float v) const override {
        constexpr float kFields = 5;
        const int field = static_cast<int>(u * kFields) + static_cast<int>(v * kFields);
        return triangle % 2 == 0 && field % 2 == 0;
    }
};

/// Triangles of all sizes, some of them narrow, in long leaves and short ones; three materials by turns.
class FilteredScene {
  public:
    FilteredScene(float size, float intersectionCost) : sample_(test::soup(400, size, 1)) {
        Random random(2);
        for (int i = 0; i < 40; ++i) {
            const rtcore::Vec3 a = random.vector(1), along = random.vector(1);
            sample_.addTriangle(a, a + along, a + along * 0.5F + random.vector(1e-4F));
        }
        for (std::uint32_t i = 0; i < sample_.triangles.size(); ++i)
            shading_.push_back({{0, 0, 0}, i % static_cast<std::uint32_t>(kClear.size())});
        mesh_ = sample_.view();
        mesh_.shading = shading_;
        rtcore::BuildOptions options;
        options.intersectionCost = intersectionCost;
        tree_ = buildKdTree(mesh_, options);
        byMesh_ = std::make_unique<KdRayTracer>(tree_, mesh_, rtcore::LeafRecords::Shared);
        byRecords_ = std::make_unique<KdRayTracer>(tree_, mesh_, rtcore::LeafRecords::Inline);
        hidden_.assign(mesh_.triangles.size() / 32 + 1, 0);
        for (std::uint32_t i = 0; i < mesh_.triangles.size(); ++i)
            hidden_[i / 32] |= (random.index(3) == 0 ? 1U : 0U) << i % 32;
    }
    FilteredScene(const FilteredScene&) = delete;
    FilteredScene& operator=(const FilteredScene&) = delete;

    /// None, hidden triangles, holes, both.
    std::vector<std::pair<std::string, CandidateFilter>> filters() const {
        return {{"", {}},
                {"hidden", {hidden_.data(), nullptr}},
                {"holes", {nullptr, &holes_}},
                {"hidden and holes", {hidden_.data(), &holes_}}};
    }

    /// By all triangles one by one. `skip`: none of these materials.
    bool bruteForce(const CandidateFilter& filter, const RayWave& wave, std::size_t ray, Hit& hit,
                    const std::vector<std::uint8_t>& skip = {}) const {
        const Ray r = wave.ray(ray);
        const rtcore::RayShear shear(r.direction);
        hit = {r.tMax, kNoTriangle, 0, 0};
        rtcore::alongAxis(shear.kz, [&](auto kz) {
            for (std::uint32_t i = 0; i < mesh_.triangles.size(); ++i) {
                if (!skip.empty() && skip[shading_[i].material] != 0) continue;
                Hit candidate = hit;
                if (test::testTriangle<kz>(mesh_, i, r, shear, candidate) &&
                    filter.keeps(i, candidate.u, candidate.v))
                    hit = candidate;
            }
        });
        if (hit.triangle == kNoTriangle) return false;
        if (isNear(r, hit, rtcore::nearLimit(mesh_.bounds()))) refineDistance(mesh_, r, hit);
        return true;
    }

    test::WaveAnswer expected(const CandidateFilter& filter, const RayWave& wave) const {
        test::WaveAnswer answer(wave.size());
        for (std::size_t i = 0; i < wave.size(); ++i) {
            Hit hit;
            const bool found = bruteForce(filter, wave, i, hit);
            answer.set(i, found, hit, found);
        }
        return answer;
    }

    std::vector<Obstacle> expectedObstacles(const CandidateFilter& filter, const RayWave& wave) const {
        const std::vector<std::uint8_t> clear(kClear.begin(), kClear.end());
        std::vector<std::uint8_t> opaque;
        for (const std::uint8_t c : clear) opaque.push_back(c == 0 ? 1 : 0);
        std::vector<Obstacle> result;
        for (std::size_t i = 0; i < wave.size(); ++i) {
            Hit hit;
            const bool stopped = bruteForce(filter, wave, i, hit, clear),
                       passes = bruteForce(filter, wave, i, hit, opaque);
            result.push_back(stopped ? Obstacle::Opaque : passes ? Obstacle::Unknown : Obstacle::None);
        }
        return result;
    }

    template <typename Work>
    void forEachKernel(const Work& work) const {
        const test::InstructionSetGuard guard;
        for (const std::string& set : rtcore::instructionSets()) {
            ASSERT_TRUE(rtcore::useInstructionSet(set));
            work(*byMesh_, set + ", shared vertices");
            work(*byRecords_, set + ", inline records");
        }
    }

    static constexpr std::array<std::uint8_t, 3> kClear{1, 0, 1};

  private:
    test::SampleMesh sample_;
    std::vector<rtcore::ShadingTriangle> shading_;
    rtcore::Mesh mesh_;
    rtcore::KdTree tree_;
    std::unique_ptr<KdRayTracer> byMesh_, byRecords_;
    std::vector<std::uint32_t> hidden_;
    Chessboards holes_;
};

/// Waves of every kind that is traced in a way of its own, the last group cut short.
std::vector<std::pair<std::string, RayWave>> kindsOfWaves(Random& random) {
    std::vector<std::pair<std::string, RayWave>> waves{
        {"bundles", test::image(20, random)},
        {"bundles of segments", test::segments(test::image(18, random), random)},
        {"one axis", test::sameWay(6, random)},
        {"to a light", test::toLight(8, random)},
        {"diagonal", test::diagonal(12, random)},
        {"along axes", test::alongAxes(24, random)},
        {"few", test::scattered(3 * kGroup, random)},
        {"stream", test::scattered(20 * kGroup, random)},
        {"stream of segments", test::segments(test::scattered(20 * kGroup, random), random)}};
    for (auto& [name, wave] : waves) wave.resize(wave.size() - 1 - random.index(kGroup - 1));
    return waves;
}

} // namespace

TEST(CandidateFilter, KeepsWhatIsNeitherHiddenNorAHole) {
    const Chessboards holes;
    const std::array<std::uint32_t, 2> hidden{1U << 5, 1U << 3};
    const CandidateFilter filter{hidden.data(), &holes};
    EXPECT_FALSE(filter.keeps(5, 0.1F, 0.1F));
    EXPECT_FALSE(filter.keeps(35, 0.1F, 0.1F));
    EXPECT_FALSE(filter.keeps(4, 0.1F, 0.1F));
    EXPECT_TRUE(filter.keeps(4, 0.3F, 0.1F));
    EXPECT_TRUE(filter.keeps(3, 0.1F, 0.1F));
    EXPECT_FALSE(filter.empty());
    EXPECT_TRUE(CandidateFilter{}.empty());
    EXPECT_TRUE(CandidateFilter{}.keeps(5, 0.1F, 0.1F));
}

TEST(CandidateFilter, RaysHitOnlyWhatItKeeps) {
    Random random(3);
    for (const auto& [size, cost] : {std::pair{0.15F, 0.0F}, std::pair{0.4F, 0.005F}}) {
        const FilteredScene scene(size, cost);
        std::size_t hits = 0;
        for (const auto& [kind, wave] : kindsOfWaves(random)) {
            for (const auto& [name, filter] : scene.filters()) {
                const test::WaveAnswer expected = scene.expected(filter, wave);
                hits += expected.hitCount();
                scene.forEachKernel([&, &kind = kind, &name = name, &filter = filter,
                                     &wave = wave](KdRayTracer& tracer, const std::string& variant) {
                    tracer.setFilter(filter);
                    EXPECT_EQ(difference(test::byWave(tracer, wave), expected, wave), "")
                        << kind << ", " << name << ", " << variant;
                });
            }
        }
        EXPECT_GT(hits, 1000U);
    }
}

TEST(CandidateFilter, ObstaclesAreOnlyWhatItKeeps) {
    Random random(5);
    const FilteredScene scene(0.3F, 0);
    for (const RayWave& wave : {test::toLight(8, random), test::scattered(20 * kGroup - 5, random)}) {
        for (const auto& [name, filter] : scene.filters()) {
            const std::vector<Obstacle> expected = scene.expectedObstacles(filter, wave);
            scene.forEachKernel(
                [&, &name = name, &filter = filter](KdRayTracer& tracer, const std::string& variant) {
                    tracer.setFilter(filter);
                    std::vector<Obstacle> found;
                    tracer.findObstacles(wave, FilteredScene::kClear, found);
                    ASSERT_EQ(found.size(), expected.size());
                    const bool scalar = variant.starts_with("scalar"); // it need not know
                    std::size_t wrong = 0;
                    for (std::size_t i = 0; i < found.size(); ++i) {
                        const bool same = found[i] == expected[i];
                        const bool unknown =
                            scalar && found[i] == Obstacle::Unknown && expected[i] != Obstacle::Opaque;
                        wrong += same || unknown ? 0 : 1;
                    }
                    EXPECT_EQ(wrong, 0U) << name << ", " << variant;
                });
        }
    }
}
