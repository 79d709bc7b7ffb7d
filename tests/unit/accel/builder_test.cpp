#include "rtcore/accel/builder.h"

#include "rtcore/accel/statistics.h"
#include "rtcore/accel/validation.h"
#include "support/sample_meshes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <ostream>
#include <set>
#include <string>

using rtcore::BuildMethod;
using rtcore::BuildOptions;
using rtcore::KdTree;
using rtcore::Mesh;

namespace {

struct MeshCase {
    std::string name;
    std::function<test::SampleMesh()> make;
};

std::ostream& operator<<(std::ostream& out, const MeshCase& c) { return out << c.name; }

test::SampleMesh none() { return {}; }
test::SampleMesh oneTriangle() { return test::soup(1, 1, 3); }
test::SampleMesh oneFlatTriangle() {
    test::SampleMesh mesh;
    mesh.addTriangle({0, 0, 0}, {1, 0, 0}, {0, 1, 0});
    return mesh;
}
test::SampleMesh oneDegenerate() {
    test::SampleMesh mesh;
    mesh.addTriangle({1, 2, 3}, {1, 2, 3}, {1, 2, 3});
    return mesh;
}
test::SampleMesh smallSoup() { return test::soup(500, 0.5F, 1); }
test::SampleMesh denseSoup() { return test::soup(6000, 0.1F, 2); }
test::SampleMesh identical() {
    test::SampleMesh mesh = test::soup(1, 1, 5);
    mesh.triangles.assign(100'000, mesh.triangles[0]);
    return mesh;
}
test::SampleMesh degenerate() {
    test::SampleMesh mesh = test::soup(1000, 0.1F, 6);
    test::Random random(7);
    for (int i = 0; i < 1000; ++i) {
        const rtcore::Vec3 a = random.vector(1);
        const rtcore::Vec3 b = a + random.vector(0.2F);
        if (i % 3 == 0) mesh.addTriangle(a, a, a);
        if (i % 3 == 1) mesh.addTriangle(a, b, a);
        if (i % 3 == 2) mesh.addTriangle(a, b, a * 0.5F + b * 0.5F);
    }
    return mesh;
}
test::SampleMesh pointsOnALine() {
    test::SampleMesh mesh;
    for (int i = 0; i < 500; ++i) {
        const rtcore::Vec3 p{static_cast<float>(i) * 0.125F, 0, 0};
        mesh.addTriangle(p, p, p);
    }
    return mesh;
}
test::SampleMesh flatSheet() { return test::sheet(40, 1, 0.3F); }
test::SampleMesh tiltedSheet() { return test::sheet(40, 1, 0).rotate(4); }
test::SampleMesh grid() { return test::boxGrid(20); }
test::SampleMesh sheetsAtOnePlace() {
    test::SampleMesh mesh = test::sheet(12, 2, 0.5F);
    mesh.append(test::sheet(12, 2, 0.5F));
    mesh.append(test::sheet(9, 0, 0.5F));
    return mesh;
}
test::SampleMesh farAway() { return test::icosphere(4).move({1e4F, -1e4F, 1e4F}); }
test::SampleMesh farAwayGrid() { return test::boxGrid(16).move({1e4F, 1e4F, 1e4F}); }
test::SampleMesh tiny() { return test::soup(2000, 0.1F, 8).scale(1e-6F); }
test::SampleMesh huge() { return test::soup(2000, 0.1F, 9).scale(1e6F); }
test::SampleMesh allSizes() {
    test::SampleMesh mesh;
    for (int exponent = -6; exponent <= 6; ++exponent) {
        const auto seed = static_cast<std::uint64_t>(exponent + 100);
        mesh.append(test::soup(100, 0.3F, seed).scale(std::pow(10.0F, static_cast<float>(exponent))));
    }
    return mesh;
}

void expectSound(const KdTree& tree, const Mesh& mesh) {
    const auto structure = validateKdTree(tree, mesh.triangles.size());
    ASSERT_FALSE(structure.has_value()) << structure->english();
    const auto coverage = validateCoverage(tree, mesh);
    EXPECT_FALSE(coverage.has_value()) << coverage->english();
    const std::set<std::uint32_t> referenced(tree.references.begin(), tree.references.end());
    EXPECT_EQ(referenced.size(), mesh.triangles.size());
    EXPECT_EQ(tree.bounds, mesh.bounds()); // the empty box when there is no triangle
}

class EveryMesh : public testing::TestWithParam<MeshCase> {};

} // namespace

TEST_P(EveryMesh, GetsASoundTreeExactly) {
    const test::SampleMesh sample = GetParam().make();
    const Mesh mesh = sample.view();
    for (const float intersectionCost : {0.0F, 2.0F}) {
        BuildOptions options;
        options.intersectionCost = intersectionCost;
        expectSound(buildKdTree(mesh, options), mesh);
    }
}

TEST_P(EveryMesh, GetsASoundTreeFast) {
    const test::SampleMesh sample = GetParam().make();
    const Mesh mesh = sample.view();
    for (const int quality : {1, 5, 10}) {
        BuildOptions options;
        options.method = BuildMethod::Fast;
        options.fastQuality = quality;
        expectSound(buildKdTree(mesh, options), mesh);
    }
}

INSTANTIATE_TEST_SUITE_P(
    Builder, EveryMesh,
    testing::Values(MeshCase{"none", none}, MeshCase{"oneTriangle", oneTriangle},
                    MeshCase{"oneFlatTriangle", oneFlatTriangle}, MeshCase{"oneDegenerate", oneDegenerate},
                    MeshCase{"smallSoup", smallSoup}, MeshCase{"denseSoup", denseSoup},
                    MeshCase{"identical", identical}, MeshCase{"degenerate", degenerate},
                    MeshCase{"pointsOnALine", pointsOnALine}, MeshCase{"flatSheet", flatSheet},
                    MeshCase{"tiltedSheet", tiltedSheet}, MeshCase{"grid", grid},
                    MeshCase{"sheetsAtOnePlace", sheetsAtOnePlace}, MeshCase{"farAway", farAway},
                    MeshCase{"farAwayGrid", farAwayGrid}, MeshCase{"tiny", tiny}, MeshCase{"huge", huge},
                    MeshCase{"allSizes", allSizes}),
    [](const auto& testCase) { return testCase.param.name; });

// Every split along the bar would cut all slivers, and would still seem to pay.
TEST(Builder, LongSliversTakeMemoryInProportionToTheirNumber) {
    test::Random random(31);
    test::SampleMesh sample;
    const auto across = [&] { return 1e-6F * random.number(0, 1); };
    for (int i = 0; i < 20'000; ++i) {
        sample.addTriangle({0, across(), across()}, {1, across(), across()}, {1, across(), across()});
    }
    for (int i = 0; i < 1000; ++i) {
        const float x = random.number(0, 1);
        sample.addTriangle({x, across(), across()}, {x + 1e-6F, across(), across()}, {x, across(), across()});
    }
    for (const BuildOptions& options :
         {BuildOptions{}, BuildOptions{.method = BuildMethod::Fast},
          BuildOptions{.method = BuildMethod::Fast, .fastQuality = rtcore::kQuickQuality}}) {
        const KdTree tree = buildKdTree(sample.view(), options);
        EXPECT_FALSE(validateKdTree(tree, sample.triangles.size()));
        EXPECT_GT(tree.references.size(), 2 * sample.triangles.size());
        EXPECT_LE(tree.references.size(), 2 * (16 * sample.triangles.size() + 4096));
    }
}

TEST(Builder, TheEmptyTreeIsOneEmptyLeafWithoutBounds) {
    const KdTree tree = buildKdTree(Mesh{}, {});
    ASSERT_EQ(tree.nodes.size(), 1U);
    EXPECT_TRUE(tree.nodes[0].isLeaf());
    EXPECT_EQ(tree.nodes[0].count(), 0U);
    EXPECT_TRUE(tree.references.empty());
    EXPECT_TRUE(tree.bounds.empty());
}

TEST(Builder, SeparatesTwoClustersByEmptySpace) {
    test::SampleMesh sample = test::soup(50, 0.1F, 10);
    sample.append(test::soup(50, 0.1F, 11).move({100, 0, 0}));
    const KdTree tree = buildKdTree(sample.view(), {});
    ASSERT_FALSE(tree.nodes[0].isLeaf());
    EXPECT_EQ(tree.nodes[0].axis(), 0);
    EXPECT_GT(tree.nodes[0].split, 0.5F);
    EXPECT_LT(tree.nodes[0].split, 99.5F);
}

TEST(Builder, ATreeIsCheaperThanALeafAndTheFastOneNotMuchDearer) {
    const test::SampleMesh sample = test::icosphere(5).rotate(12);
    const Mesh mesh = sample.view();
    const float cost = rtcore::automaticIntersectionCost(mesh.triangles.size());
    const auto expectedCost = [&](BuildMethod method) {
        BuildOptions options;
        options.method = method;
        return computeStatistics(buildKdTree(mesh, options), 1, cost).expectedCost;
    };
    const double exact = expectedCost(BuildMethod::Exact);
    EXPECT_LT(exact, 0.01 * cost * static_cast<double>(mesh.triangles.size()));
    EXPECT_LT(expectedCost(BuildMethod::Fast), 1.2 * exact);
}

TEST(Builder, IntersectionCostFollowsTheSize) {
    using rtcore::automaticIntersectionCost;
    EXPECT_EQ(automaticIntersectionCost(99'999), 0.3F);
    EXPECT_EQ(automaticIntersectionCost(100'000), 0.2F);
    EXPECT_EQ(automaticIntersectionCost(500'000), 0.15F);
    EXPECT_EQ(automaticIntersectionCost(4'000'000), 0.12F);
}

TEST(Builder, TheArraysOutliveTheMesh) {
    KdTree tree;
    {
        const test::SampleMesh sample = smallSoup();
        tree = buildKdTree(sample.view(), {});
    }
    EXPECT_FALSE(validateKdTree(tree, 500).has_value());
}
