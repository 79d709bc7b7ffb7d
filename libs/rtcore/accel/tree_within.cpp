#include "rtcore/accel/tree_within.h"

#include "rtcore/accel/triangles_within.h"
#include "rtcore/accel/uninitialized_array.h"
#include "rtcore/accel/visible_tree.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace rtcore {

namespace {

/// By how much a cell has to lie beyond a plane, so that rounding lets no ray enter it.
float marginOf(const Box3& bounds) {
    constexpr float kRounding = 4e-6F; // of the largest coordinate
    float largest = 0;
    for (const Vec3 corner : {bounds.lo, bounds.hi})
        for (int a = 0; a < 3; ++a) largest = std::max(largest, std::fabs(corner[a]));
    return kRounding * largest;
}

class Cutter {
  public:
    Cutter(const KdTree& tree, std::span<const HalfSpace> halves, KdNode* nodes)
        : tree_(tree), halves_(halves), margin_(marginOf(tree.bounds)), nodes_(nodes) {}

    void run() {
        if (isBeyond(tree_.bounds)) {
            nodes_[0] = KdNode::leaf(0, 0);
        } else {
            place(0, 0, tree_.bounds);
        }
    }

  private:
    /// Puts what is left of the node `from`, whose cell lies beyond no plane, in the place of `to`.
    void place(std::uint32_t from, std::uint32_t to, const Box3& cell) {
        const KdNode node = tree_.nodes[from];
        nodes_[to] = node;
        if (node.isLeaf() || isWithin(cell)) return;
        const Halves halves(cell, node.axis(), node.split);
        const std::uint32_t lower = node.lowerChild(), upper = lower + 1;
        if (isBeyond(halves.upper)) return place(lower, to, halves.lower);
        if (isBeyond(halves.lower)) return place(upper, to, halves.upper);
        place(lower, lower, halves.lower);
        place(upper, upper, halves.upper);
    }

    bool isBeyond(const Box3& cell) const {
        return std::ranges::any_of(halves_, [&](const HalfSpace& half) {
            return dot(half.normal, farthestCorner(cell, -half.normal)) > half.offset + margin_;
        });
    }
    bool isWithin(const Box3& cell) const {
        return std::ranges::all_of(halves_, [&](const HalfSpace& half) {
            return dot(half.normal, farthestCorner(cell, half.normal)) <= half.offset;
        });
    }

    const KdTree& tree_;
    std::span<const HalfSpace> halves_;
    float margin_;
    KdNode* nodes_;
};

struct Storage {
    UninitializedArray<KdNode> nodes;
    std::shared_ptr<const void> rest;
};

} // namespace

KdTree treeWithin(const KdTree& tree, std::span<const HalfSpace> halves) {
    const std::size_t count = tree.nodes.size();
    auto storage = std::make_shared<Storage>(Storage{UninitializedArray<KdNode>(count), tree.storage});
    KdNode* const nodes = storage->nodes.data();
    std::copy_n(tree.nodes.data(), count, nodes);
    Cutter(tree, halves, nodes).run();
    return {{nodes, count}, tree.references, tree.bounds, storage};
}

KdTree buildTreeWithin(const Mesh& mesh, std::span<const std::uint8_t> hidden,
                       std::span<const HalfSpace> halves, const Box3& bounds, const BuildOptions& options,
                       BuildProgress* progress) {
    std::vector<std::uint8_t> gone = trianglesBeyond(mesh, halves, marginOf(bounds));
    for (std::size_t i = 0; i < hidden.size(); ++i) gone[i] |= hidden[i];
    return buildVisibleTree(mesh, gone, bounds, options, progress);
}

} // namespace rtcore
