#include "rtcore/accel/visible_tree.h"

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace rtcore {

namespace {

struct PrunedArrays {
    std::vector<KdNode> nodes;
    std::vector<std::uint32_t> references;
};

std::span<const std::uint32_t> referencesOf(const KdTree& tree, KdNode leaf) {
    return tree.references.subspan(leaf.firstReference, leaf.count());
}

/// By node: whether nothing below it is seen. Children lie behind their parents.
std::vector<bool> emptyNodes(const KdTree& tree, std::span<const std::uint8_t> hidden) {
    std::vector<bool> empty(tree.nodes.size());
    for (std::size_t i = tree.nodes.size(); i-- > 0;) {
        const KdNode node = tree.nodes[i];
        if (node.isLeaf()) {
            const auto triangles = referencesOf(tree, node);
            empty[i] = std::all_of(triangles.begin(), triangles.end(),
                                   [&](std::uint32_t triangle) { return hidden[triangle] != 0; });
        } else {
            empty[i] = empty[node.lowerChild()] && empty[node.lowerChild() + 1];
        }
    }
    return empty;
}

void addLeaf(const KdTree& tree, KdNode leaf, std::span<const std::uint8_t> hidden, KdNode& to,
             PrunedArrays& out) {
    const auto first = static_cast<std::uint32_t>(out.references.size());
    for (const std::uint32_t triangle : referencesOf(tree, leaf)) {
        if (hidden[triangle] == 0) out.references.push_back(triangle);
    }
    to = KdNode::leaf(first, static_cast<std::uint32_t>(out.references.size()) - first);
}

} // namespace

KdTree visibleTree(const KdTree& tree, std::span<const std::uint8_t> hidden) {
    const std::vector<bool> empty = emptyNodes(tree, hidden);
    auto out = std::make_shared<PrunedArrays>();
    out->nodes.resize(1);
    std::vector<std::pair<std::uint32_t, std::uint32_t>> open{{0, 0}}; // from, to
    while (!open.empty()) {
        const auto [from, to] = open.back();
        open.pop_back();
        const KdNode node = tree.nodes[from];
        if (empty[from]) {
            out->nodes[to] = KdNode::leaf(static_cast<std::uint32_t>(out->references.size()), 0);
        } else if (node.isLeaf()) {
            addLeaf(tree, node, hidden, out->nodes[to], *out);
        } else {
            const auto lower = static_cast<std::uint32_t>(out->nodes.size());
            out->nodes.resize(out->nodes.size() + 2);
            out->nodes[to] = KdNode::inner(node.axis(), node.split, lower);
            open.emplace_back(node.lowerChild() + 1, lower + 1);
            open.emplace_back(node.lowerChild(), lower);
        }
    }
    return {out->nodes, out->references, tree.bounds, out};
}

} // namespace rtcore
