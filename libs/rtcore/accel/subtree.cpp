#include "rtcore/accel/subtree.h"

#include "rtcore/accel/task_loop.h"

#include <algorithm>
#include <stdexcept>

namespace rtcore {

namespace {

struct TreeArrays {
    std::vector<KdNode> nodes;
    std::vector<std::uint32_t> references;
};

/// A piece and where it goes. Its root is there already, beside its sibling; all other nodes follow each
/// other.
struct Placement {
    const Subtree* piece;
    std::size_t root, nodes, references;
};

/// Writes one piece in the order of a depth-first walk.
class PieceWriter {
  public:
    PieceWriter(const Placement& place, TreeArrays& out)
        : piece_(*place.piece), out_(out), node_(place.nodes), reference_(place.references) {}

    void write(std::uint32_t index, std::size_t at) {
        const BuildNode& node = piece_.nodes[index];
        if (node.axis != BuildNode::kLeaf) {
            const std::size_t children = node_;
            node_ += 2;
            out_.nodes[at] = KdNode::inner(node.axis, node.split, static_cast<std::uint32_t>(children));
            write(node.first, children);
            write(node.second, children + 1);
            return;
        }
        out_.nodes[at] = KdNode::leaf(static_cast<std::uint32_t>(reference_), node.second);
        const auto from = piece_.references.begin() + node.first;
        const auto to = out_.references.begin() + static_cast<std::ptrdiff_t>(reference_);
        const auto end = std::copy(from, from + node.second, to);
        if (!std::is_sorted(to, end)) std::sort(to, end);
        reference_ += node.second;
    }

  private:
    const Subtree& piece_;
    TreeArrays& out_;
    std::size_t node_, reference_;
};

/// Places all pieces of a tree in the order of a depth-first walk, and writes the large nodes above them.
class Layout {
  public:
    explicit Layout(TreeArrays& out) : out_(out) {}

    const std::vector<Placement>& place(const Subtree& root) {
        place(root, 0);
        return pieces_;
    }

  private:
    void place(const Subtree& tree, std::size_t at) {
        if (tree.lower == nullptr) {
            pieces_.push_back({&tree, at, node_, reference_});
            node_ += tree.nodes.size() - 1;
            reference_ += tree.references.size();
            return;
        }
        const std::size_t children = node_;
        node_ += 2;
        out_.nodes[at] = KdNode::inner(tree.axis, tree.split, static_cast<std::uint32_t>(children));
        place(*tree.lower, children);
        place(*tree.upper, children + 1);
    }

    TreeArrays& out_;
    std::vector<Placement> pieces_;
    std::size_t node_ = 1;
    std::size_t reference_ = 0;
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
    std::size_t nodes = 0;
    std::size_t references = 0;
    count(root, nodes, references);
    if (nodes > kMaxKdNodes) throw std::length_error("the kd-tree has more than 2^30 nodes");
    if (references > kMaxLeafCount) throw std::length_error("the kd-tree has more than 2^30 references");
    auto arrays = std::make_shared<TreeArrays>();
    arrays->nodes.resize(nodes);
    arrays->references.resize(references);
    const std::vector<Placement> pieces = Layout(*arrays).place(root);
    forEachInTasks(pieces.size(),
                   [&](std::size_t i) { PieceWriter(pieces[i], *arrays).write(0, pieces[i].root); });
    return {arrays->nodes, arrays->references, bounds, arrays};
}

} // namespace rtcore
