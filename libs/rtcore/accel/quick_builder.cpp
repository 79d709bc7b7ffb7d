#include "rtcore/accel/quick_builder.h"

#include "rtcore/accel/float4.h"
#include "rtcore/accel/pool.h"
#include "rtcore/accel/quick_subtree.h"
#include "rtcore/accel/task_loop.h"
#include "rtcore/accel/uninitialized_array.h"

#include <algorithm>
#include <span>
#include <utility>
#include <vector>

namespace rtcore {

namespace {

/// A piece that one thread builds has about so many triangles, and a sample so many times fewer: an odd
/// number, since the triangles of grids lie in rows of even ones.
constexpr std::size_t kPiece = 8192;
constexpr std::size_t kSampled = 61;

/// The tree of a sample: where its leaves are, and which of them a box reaches into.
class SampleTree {
  public:
    struct Leaf {
        Box3 cell;
        int depth;
    };

    SampleTree(const Subtree& tree, const Box3& cell, int depth) : nodes_(tree.nodes) {
        addLeaves(0, cell, {set4(-Box3::kHuge), set4(Box3::kHuge)}, depth);
    }

    const std::vector<Leaf>& leaves() const { return leaves_; }

    /// Calls `use` with the number of each leaf. `last` was one of the box before, where this one is likely
    /// to be, too.
    template <typename Use>
    void forEachLeaf(const Bounds4& box, std::size_t& last, const Use& use) const {
        if (isInside(box, insides_[last])) {
            use(last);
        } else {
            descend(0, box, [&](std::size_t leaf) { use(last = leaf); });
        }
    }

    /// The pieces of the leaves below the nodes that they have here.
    std::unique_ptr<Subtree> joined(std::span<std::unique_ptr<Subtree>> pieces) const {
        return join(0, pieces);
    }

  private:
    void addLeaves(std::uint32_t index, const Box3& cell, const Bounds4& inside, int depth) {
        BuildNode& node = nodes_[index];
        if (node.axis == BuildNode::kLeaf) {
            node.first = static_cast<std::uint32_t>(leaves_.size());
            leaves_.push_back({cell, depth});
            insides_.push_back(inside);
            return;
        }
        const Halves cells(cell, node.axis, node.split);
        Bounds4 lowerInside = inside;
        Bounds4 upperInside = inside;
        lowerInside.hi[node.axis] = upperInside.lo[node.axis] = node.split;
        addLeaves(node.first, cells.lower, lowerInside, depth + 1);
        addLeaves(node.second, cells.upper, upperInside, depth + 1);
    }

    static bool isInside(const Bounds4& box, const Bounds4& leaf) {
        const Int4 inside = (box.lo > leaf.lo) & (box.hi < leaf.hi);
        return (inside[0] & inside[1] & inside[2]) != 0;
    }

    template <typename Use>
    void descend(std::uint32_t index, const Bounds4& box, const Use& use) const {
        while (nodes_[index].axis != BuildNode::kLeaf) {
            const BuildNode& node = nodes_[index];
            const float first = box.lo[node.axis];
            const float last = box.hi[node.axis];
            const bool upper = last > node.split;
            const bool lower = first < node.split || !upper; // where those in the plane go, too
            if (lower && upper) descend(node.first, box, use);
            index = upper ? node.second : node.first;
        }
        use(nodes_[index].first);
    }

    std::unique_ptr<Subtree> join(std::uint32_t index, std::span<std::unique_ptr<Subtree>> pieces) const {
        const BuildNode& node = nodes_[index];
        if (node.axis == BuildNode::kLeaf) return std::move(pieces[node.first]);
        auto tree = std::make_unique<Subtree>();
        tree->axis = node.axis;
        tree->split = node.split;
        tree->lower = join(node.first, pieces);
        tree->upper = join(node.second, pieces);
        return tree;
    }

    std::vector<BuildNode> nodes_; ///< of a leaf, `first` is its number
    std::vector<Leaf> leaves_;
    std::vector<Bounds4> insides_; ///< their cells, endless where those of the tree end
};

/// Which triangles each leaf of a sample's tree has.
class Handout {
  public:
    Handout(const Mesh& mesh, const TriangleList& triangles, const SampleTree& tree)
        : mesh_(mesh), triangles_(triangles), tree_(tree), leaves_(tree.leaves().size()),
          places_(kParts * leaves_), begins_(leaves_ + 1) {
        forEachReached([](std::size_t& place, std::size_t) { ++place; });
        std::size_t next = 0;
        for (std::size_t leaf = 0; leaf < leaves_; ++leaf) {
            begins_[leaf] = next;
            for (std::size_t part = 0; part < kParts; ++part)
                next += std::exchange(places_[part * leaves_ + leaf], next);
        }
        begins_[leaves_] = next;
    }

