// By the tree of what planes leave, rays find what clipped rays find by the whole one: the same bits, by
// every kernel on every instruction set.
#include "rtcore/accel/tree_within.h"

#include "kinds_of_waves.h"
#include "wave_support.h"

#include "rtcore/kernels/clip_rays.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <set>
#include <string>
#include <vector>

namespace {

using rtcore::HalfSpace;
using rtcore::KdNode;
using rtcore::KdRayTracer;
using rtcore::KdTree;
using rtcore::RayWave;

RayWave clippedWave(const std::vector<HalfSpace>& halves, RayWave wave) {
    for (std::size_t i = 0; i < wave.size(); ++i) {
        for (const HalfSpace& half : halves) {
            const rtcore::Ray ray = wave.ray(i);
            rtcore::clipInterval(dot(half.normal, ray.direction), half.offset - dot(half.normal, ray.origin),
                                 wave.tMin[i], wave.tMax[i]);
        }
    }
    return wave;
}

/// Level ones and others, which leave some of the soup.
std::vector<std::vector<HalfSpace>> sections(test::Random& random) {
    std::vector<std::vector<HalfSpace>> all{{{{0, 1, 0}, 0.1F}}, {{{-1, 0, 0}, 0.4F}, {{0, 0, 1}, 0}}};
    for (int i = 0; i < 3; ++i)
        all.push_back({{random.unitVector(), random.number(-0.2F, 0.5F)}, {random.unitVector(), 0.4F}});
    return all;
}

/// How many nodes a walk from the root meets.
std::size_t reachable(const KdTree& tree, std::uint32_t node = 0) {
    const KdNode at = tree.nodes[node];
    if (at.isLeaf()) return 1;
    return 1 + reachable(tree, at.lowerChild()) + reachable(tree, at.lowerChild() + 1);
}

struct CutSoup {
    test::SampleMesh sample = test::soup(700, 0.4F, 5);
    rtcore::Mesh mesh = sample.view();
    KdTree tree = buildKdTree(mesh, {});
    test::Random random{12};
};

TEST(TreeWithin, IsHitAsTheWholeByClippedRays) {
    CutSoup soup;
    const test::InstructionSetGuard guard;
    std::size_t hits = 0, misses = 0;
    for (const rtcore::LeafRecords records : {rtcore::LeafRecords::Inline, rtcore::LeafRecords::Shared}) {
        const KdRayTracer whole(soup.tree, soup.mesh, records);
        for (const std::vector<HalfSpace>& halves : sections(soup.random)) {
            const auto left = whole.within(halves);
            EXPECT_EQ(left->bounds(), whole.bounds()) << "what depends on the scene's size stays";
            for (const RayWave& wave : {test::scattered(900, soup.random), test::camera(12, soup.random),
                                        test::image(32, soup.random)}) {
                const RayWave clipped = clippedWave(halves, wave);
                for (const std::string& set : rtcore::instructionSets()) {
                    ASSERT_TRUE(rtcore::useInstructionSet(set));
                    const test::WaveAnswer expected = test::byWave(whole, clipped);
                    hits += expected.hitCount();
                    misses += wave.size() - expected.hitCount();
                    EXPECT_EQ(test::difference(test::byWave(*left, wave), expected, wave), "") << set;
                }
            }
        }
    }
    EXPECT_GT(hits, 1000U);
    EXPECT_GT(misses, 1000U);
}

/// Also rays from so far away that rounding moves their ends.
TEST(TreeWithin, IsHitWithTheSameBitsWhenItIsBuiltOfWhatIsLeft) {
    CutSoup soup;
    const test::InstructionSetGuard guard;
    const KdRayTracer whole(soup.tree, soup.mesh);
    const std::vector<std::uint8_t> none(soup.mesh.triangles.size());
    std::vector<std::uint8_t> hidden = none;
    for (std::size_t i = 0; i < hidden.size(); i += 3) hidden[i] = 1;
    std::size_t hits = 0;
    for (const std::vector<HalfSpace>& halves : sections(soup.random)) {
        for (const std::vector<std::uint8_t>& without : {none, hidden}) {
            const KdTree tree = buildTreeWithin(soup.mesh, without, halves, soup.tree.bounds);
            EXPECT_EQ(tree.bounds, soup.tree.bounds);
            EXPECT_LT(tree.references.size(), soup.tree.references.size());
            const auto left = KdRayTracer(tree, soup.mesh).within(halves);
            const auto reduced = whole.without(without)->within(halves);
            RayWave far = test::camera(40, soup.random);
            for (std::size_t i = 0; i < far.size(); ++i) {
                far.ox[i] += 300 * far.dx[i];
                far.oy[i] += 300 * far.dy[i];
                far.oz[i] += 300 * far.dz[i];
                far.dx[i] = -far.dx[i];
                far.dy[i] = -far.dy[i];
                far.dz[i] = -far.dz[i];
                far.tMin[i] = 0;
                far.tMax[i] = 1e6F;
            }
            for (const RayWave& wave :
                 {test::scattered(900, soup.random), test::image(32, soup.random), far}) {
                for (const std::string& set : rtcore::instructionSets()) {
                    ASSERT_TRUE(rtcore::useInstructionSet(set));
                    const test::WaveAnswer expected = test::byWave(*reduced, wave);
                    hits += expected.hitCount();
                    EXPECT_EQ(test::difference(test::byWave(*left, wave), expected, wave), "") << set;
                }
            }
        }
    }
    EXPECT_GT(hits, 1000U);
}

/// Of triangles that each plane leaves a part of, but not all planes together.
TEST(TreeWithin, IsBuiltOfTrianglesThatArePartlyWithinAllPlanes) {
    test::SampleMesh sample;
    const auto corner = [&](float x, float y) { sample.vertices.push_back({x, y, 0}); };
    const auto triangle = [&](float x, float y) {
        const auto first = static_cast<std::uint32_t>(sample.vertices.size());
        corner(x - 1, y);
        corner(x + 1, y);
        corner(x, y + 1);
        sample.triangles.push_back({{first, first + 1, first + 2}});
    };
    triangle(0, -0.5F); // within
    triangle(0, 3);     // beyond one
    const auto last = static_cast<std::uint32_t>(sample.vertices.size());
    corner(-3, 2);
    corner(2, -3);
    corner(2, 2);
    sample.triangles.push_back({{last, last + 1, last + 2}});
    const std::vector<HalfSpace> halves{{{1, 0, 0}, -0.6F}, {{0, 1, 0}, -0.6F}}, right{{{1, 0, 0}, -0.6F}};
    const auto counted = [&](const std::vector<HalfSpace>& planes) {
        const rtcore::Mesh mesh = sample.view();
        const KdTree tree = buildTreeWithin(mesh, {}, planes, mesh.bounds());
        return std::set<std::uint32_t>(tree.references.begin(), tree.references.end());
    };
    EXPECT_EQ(counted(right), (std::set<std::uint32_t>{0, 1, 2}));
    EXPECT_EQ(counted({{{0, 1, 0}, -0.4F}}), (std::set<std::uint32_t>{0, 2}));
    EXPECT_EQ(counted(halves), std::set<std::uint32_t>{}) << "each plane leaves a part of the last one";
}

TEST(TreeWithin, OfATracerOfAPartIsWithinBoth) {
    CutSoup soup;
    const KdRayTracer whole(soup.tree, soup.mesh);
    const std::vector<HalfSpace> first{{{0, 1, 0}, 0.1F}}, second{{{1, 0, 0}, 0}}, both{first[0], second[0]};
    const RayWave wave = test::scattered(900, soup.random);
    const test::WaveAnswer expected = test::byWave(*whole.within(both), wave);
    const auto part = whole.within(first);
    EXPECT_EQ(test::difference(test::byWave(*part->within(second), wave), expected, wave), "");
    const std::vector<std::uint8_t> none(soup.mesh.triangles.size());
    EXPECT_EQ(test::difference(test::byWave(*whole.within(both)->without(none), wave), expected, wave), "");
}

TEST(TreeWithin, HasFewerNodes) {
    CutSoup soup;
    const std::vector<HalfSpace> half{{{0, 1, 0}, 0}}, all{{{0, 1, 0}, 100}}, nothing{{{0, 1, 0}, -100}};
    const std::size_t count = reachable(soup.tree);
    EXPECT_LT(reachable(treeWithin(soup.tree, half)), count * 3 / 4);
    EXPECT_EQ(reachable(treeWithin(soup.tree, all)), count);
    const KdTree none = treeWithin(soup.tree, nothing);
    EXPECT_TRUE(none.nodes[0].isLeaf());
    EXPECT_EQ(none.nodes[0].count(), 0U);
}

} // namespace
