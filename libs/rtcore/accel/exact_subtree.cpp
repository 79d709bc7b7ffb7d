#include "rtcore/accel/exact_subtree.h"

#include "rtcore/accel/builder.h"
#include "rtcore/accel/triangle_clip.h"

#include <algorithm>
#include <utility>

namespace rtcore {

void BuildContext::checkCancelled() const {
    if (progress != nullptr && progress->cancel.load(std::memory_order_relaxed)) throw BuildCancelled();
}

namespace {

/// The three event lists of a node inside the arena.
struct NodeEvents {
    std::array<std::size_t, 3> first{};
    std::array<std::size_t, 3> count{};
};

/// Triangles on each side of a split, and the part of the arena that holds the upper side's events.
struct Division {
    std::uint32_t lower, upper;
    std::size_t keep;
};

class SubtreeBuilder {
  public:
    SubtreeBuilder(const BuildContext& context, EventLists lists)
        : context_(context), triangles_(std::move(lists.triangles)), sides_(triangles_.size()),
          tree_(std::make_unique<Subtree>()) {
        for (std::size_t a = 0; a < 3; ++a) {
            // Taken out, so that each list is freed once copied: a piece that no split divides may be large.
            const std::vector<Event> events = std::move(lists.axis[a]);
            root_.first[a] = arena_.size();
            root_.count[a] = events.size();
            arena_.insert(arena_.end(), events.begin(), events.end());
        }
        top_ = arena_.size();
    }

    std::unique_ptr<Subtree> build(const Box3& cell, int depth, ReferenceBudget budget) {
        tree_->nodes.emplace_back();
        buildNode(0, root_, static_cast<std::uint32_t>(triangles_.size()), cell, depth, 0, budget);
        tree_->nodes.shrink_to_fit();
        tree_->references.shrink_to_fit();
        return std::move(tree_);
    }

  private:
    /// Returns the expected cost of the finished node.
    float buildNode(std::uint32_t index, const NodeEvents& events, std::uint32_t count, const Box3& cell,
                    int depth, int failures, ReferenceBudget budget) {
        const float leafCost = context_.cost.leaf(count);
        const std::size_t firstReference = tree_->references.size();
        Split split;
        // One triangle pays for a split only when much of the cell around it is empty; the cost says so
        // itself.
        if (depth < context_.maxDepth && budget.allows(count) &&
            leafCost > context_.cost.traversal * context_.cost.emptyFactor) {
            split = findSplit(events, count, cell);
        }
        if (split.cost >= leafCost) ++failures;
        if (!split.valid() || failures > context_.lookAhead) {
            makeLeaf(index, events);
            return leafCost;
        }

        Box3 lowerCell = cell;
        Box3 upperCell = cell;
        lowerCell.hi[split.axis] = upperCell.lo[split.axis] = split.position;
        NodeEvents lower;
        NodeEvents upper = events;
        const Division parts = divide(split, upper, lower, lowerCell, upperCell);

        const auto children = static_cast<std::uint32_t>(tree_->nodes.size());
        tree_->nodes.resize(tree_->nodes.size() + 2);
        tree_->nodes[index] = {split.axis, split.position, children, children + 1};
        const AreaOfParts area(cell, split.axis);
        const float lowerCost = buildNode(children, lower, parts.lower, lowerCell, depth + 1, failures,
                                          budget.share(parts.lower, parts.lower + parts.upper));
        top_ = parts.keep;
        const float upperCost = buildNode(children + 1, upper, parts.upper, upperCell, depth + 1, failures,
                                          budget.share(parts.upper, parts.lower + parts.upper));

        const float cost = context_.cost.traversal + area.lower(split.position) * lowerCost +
                           area.upper(split.position) * upperCost;
        if (cost < leafCost) return cost;
        undo(index, firstReference);
        return context_.cost.leaf(tree_->nodes[index].second);
    }

    Split findSplit(const NodeEvents& events, std::uint32_t count, const Box3& cell) const {
        Split best;
        for (int axis = 0; axis < 3; ++axis) {
            const auto a = static_cast<std::size_t>(axis);
            const Split s =
                cheapestSplit(&arena_[events.first[a]], events.count[a], count, cell, axis, context_.cost);
            if (s.cost < best.cost) best = s;
        }
        return best;
    }

