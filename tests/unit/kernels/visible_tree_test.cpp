// A tree without the hidden triangles, pruned or built anew, is hit as the whole one is whose hidden
// triangles are filtered out: the same bits, by every kernel on every instruction set.
#include "rtcore/accel/visible_tree.h"

#include "kinds_of_waves.h"
#include "wave_support.h"

#include "rtcore/accel/validation.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <span>
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

struct Half {
    test::SampleMesh sample = test::soup(700, 0.4F, 5);
    rtcore::Mesh mesh = sample.view();
    KdTree tree = buildKdTree(mesh, {});
    test::Random random{3};
    std::vector<std::uint8_t> hidden;
    std::vector<std::uint32_t> bits;

    Half() {
        for (std::size_t i = 0; i < mesh.triangles.size(); ++i) hidden.push_back(random.coin() ? 1 : 0);
        bits = bitsOfHidden(hidden);
    }
    void expectVisible(const KdTree& visible, const rtcore::RayTracer& seen) {
        EXPECT_EQ(visible.bounds, tree.bounds) << "what depends on the scene's size stays";
        KdRayTracer filtered(tree, mesh);
        filtered.setFilter({bits.data(), nullptr});
        for (const RayWave& wave :
             {test::scattered(900, random), test::camera(12, random), test::image(32, random)})
            expectSameHits(seen, filtered, wave);
    }
};

TEST(VisibleTree, IsHitWhereNothingIsHidden) {
    Half half;
    const KdTree visible = visibleTree(half.tree, half.hidden);
    for (const rtcore::KdNode node : visible.nodes) {
        if (!node.isLeaf()) continue;
        for (const std::uint32_t triangle : visible.references.subspan(node.firstReference, node.count()))
            ASSERT_EQ(half.hidden[triangle], 0);
    }
    const KdRayTracer whole(half.tree, half.mesh);
    for (const std::string& set : rtcore::instructionSets()) {
        ASSERT_TRUE(rtcore::useInstructionSet(set));
        SCOPED_TRACE(set);
        half.expectVisible(visible, KdRayTracer(visible, half.mesh));
        half.expectVisible(visible, KdRayTracer(visible, whole));
    }
    rtcore::useInstructionSet("");
}

TEST(VisibleTree, BuiltAnewIsHitWhereNothingIsHidden) {
    Half half;
    const KdTree visible = buildVisibleTree(half.mesh, half.hidden, half.tree.bounds);
    EXPECT_EQ(validateKdTree(visible, half.mesh.triangles.size()), std::nullopt);
    for (const std::uint32_t triangle : visible.references) ASSERT_EQ(half.hidden[triangle], 0);
    EXPECT_LT(visible.references.size(), visibleTree(half.tree, half.hidden).references.size());
    for (const std::string& set : rtcore::instructionSets()) {
        ASSERT_TRUE(rtcore::useInstructionSet(set));
        SCOPED_TRACE(set);
        half.expectVisible(visible, KdRayTracer(visible, half.mesh));
    }
    rtcore::useInstructionSet("");
}

TEST(VisibleTree, OfNothingIsEmpty) {
    const test::SampleMesh sample = test::soup(50, 0.4F, 5);
    const rtcore::Mesh mesh = sample.view();
    const KdTree tree = buildKdTree(mesh, {});
    const std::vector<std::uint8_t> all(50, 1);
    test::Random random(4);
    const RayWave rays = test::scattered(200, random);
    for (const KdTree& none : {visibleTree(tree, all), buildVisibleTree(mesh, all, tree.bounds)}) {
        EXPECT_TRUE(none.nodes[0].isLeaf());
        EXPECT_EQ(none.nodes[0].count(), 0U);
        EXPECT_EQ(none.bounds, tree.bounds);
        rtcore::HitWave hits;
        KdRayTracer(none, mesh).intersect(rtcore::RayKind::Primary, rays, hits);
        for (std::size_t i = 0; i < rays.size(); ++i) EXPECT_FALSE(hits.isHit(i));
    }
}

/// Word by word.
std::vector<std::uint32_t> wordsOf(std::span<const rtcore::KdNode> nodes) {
    std::vector<std::uint32_t> words;
    for (const rtcore::KdNode node : nodes) {
        words.push_back(node.firstReference);
        words.push_back(node.bits);
    }
    return words;
}

TEST(VisibleTree, WhereNothingIsHiddenIsTheSame) {
    const test::SampleMesh sample = test::soup(300, 0.4F, 6);
    const rtcore::Mesh mesh = sample.view();
    const KdTree tree = buildKdTree(mesh, {});
    const std::vector<std::uint8_t> none(300, 0);
    const KdTree pruned = visibleTree(tree, none), anew = buildVisibleTree(mesh, none, tree.bounds);
    for (const KdTree& same : {pruned, anew})
        EXPECT_EQ(std::vector(same.references.begin(), same.references.end()),
                  std::vector(tree.references.begin(), tree.references.end()));
    EXPECT_EQ(wordsOf(anew.nodes), wordsOf(tree.nodes));
    EXPECT_EQ(pruned.nodes.size(), tree.nodes.size());
}

} // namespace
