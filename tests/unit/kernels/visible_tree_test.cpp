// A tree without the hidden triangles is hit as the whole one is whose hidden triangles are filtered out: the
// same bits, by every kernel on every instruction set.
#include "rtcore/accel/visible_tree.h"

#include "kinds_of_waves.h"
#include "wave_support.h"

#include "rtcore/accel/validation.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <string>
#include <vector>

namespace {

using rtcore::KdRayTracer;
using rtcore::KdTree;
using rtcore::RayWave;

std::vector<std::uint32_t> bitsOfHidden(const std::vector<std::uint8_t>& hidden) {
    std::vector<std::uint32_t> bits(hidden.size() / 32 + 1);
    for (std::size_t i = 0; i < hidden.size(); ++i) bits[i / 32] |= std::uint32_t{hidden[i]} << i % 32;
    return bits;
}

void expectSameHits(const rtcore::RayTracer& visible, const rtcore::RayTracer& filtered,
                    const RayWave& rays) {
    rtcore::HitWave a, b;
    visible.intersect(rtcore::RayKind::Primary, rays, a);
    filtered.intersect(rtcore::RayKind::Primary, rays, b);
    ASSERT_EQ(a.triangle, b.triangle);
    for (std::size_t i = 0; i < rays.size(); ++i) {
        if (!a.isHit(i)) continue;
        EXPECT_EQ(a.t[i], b.t[i]);
        EXPECT_EQ(a.u[i], b.u[i]);
        EXPECT_EQ(a.v[i], b.v[i]);
    }
    std::vector<std::uint8_t> occludedA, occludedB;
    visible.occluded(rtcore::RayKind::Shadow, rays, occludedA);
    filtered.occluded(rtcore::RayKind::Shadow, rays, occludedB);
    EXPECT_EQ(occludedA, occludedB);
}

TEST(VisibleTree, IsHitWhereNothingIsHidden) {
    const test::SampleMesh sample = test::soup(700, 0.4F, 5);
    const rtcore::Mesh mesh = sample.view();
    const KdTree tree = buildKdTree(mesh, {});
    test::Random random(3);
    std::vector<std::uint8_t> hidden(mesh.triangles.size());
    for (std::uint8_t& each : hidden) each = random.index(2) == 0 ? 1 : 0;
    const std::vector<std::uint32_t> bits = bitsOfHidden(hidden);
    const KdTree visible = visibleTree(tree, hidden);
    EXPECT_EQ(validateKdTree(visible, mesh.triangles.size()), std::nullopt);
    EXPECT_EQ(visible.bounds, tree.bounds) << "what depends on the scene's size stays";
    for (const std::uint32_t triangle : visible.references) ASSERT_EQ(hidden[triangle], 0);
    const std::vector<RayWave> waves{test::scattered(900, random), test::camera(12, random),
                                     test::image(32, random)};
    for (const std::string& set : rtcore::instructionSets()) {
        ASSERT_TRUE(rtcore::useInstructionSet(set));
        SCOPED_TRACE(set);
        const KdRayTracer seen(visible, mesh);
        KdRayTracer filtered(tree, mesh);
        filtered.setFilter({bits.data(), nullptr});
        for (const RayWave& wave : waves) expectSameHits(seen, filtered, wave);
    }
    rtcore::useInstructionSet("");
}

TEST(VisibleTree, OfNothingIsEmpty) {
    const test::SampleMesh sample = test::soup(50, 0.4F, 5);
    const rtcore::Mesh mesh = sample.view();
    const KdTree tree = buildKdTree(mesh, {});
    const KdTree none = visibleTree(tree, std::vector<std::uint8_t>(50, 1));
    EXPECT_EQ(none.nodes.size(), 1U);
    EXPECT_TRUE(none.references.empty());
    test::Random random(4);
    const RayWave rays = test::scattered(200, random);
    rtcore::HitWave hits;
    KdRayTracer(none, mesh).intersect(rtcore::RayKind::Primary, rays, hits);
    for (std::size_t i = 0; i < rays.size(); ++i) EXPECT_FALSE(hits.isHit(i));
}

TEST(VisibleTree, WhereNothingIsHiddenIsTheSame) {
    const test::SampleMesh sample = test::soup(300, 0.4F, 6);
    const rtcore::Mesh mesh = sample.view();
    const KdTree tree = buildKdTree(mesh, {});
    const KdTree same = visibleTree(tree, std::vector<std::uint8_t>(300, 0));
    EXPECT_EQ(std::vector(same.references.begin(), same.references.end()),
              std::vector(tree.references.begin(), tree.references.end()));
    EXPECT_EQ(same.nodes.size(), tree.nodes.size());
}

} // namespace
