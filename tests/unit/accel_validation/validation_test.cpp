#include "rtcore/accel/validation.h"

#include "support/sample_model.h"
#include "support/sample_tree.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <utility>

using rtcore::KdNode;
using rtcore::validateCoverage;
using rtcore::validateKdTree;

namespace {

constexpr std::size_t kTriangles = 200;

std::string textOf(const std::optional<rtcore::Sentence>& finding) {
    return finding ? finding->english() : "";
}

class ValidateKdTree : public testing::Test {
  protected:
    /// The complaint of validateKdTree about the tree as it has been changed; "" when it is content.
    std::string verdict() const { return textOf(validateKdTree(tree.view(), kTriangles)); }
    std::string coverage() const { return textOf(validateCoverage(tree.view(), model.mesh)); }

    KdNode& firstInner() {
        return *std::find_if(tree.nodes.begin() + 1, tree.nodes.end(), [](KdNode n) { return !n.isLeaf(); });
    }
    KdNode& firstLeafWith(std::uint32_t references) {
        return *std::find_if(tree.nodes.begin(), tree.nodes.end(),
                             [=](KdNode n) { return n.isLeaf() && n.count() >= references; });
    }

    rtcore::Model model = rtcore::makeModel(test::SampleModel(1).make(kTriangles));
    test::SampleTree tree = test::sampleTree(model.mesh);
};

void expectFault(const std::string& verdict, const std::string& words) {
    EXPECT_NE(verdict.find(words), std::string::npos) << "said: '" << verdict << "'";
}

/// A tree that splits its upper (or lower) child again and again at the plane x = 0.
test::SampleTree chain(int depth, bool upper) {
    test::SampleTree tree;
    tree.bounds = {{0, 0, 0}, {1, 1, 1}};
    tree.nodes.resize(1 + 2 * static_cast<std::size_t>(depth), KdNode::leaf(0, 0));
    std::uint32_t node = 0;
    for (int i = 0; i < depth; ++i) {
        const auto pair = static_cast<std::uint32_t>(1 + 2 * i);
        tree.nodes[node] = KdNode::inner(0, upper ? 0.0F : 1.0F, pair);
        node = upper ? pair + 1 : pair;
    }
    return tree;
}

} // namespace

TEST_F(ValidateKdTree, SoundTreeHasNoFault) {
    ASSERT_GT(tree.nodes.size(), 50U);
    EXPECT_EQ(verdict(), "");
    EXPECT_EQ(coverage(), "");
}

TEST_F(ValidateKdTree, EmptyTreeIsALeafWithoutReferencesInAnyBox) {
    test::SampleTree empty;
    empty.nodes = {KdNode::leaf(0, 0)};
    EXPECT_FALSE(validateKdTree(empty.view(), 0));
    empty.bounds = {{0, 0, 0}, {1, 1, 1}};
    EXPECT_FALSE(validateKdTree(empty.view(), 0));
    EXPECT_FALSE(validateCoverage(empty.view(), {}));
    empty.bounds = {{1, 0, 0}, {0, 1, 1}};
    EXPECT_TRUE(validateKdTree(empty.view(), 0));
    empty.bounds = {};
    empty.nodes.clear();
    expectFault(textOf(validateKdTree(empty.view(), 0)), "no nodes");
}

TEST_F(ValidateKdTree, BoundsMustBeABox) {
    for (const float bad :
         {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity(), -5.0F}) {
        const float kept = std::exchange(tree.bounds.hi.y, bad);
        expectFault(verdict(), "bounds");
        tree.bounds.hi.y = kept;
    }
    tree.bounds = {};
    expectFault(verdict(), "bounds");
}

TEST_F(ValidateKdTree, ChildrenMustComeInOrder) {
    KdNode& node = firstInner();
    const KdNode sound = node;
    for (const std::uint32_t child :
         {0U, 1U, sound.lowerChild() + 2, sound.lowerChild() - 1,
          static_cast<std::uint32_t>(tree.nodes.size()), rtcore::kMaxKdNodes - 1}) {
        node = KdNode::inner(sound.axis(), sound.split, child);
        expectFault(verdict(), "children out of order");
    }
    node = sound;
    tree.nodes.pop_back();
    expectFault(verdict(), "behind the last node");
}

TEST_F(ValidateKdTree, EveryNodeAndReferenceMustBeUsed) {
    tree.nodes.push_back(KdNode::leaf(static_cast<std::uint32_t>(tree.references.size()), 0));
    expectFault(verdict(), "part of no tree");
    tree.nodes.pop_back();
    tree.references.push_back(3);
    expectFault(verdict(), "part of no leaf");
}

TEST_F(ValidateKdTree, SplitsMustLieInTheirCells) {
    KdNode& node = firstInner();
    const float sound = node.split;
    for (const float bad :
         {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity(), -9.0F, 9.0F}) {
        node.split = bad;
        expectFault(verdict(), "outside of its cell");
    }
    node.split = sound;
    EXPECT_EQ(verdict(), "");
    // Inside the scene, outside of the cell: the lower child of the root, split beyond the root's plane.
    test::SampleTree nested = chain(2, false);
    nested.nodes[0].split = 0.5F;
    nested.nodes[1].split = 0.75F;
    expectFault(textOf(validateKdTree(nested.view(), 0)), "node 1 splits outside of its cell");
    nested.nodes[1].split = 0.5F;
    EXPECT_FALSE(validateKdTree(nested.view(), 0)) << "the border belongs to the cell";
}

