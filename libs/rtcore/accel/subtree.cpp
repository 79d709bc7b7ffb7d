#include "rtcore/accel/subtree.h"

#include <algorithm>
#include <stdexcept>

namespace rtcore {

namespace {

struct TreeArrays {
    std::vector<KdNode> nodes;
    std::vector<std::uint32_t> references;
};

class Stitcher {
  public:
    explicit Stitcher(TreeArrays& out) : out_(out) {}

    void layOut(const Subtree& tree, std::size_t at) {
        if (tree.lower == nullptr) {
            layOutSmall(tree, 0, at);
            return;
        }
        const std::size_t children = addPair();
        out_.nodes[at] = KdNode::inner(tree.axis, tree.split, static_cast<std::uint32_t>(children));
        layOut(*tree.lower, children);
        layOut(*tree.upper, children + 1);
    }

  private:
    std::size_t addPair() {
        const std::size_t first = out_.nodes.size();
        if (first + 2 > kMaxKdNodes) throw std::length_error("the kd-tree has more than 2^30 nodes");
        out_.nodes.resize(first + 2);
        return first;
    }

    void layOutSmall(const Subtree& tree, std::uint32_t index, std::size_t at) {
        const BuildNode& node = tree.nodes[index];
        if (node.axis != BuildNode::kLeaf) {
            const std::size_t children = addPair();
            out_.nodes[at] = KdNode::inner(node.axis, node.split, static_cast<std::uint32_t>(children));
            layOutSmall(tree, node.first, children);
            layOutSmall(tree, node.second, children + 1);
            return;
        }
        const std::size_t first = out_.references.size();
        if (first + node.second > kMaxLeafCount)
            throw std::length_error("the kd-tree has more than 2^30 references");
        out_.nodes[at] = KdNode::leaf(static_cast<std::uint32_t>(first), node.second);
        const auto begin = tree.references.begin() + node.first;
        out_.references.insert(out_.references.end(), begin, begin + node.second);
        std::sort(out_.references.begin() + static_cast<std::ptrdiff_t>(first), out_.references.end());
    }

    TreeArrays& out_;
};

void count(const Subtree& tree, std::size_t& nodes, std::size_t& references) {
    if (tree.lower != nullptr) {
        nodes += 1;
        count(*tree.lower, nodes, references);
        count(*tree.upper, nodes, references);
    } else {
        nodes += tree.nodes.size();
        references += tree.references.size();
    }
}

} // namespace

KdTree stitch(const Subtree& root, const Box3& bounds) {
    auto arrays = std::make_shared<TreeArrays>();
    std::size_t nodes = 0;
    std::size_t references = 0;
    count(root, nodes, references);
    arrays->nodes.reserve(nodes);
    arrays->references.reserve(references);
    arrays->nodes.resize(1);
    Stitcher(*arrays).layOut(root, 0);
    return {arrays->nodes, arrays->references, bounds, arrays};
}

} // namespace rtcore
