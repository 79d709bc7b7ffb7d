#include "rtcore/accel/visible_tree.h"

#include "rtcore/accel/builder.h"
#include "rtcore/accel/uninitialized_array.h"

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace rtcore {

namespace {

struct PrunedArrays {
    UninitializedArray<KdNode> nodes;
    UninitializedArray<std::uint32_t> references;
};

/// The leaf with its visible triangles first. `to` gets all of them: behind a leaf, vectors read on.
KdNode visibleLeaf(const KdTree& tree, KdNode leaf, std::span<const std::uint8_t> hidden, std::uint32_t* to) {
    const std::uint32_t* const from = tree.references.data() + leaf.firstReference;
    std::copy_n(from, leaf.count(), to);
    std::uint32_t* const end = std::stable_partition(
        to, to + leaf.count(), [&](std::uint32_t triangle) { return hidden[triangle] == 0; });
    return KdNode::leaf(leaf.firstReference, static_cast<std::uint32_t>(end - to));
}

bool isEmpty(KdNode node) { return node.isLeaf() && node.count() == 0; }

} // namespace

KdTree visibleTree(const KdTree& tree, std::span<const std::uint8_t> hidden) {
    const std::size_t count = tree.nodes.size();
    auto out = std::make_shared<PrunedArrays>(PrunedArrays{
        UninitializedArray<KdNode>(count), UninitializedArray<std::uint32_t>(tree.references.size())});
    KdNode* const nodes = out->nodes.data();
    std::uint32_t* const references = out->references.data();
#pragma omp parallel for schedule(static)
    for (std::size_t i = 0; i < count; ++i) {
        const KdNode node = tree.nodes[i];
        const bool triangles = node.isLeaf() && node.count() > 0;
        nodes[i] = triangles ? visibleLeaf(tree, node, hidden, references + node.firstReference) : node;
    }
    for (std::size_t i = count; i-- > 0;) { // children lie behind their parents
        const KdNode node = nodes[i];
        if (node.isLeaf() || !isEmpty(nodes[node.lowerChild()]) || !isEmpty(nodes[node.lowerChild() + 1]))
            continue;
        nodes[i] = KdNode::leaf(0, 0);
    }
    return {{nodes, count}, {references, tree.references.size()}, tree.bounds, out};
}

KdTree buildVisibleTree(const Mesh& mesh, std::span<const std::uint8_t> hidden, const Box3& bounds,
                        BuildOptions options, BuildProgress* progress) {
    std::vector<Triangle> triangles;
    std::vector<std::uint32_t> numbers; ///< of these, in the whole mesh: ascending, as references are
    for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) {
        if (hidden[i] != 0) continue;
        triangles.push_back(mesh.triangles[i]);
        numbers.push_back(i);
    }
    Mesh visible = mesh;
    visible.triangles = triangles;
    options.bounds = bounds;
    const KdTree tree = buildKdTree(visible, options, nullptr, progress);
    struct Renumbered {
        std::shared_ptr<const void> nodes;
        std::vector<std::uint32_t> references;
    };
    auto out = std::make_shared<Renumbered>(Renumbered{tree.storage, {}});
    out->references.reserve(tree.references.size());
    for (const std::uint32_t reference : tree.references) out->references.push_back(numbers[reference]);
    return {tree.nodes, out->references, bounds, out};
}

} // namespace rtcore
