// Which shadow rays are settled at once: triangles of materials that let light through stop none.
#include "rtcore/kernels/ray_tracer.h"

#include "wave_support.h"

#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <string>
#include <vector>

using rtcore::KdRayTracer;
using rtcore::Obstacle;
using rtcore::RayWave;

namespace {

/// Triangles in the order of their materials' turns, some long and thin; one of three materials is opaque.
class MixedSoup {
  public:
    explicit MixedSoup(std::uint64_t seed) : all_(test::soup(3000, 0.12F, seed)) {
        test::Random random(seed + 1);
        for (int i = 0; i < 300; ++i) { // narrow ones
            const rtcore::Vec3 a = random.vector(1), along = random.vector(1);
            all_.addTriangle(a, a + along, a + along * 0.5F + random.vector(1e-4F));
        }
        for (std::size_t i = 0; i < all_.triangles.size(); ++i) {
            const auto material = static_cast<std::uint32_t>(i % kClear.size());
            shading_.push_back({{0, 0, 0}, material});
            (kClear[material] != 0 ? clear_ : opaque_).triangles.push_back(all_.triangles[i]);
        }
        clear_.vertices = opaque_.vertices = all_.vertices;
        mesh_ = all_.view();
        mesh_.shading = shading_;
        tree_ = rtcore::buildKdTree(mesh_, {});
    }
    const rtcore::KdTree& tree() const { return tree_; }
    const rtcore::Mesh& mesh() const { return mesh_; }

    /// By tracers that know one kind of triangles each.
    std::vector<Obstacle> expected(const RayWave& wave) const {
        const test::TracedMesh opaque(opaque_), clear(clear_);
        std::vector<Obstacle> result;
        for (std::size_t i = 0; i < wave.size(); ++i) {
            const bool stopped = rtcore::occluded(opaque.tree(), opaque.mesh(), wave.ray(i));
            const bool passes = rtcore::occluded(clear.tree(), clear.mesh(), wave.ray(i));
            result.push_back(stopped ? Obstacle::Opaque : passes ? Obstacle::Unknown : Obstacle::None);
        }
        return result;
    }

    static constexpr std::array<std::uint8_t, 3> kClear{1, 0, 1};

  private:
    test::SampleMesh all_, opaque_, clear_;
    std::vector<rtcore::ShadingTriangle> shading_;
    rtcore::Mesh mesh_;
    rtcore::KdTree tree_;
};

RayWave anywhere(std::size_t count) {
    test::Random random(count);
    RayWave wave;
    for (std::size_t i = 0; i < count; ++i)
        wave.push({random.vector(1.2F), random.number(0, 0.1F), random.unitVector(), random.number(0.1F, 1)});
    return wave;
}

/// From one point, as packets like them.
RayWave fromOnePoint(std::size_t count) {
    test::Random random(count);
    RayWave wave;
    for (std::size_t i = 0; i < count; ++i) {
        const float x = static_cast<float>(i % 64) / 64 - 0.5F,
                    y = static_cast<float>(i / 64 % 64) / 64 - 0.5F;
        wave.push({{0.1F, 0.2F, 1.5F}, 0, rtcore::normalize({x, y, -1}), random.number(0.2F, 2.5F)});
    }
    return wave;
}

} // namespace

TEST(FindObstacles, TellsOpaqueTrianglesFromThoseThatLetLightThrough) {
    const MixedSoup soup(1);
    const test::InstructionSetGuard guard;
    for (const RayWave& wave :
         {anywhere(5000), fromOnePoint(4096), anywhere(70), fromOnePoint(64), RayWave{}}) {
        const std::vector<Obstacle> expected = soup.expected(wave);
        for (const std::string& set : rtcore::instructionSets()) {
            ASSERT_TRUE(rtcore::useInstructionSet(set));
            for (const auto records : {rtcore::LeafRecords::Shared, rtcore::LeafRecords::Inline}) {
                const KdRayTracer tracer(soup.tree(), soup.mesh(), records);
                std::vector<Obstacle> found;
                tracer.findObstacles(wave, MixedSoup::kClear, found);
                ASSERT_EQ(found.size(), expected.size());
                for (std::size_t i = 0; i < found.size(); ++i) {
                    if (set == "scalar" && found[i] == Obstacle::Unknown) { // it need not know
                        ASSERT_NE(expected[i], Obstacle::Opaque) << i;
                    } else {
                        ASSERT_EQ(found[i], expected[i]) << set << ' ' << i;
                    }
                }
            }
        }
    }
}

TEST(FindObstacles, OtherTracersNeedNotKnow) {
    class Ignorant final : public rtcore::RayTracer {
      public:
        void intersect(rtcore::RayKind, const RayWave&, rtcore::HitWave&) const override {}
        void occluded(rtcore::RayKind, const RayWave&, std::vector<std::uint8_t>&) const override {}
        rtcore::Box3 bounds() const override { return {}; }
    };
    std::vector<Obstacle> found;
    Ignorant().findObstacles(anywhere(9), MixedSoup::kClear, found);
    EXPECT_EQ(found, std::vector<Obstacle>(9, Obstacle::Unknown));
}