    /// The sum over all leaves; more than there are triangles, since some reach into several.
    std::size_t size() const { return begins_.back(); }

    void place() {
        placed_ = UninitializedArray<std::uint32_t>(size());
        forEachReached(
            [this](std::size_t& place, std::size_t i) { placed_.data()[place++] = triangles_[i]; });
    }
    /// In the order of the list, once they are placed.
    TriangleList of(std::size_t leaf) const {
        return {placed_.data() + begins_[leaf], begins_[leaf + 1] - begins_[leaf]};
    }

  private:
    static constexpr std::size_t kParts = 32; ///< of the triangles; each has its own places

    /// Calls `use` with the place of its part in a leaf and each triangle that reaches into it.
    template <typename Use>
    void forEachReached(const Use& use) {
        forEachInTasks(kParts, [&](std::size_t part) {
            std::size_t* const places = places_.data() + part * leaves_;
            const std::size_t end = triangles_.count * (part + 1) / kParts;
            std::size_t last = 0;
            for (std::size_t i = triangles_.count * part / kParts; i < end; ++i) {
                tree_.forEachLeaf(boundsOf(mesh_, triangles_[i]), last,
                                  [&](std::size_t leaf) { use(places[leaf], i); });
            }
        });
    }

    const Mesh& mesh_;
    const TriangleList& triangles_;
    const SampleTree& tree_;
    std::size_t leaves_;
    std::vector<std::size_t> places_; ///< by part and leaf: numbers of triangles, then where the next comes
    std::vector<std::size_t> begins_; ///< by leaf
    UninitializedArray<std::uint32_t> placed_;
};

class QuickBuilder {
  public:
    explicit QuickBuilder(const BuildContext& context) : context_(context) {}

    std::unique_ptr<Subtree> build(const TriangleList& triangles, const Box3& cell, int depth,
                                   ReferenceBudget budget) {
        context_.checkCancelled();
        if (triangles.count > 2 * kPiece) {
            const SampleTree top = topOf(triangles, cell, depth, budget);
            if (top.leaves().size() > 1) {
                Handout handout(context_.mesh, triangles, top);
                // Else they are so long that only a careful division keeps to the budget.
                if (budget.allows(handout.size())) return buildBelow(top, handout, budget);
            }
        }
        auto piece = borrow()->build(triangles, cell, {}, depth, budget);
        if (context_.progress != nullptr) context_.progress->finished += triangles.count;
        return piece;
    }

  private:
    SampleTree topOf(const TriangleList& triangles, const Box3& cell, int depth, ReferenceBudget budget) {
        std::vector<std::uint32_t> sample;
        sample.reserve(triangles.count / kSampled + 1);
        for (std::size_t i = 0; i < triangles.count; i += kSampled) sample.push_back(triangles[i]);
        budget.references /= kSampled;
        const QuickSubtreeBuilder::Rules rules{static_cast<float>(kSampled), kPiece / kSampled};
        const auto tree = borrow()->build({sample.data(), sample.size()}, cell, rules, depth, budget);
        return {*tree, cell, depth};
    }

    std::unique_ptr<Subtree> buildBelow(const SampleTree& top, Handout& handout, ReferenceBudget budget) {
        handout.place();
        std::vector<std::unique_ptr<Subtree>> pieces(top.leaves().size());
        forEachInTasks(pieces.size(), [&](std::size_t i) {
            const SampleTree::Leaf& leaf = top.leaves()[i];
            const TriangleList own = handout.of(i);
            pieces[i] = build(own, leaf.cell, leaf.depth, budget.portion(own.count, handout.size()));
        });
        return top.joined(pieces);
    }

    Pool<QuickSubtreeBuilder>::Loan borrow() {
        return builders_.borrow([&] { return std::make_unique<QuickSubtreeBuilder>(context_); });
    }

    const BuildContext& context_;
    Pool<QuickSubtreeBuilder> builders_;
};

} // namespace

std::unique_ptr<Subtree> buildQuick(const BuildContext& context, const Box3& cell) {
    const TriangleList all{nullptr, context.mesh.triangles.size()};
    return QuickBuilder(context).build(all, cell, 0, ReferenceBudget::ofScene(all.count));
}

} // namespace rtcore