TEST_F(ValidateKdTree, ReferencesMustBeInOrderAscendingAndExist) {
    KdNode& leaf = firstLeafWith(2);
    const std::uint32_t first = leaf.firstReference;
    std::swap(tree.references[first], tree.references[first + 1]);
    expectFault(verdict(), "do not ascend");
    tree.references[first] = tree.references[first + 1];
    expectFault(verdict(), "do not ascend");

    tree = test::sampleTree(model.mesh);
    tree.references[first + firstLeafWith(2).count() - 1] = kTriangles;
    expectFault(verdict(), "does not exist");

    tree = test::sampleTree(model.mesh);
    KdNode& other = firstLeafWith(1);
    other.firstReference += 1;
    expectFault(verdict(), "references out of order");
    other.firstReference -= 1;
    other.bits += 4; // one reference more, which is the next leaf's
    EXPECT_NE(verdict(), "");
    other.bits |= 0xFFFFFFFCU;
    expectFault(verdict(), "behind the last one");
    EXPECT_TRUE(validateKdTree(test::sampleTree(model.mesh).view(), kTriangles / 2));
}

TEST_F(ValidateKdTree, DepthIsLimited) {
    for (const bool upper : {false, true}) {
        EXPECT_FALSE(validateKdTree(chain(rtcore::kMaxKdDepth, upper).view(), 0));
        expectFault(textOf(validateKdTree(chain(rtcore::kMaxKdDepth + 1, upper).view(), 0)), "too deep");
        EXPECT_TRUE(validateKdTree(chain(10000, upper).view(), 0));
    }
}

TEST_F(ValidateKdTree, CoverageFindsWhatALeafLacks) {
    // Take each reference out of its leaf in turn: most of them reach in by more than the tolerance.
    int found = 0, tried = 0;
    const test::SampleTree sound = tree;
    for (std::size_t n = 0; n < sound.nodes.size(); ++n) {
        if (!sound.nodes[n].isLeaf() || sound.nodes[n].count() == 0) continue;
        tree = sound;
        tree.references.erase(tree.references.begin() + sound.nodes[n].firstReference);
        tree.nodes[n].bits -= 4;
        for (std::size_t k = n + 1; k < tree.nodes.size(); ++k) {
            if (tree.nodes[k].isLeaf() && tree.nodes[k].firstReference > sound.nodes[n].firstReference) {
                tree.nodes[k].firstReference -= 1;
            }
        }
        for (std::size_t k = 0; k < n; ++k) {
            if (tree.nodes[k].isLeaf() && tree.nodes[k].firstReference > sound.nodes[n].firstReference) {
                tree.nodes[k].firstReference -= 1;
            }
        }
        ASSERT_EQ(verdict(), "");
        ++tried;
        found += coverage().empty() ? 0 : 1;
    }
    ASSERT_GT(tried, 50);
    EXPECT_GT(found * 10, tried * 6) << found << " of " << tried;
}

TEST_F(ValidateKdTree, CoverageFindsWhatALeafHoldsTooMuch) {
    KdNode& leaf = firstLeafWith(1);
    std::uint32_t& reference = tree.references[leaf.firstReference + leaf.count() - 1];
    int found = 0, tried = 0;
    const std::uint32_t sound = reference;
    for (std::uint32_t other = sound + 1; other < kTriangles; ++other) {
        reference = other;
        ASSERT_EQ(verdict(), "");
        ++tried;
        found += coverage().empty() ? 0 : 1;
    }
    ASSERT_GT(tried, 10);
    EXPECT_EQ(found, tried);
}

TEST(ValidateCoverage, FlatScenesAndDegenerateTrianglesAreCovered) {
    rtcore::ModelBuffers buffers;
    for (int i = 0; i < 20; ++i) {
        const auto x = static_cast<float>(i);
        const auto first = static_cast<std::uint32_t>(buffers.vertices.size());
        buffers.vertices.insert(buffers.vertices.end(), {{x, 0, 3, 0}, {x + 1, 0, 3, 0}, {x, 1, 3, 0}});
        buffers.triangles.push_back({{first, first + 1, first + 2}});
        buffers.triangles.push_back({{first, first, first}});
    }
    const rtcore::Model model = rtcore::makeModel(std::move(buffers));
    test::SampleTree tree = test::sampleTree(model.mesh);
    ASSERT_FALSE(validateKdTree(tree.view(), model.mesh.triangles.size()));
    EXPECT_EQ(textOf(validateCoverage(tree.view(), model.mesh)), "");
    // A lone leaf that has lost its last triangle.
    tree = test::sampleTree(model.mesh, 1000);
    tree.references.pop_back();
    tree.nodes[0] = KdNode::leaf(0, static_cast<std::uint32_t>(tree.references.size()));
    EXPECT_NE(textOf(validateCoverage(tree.view(), model.mesh)), "");
}