    /// Leaves the upper side where the node's events were and puts the lower side on top of the arena.
    Division divide(const Split& split, NodeEvents& upper, NodeEvents& lower, const Box3& lowerCell,
                    const Box3& upperCell) {
        const auto s = static_cast<std::size_t>(split.axis);
        straddling_.clear();
        classify(&arena_[upper.first[s]], upper.count[s], split, sides_.data(), straddling_);
        std::uint32_t lowerCount = 0;
        std::uint32_t upperCount = 0;
        for (std::size_t i = 0; i < upper.count[s]; ++i) {
            const Event e = arena_[upper.first[s] + i];
            if (eventKind(e) == EventKind::End) continue;
            const Side side = sides_[eventTriangle(e)];
            lowerCount += side == Side::Lower ? 1 : 0;
            upperCount += side == Side::Upper ? 1 : 0;
        }
        lowerCount += clipStraddling(lowerCell, addedLower_);
        upperCount += clipStraddling(upperCell, addedUpper_);
        std::size_t keep = top_;
        for (std::size_t a = 0; a < 3; ++a) {
            const std::size_t count = upper.count[a];
            lower.first[a] = top_;
            makeRoom(2 * count + addedLower_[a].size() + addedUpper_[a].size() + 1);
            Event* const mine = &arena_[upper.first[a]];
            Event* const above = &arena_[top_];
            const PartitionCounts sides = partition(mine, count, sides_.data(), above, mine);
            lower.count[a] = mergeEvents(above, sides.lower, addedLower_[a]);
            top_ += lower.count[a];
            // Nearly always the upper side fits where the node was; rounding in the clipping can make it
            // grow.
            if (sides.upper + addedUpper_[a].size() > count) {
                std::copy(mine, mine + sides.upper, &arena_[top_]);
                upper.first[a] = top_;
                keep = top_ += sides.upper + addedUpper_[a].size();
            }
            upper.count[a] = mergeEvents(&arena_[upper.first[a]], sides.upper, addedUpper_[a]);
        }
        return {lowerCount, upperCount, keep};
    }

    void makeRoom(std::size_t events) {
        if (arena_.size() < top_ + events) arena_.resize(std::max(top_ + events, arena_.size() * 3 / 2));
    }

    /// New events of the straddling triangles in one child's cell; returns how many are inside at all.
    std::uint32_t clipStraddling(const Box3& cell, AxisEvents& added) {
        for (auto& list : added) list.clear();
        std::uint32_t inside = 0;
        for (const std::uint32_t local : straddling_) {
            inside += addClippedEvents(context_, triangles_[local], local, cell, added) ? 1 : 0;
        }
        for (auto& list : added) std::sort(list.begin(), list.end());
        return inside;
    }

    void makeLeaf(std::uint32_t index, const NodeEvents& events) {
        const auto first = static_cast<std::uint32_t>(tree_->references.size());
        for (std::size_t i = 0; i < events.count[0]; ++i) {
            const Event e = arena_[events.first[0] + i];
            if (eventKind(e) != EventKind::End) tree_->references.push_back(triangles_[eventTriangle(e)]);
        }
        const auto count = static_cast<std::uint32_t>(tree_->references.size()) - first;
        tree_->nodes[index] = {BuildNode::kLeaf, 0, first, count};
    }

    /// Replaces all below a node by a leaf: its splits did not pay. Nodes and references below it are the
    /// last ones.
    void undo(std::uint32_t index, std::size_t firstReference) {
        tree_->nodes.resize(tree_->nodes[index].first);
        auto& references = tree_->references;
        const auto begin = references.begin() + static_cast<std::ptrdiff_t>(firstReference);
        std::sort(begin, references.end());
        references.erase(std::unique(begin, references.end()), references.end());
        tree_->nodes[index] = {BuildNode::kLeaf, 0, static_cast<std::uint32_t>(firstReference),
                               static_cast<std::uint32_t>(references.size() - firstReference)};
    }

    const BuildContext& context_;
    std::vector<std::uint32_t> triangles_;
    std::vector<Side> sides_;
    std::unique_ptr<Subtree> tree_;

    std::vector<Event> arena_; ///< event lists of the nodes that wait, as a stack
    std::size_t top_ = 0;
    NodeEvents root_;
    std::vector<std::uint32_t> straddling_;
    AxisEvents addedLower_, addedUpper_;
};

} // namespace

bool addClippedEvents(const BuildContext& context, std::uint32_t triangle, std::uint32_t number,
                      const Box3& cell, AxisEvents& events) {
    const std::array<Vec3, 3> corners{context.mesh.position(triangle, 0), context.mesh.position(triangle, 1),
                                      context.mesh.position(triangle, 2)};
    const Box3 box = clippedBounds(corners, cell, context.margin);
    if (box.empty()) return false;
    for (int axis = 0; axis < 3; ++axis) {
        std::array<Event, 2> pair{};
        Event* const end = writeEvents(box, axis, number, pair.data());
        auto& list = events[static_cast<std::size_t>(axis)];
        list.insert(list.end(), pair.data(), end);
    }
    return true;
}

std::unique_ptr<Subtree> buildExactSubtree(const BuildContext& context, EventLists lists, const Box3& cell,
                                           int depth, ReferenceBudget budget) {
    context.checkCancelled();
    const std::size_t triangles = lists.triangles.size();
    auto tree = SubtreeBuilder(context, std::move(lists)).build(cell, depth, budget);
    if (context.progress != nullptr) context.progress->finished += triangles;
    return tree;
}

} // namespace rtcore
