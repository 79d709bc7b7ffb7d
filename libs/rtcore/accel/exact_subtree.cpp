#include "rtcore/accel/exact_subtree.h"

#include "rtcore/accel/builder.h"

#include <algorithm>
#include <utility>

namespace rtcore {

void BuildContext::checkCancelled() const {
    if (progress != nullptr && progress->cancel.load(std::memory_order_relaxed)) throw BuildCancelled();
}

std::unique_ptr<Subtree> ExactSubtreeBuilder::build(EventLists lists, std::uint32_t* numbers,
                                                    const Box3& cell, int depth, ReferenceBudget budget) {
    context_.checkCancelled();
    auto tree = std::make_unique<Subtree>();
    tree->nodes.emplace_back();
    tree_ = tree.get();
    const std::uint32_t count = lists.triangles;
    const NodeEvents root = load(std::move(lists), numbers);
    buildNode(0, root, count, cell, depth, 0, budget);
    tree->nodes.shrink_to_fit();
    tree->references.shrink_to_fit();
    if (context_.progress != nullptr) context_.progress->finished += count;
    return tree;
}

void ExactSubtreeBuilder::build(const BoundedTriangle* triangles, std::size_t count, const Box3& cell,
                                int depth, ReferenceBudget budget, Subtree& tree, std::uint32_t index) {
    tree_ = &tree;
    const NodeEvents root = load(triangles, count);
    buildNode(index, root, static_cast<std::uint32_t>(count), cell, depth, 0, budget);
}

/// Numbers the triangles in the order of their starts, so that neighbours have neighbouring numbers.
ExactSubtreeBuilder::NodeEvents ExactSubtreeBuilder::load(EventLists lists, std::uint32_t* numbers) {
    NodeEvents root;
    top_ = 0;
    makeRoom(lists.axis[0].size() + lists.axis[1].size() + lists.axis[2].size());
    triangles_.clear();
    triangles_.reserve(lists.triangles);
    for (std::size_t i = 0; i < lists.axis[0].size(); ++i) {
        const Event e = lists.axis[0].data()[i];
        if (eventKind(e) == EventKind::End) continue;
        numbers[eventTriangle(e)] = static_cast<std::uint32_t>(triangles_.size());
        triangles_.push_back(eventTriangle(e));
    }
    for (std::size_t a = 0; a < 3; ++a) {
        // Taken out, so that each list is freed once copied: a piece that no split divides may be large.
        const EventList events = std::move(lists.axis[a]);
        root.first[a] = top_;
        root.count[a] = events.size();
        Event* const out = at(top_);
        for (std::size_t i = 0; i < events.size(); ++i) {
            const Event e = events.data()[i];
            out[i] = (e & ~static_cast<Event>(kEventTriangleMask)) | numbers[eventTriangle(e)];
        }
        top_ += events.size();
    }
    if (sides_.size() < triangles_.size()) sides_.resize(triangles_.size());
    return root;
}

ExactSubtreeBuilder::NodeEvents ExactSubtreeBuilder::load(const BoundedTriangle* triangles,
                                                          std::size_t count) {
    NodeEvents root;
    top_ = 0;
    makeRoom(6 * count);
    triangles_.clear();
    for (std::size_t i = 0; i < count; ++i) triangles_.push_back(triangles[i].triangle());
    for (std::size_t a = 0; a < 3; ++a) {
        Event* const first = at(top_);
        Event* out = first;
        for (std::size_t i = 0; i < count; ++i) {
            out = writeEvents(triangles[i].box(), static_cast<int>(a), static_cast<std::uint32_t>(i), out);
        }
        root.first[a] = top_;
        root.count[a] = static_cast<std::size_t>(out - first);
        sortEvents(first, root.count[a], scratch_);
        top_ += root.count[a];
    }
    if (sides_.size() < count) sides_.resize(count);
    return root;
}

/// Returns the expected cost of the finished node.
float ExactSubtreeBuilder::buildNode(std::uint32_t index, const NodeEvents& events, std::uint32_t count,
                                     const Box3& cell, int depth, int failures, ReferenceBudget budget) {
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
    if (!split.valid() || failures > context_.lookAhead ||
        (split.cost >= leafCost && minCost(split, cell) >= leafCost)) {
        makeLeaf(index, events);
        return leafCost;
    }

    const Halves cells(cell, split.axis, split.position);
    NodeEvents lower;
    NodeEvents upper = events;
    const Division parts = divide(split, count, upper, lower, cells.lower, cells.upper);

    const auto children = static_cast<std::uint32_t>(tree_->nodes.size());
    tree_->nodes.resize(tree_->nodes.size() + 2);
    tree_->nodes[index] = {split.axis, split.position, children, children + 1};
    const AreaOfParts area(cell, split.axis);
    const float lowerCost = buildNode(children, lower, parts.lower, cells.lower, depth + 1, failures,
                                      budget.portion(parts.lower, parts.lower + parts.upper));
    top_ = parts.keep;
    const float upperCost = buildNode(children + 1, upper, parts.upper, cells.upper, depth + 1, failures,
                                      budget.portion(parts.upper, parts.lower + parts.upper));

    const float cost = context_.cost.traversal + area.lower(split.position) * lowerCost +
                       area.upper(split.position) * upperCost;
    if (cost < leafCost) return cost;
    undo(index, firstReference);
    return context_.cost.leaf(tree_->nodes[index].second);
}

Split ExactSubtreeBuilder::findSplit(const NodeEvents& events, std::uint32_t count, const Box3& cell) const {
    Split best;
    for (int axis = 0; axis < 3; ++axis) {
        const auto a = static_cast<std::size_t>(axis);
        const Split s = cheapestSplit(at(events.first[a]), events.count[a], count, cell, axis, context_.cost);
        if (s.cost < best.cost) best = s;
    }
    return best;
}

/// A lower bound for the cost of a split, whatever the splits below it bring: each of them costs a step.
float ExactSubtreeBuilder::minCost(const Split& split, const Box3& cell) const {
    const CostModel& cost = context_.cost;
    const AreaOfParts area(cell, split.axis);
    return cost.traversal + area.lower(split.position) * std::min(cost.leaf(split.lower), cost.traversal) +
           area.upper(split.position) * std::min(cost.leaf(split.upper), cost.traversal);
}

/// Leaves the upper side where the node's events were and puts the lower side on top of the arena.
ExactSubtreeBuilder::Division ExactSubtreeBuilder::divide(const Split& split, std::uint32_t count,
                                                          NodeEvents& upper, NodeEvents& lower,
                                                          const Box3& lowerCell, const Box3& upperCell) {
    // Only empty space is cut off: nothing changes for the triangles.
    if (split.lower == 0) return {0, count, top_};
    if (split.upper == 0) {
        std::swap(lower, upper);
        return {count, 0, top_};
    }
    const auto along = static_cast<std::size_t>(split.axis);
    straddling_.clear();
    makeRoom(3 * upper.count[along] + 1); // with what clipping may add to the lower side
    const AlongSplit parts =
        divideAlong(at(upper.first[along]), upper.count[along], split, sides_.data(), at(top_), straddling_);
    const std::uint32_t lowerCount = count - split.upper + clipStraddling(lowerCell, addedLower_);
    const std::uint32_t upperCount = count - split.lower + clipStraddling(upperCell, addedUpper_);
    std::size_t keep = top_;

    lower.first[along] = top_;
    lower.count[along] = mergeEvents(at(top_), parts.lower, addedLower_[along]);
    top_ += lower.count[along];
    upper.first[along] += parts.upperFirst;
    upper.count[along] = mergeEvents(at(upper.first[along]), parts.upper, addedUpper_[along]);

    for (const std::size_t a : {(along + 1) % 3, (along + 2) % 3}) {
        const std::size_t all = upper.count[a];
        lower.first[a] = top_;
        makeRoom(2 * all + addedLower_[a].size() + addedUpper_[a].size() + 1);
        Event* const mine = at(upper.first[a]);
        Event* const above = at(top_);
        const PartitionCounts sides = partition(mine, all, sides_.data(), above, mine);
        lower.count[a] = mergeEvents(above, sides.lower, addedLower_[a]);
        top_ += lower.count[a];
        // Nearly always the upper side fits where the node was; rounding in the clipping can make it grow.
        if (sides.upper + addedUpper_[a].size() > all) {
            std::copy(mine, mine + sides.upper, at(top_));
            upper.first[a] = top_;
            keep = top_ += sides.upper + addedUpper_[a].size();
        }
        upper.count[a] = mergeEvents(at(upper.first[a]), sides.upper, addedUpper_[a]);
    }
    return {lowerCount, upperCount, keep};
}

void ExactSubtreeBuilder::makeRoom(std::size_t events) {
    if (arena_.capacity() >= top_ + events) return;
    EventList larger(std::max(top_ + events, arena_.capacity() * 3 / 2));
    std::copy(at(0), at(top_), larger.data());
    arena_ = std::move(larger);
}

/// New events of the straddling triangles in one child's cell; returns how many are inside at all.
std::uint32_t ExactSubtreeBuilder::clipStraddling(const Box3& cell, AxisEvents& added) {
    if (straddling_.empty()) {
        for (auto& list : added) list.clear();
        return 0;
    }
    return clipEvents(
        context_, straddling_, [&](std::uint32_t number) { return triangles_[number]; }, cell, added);
}

void ExactSubtreeBuilder::makeLeaf(std::uint32_t index, const NodeEvents& events) {
    const auto first = static_cast<std::uint32_t>(tree_->references.size());
    for (std::size_t i = 0; i < events.count[0]; ++i) {
        const Event e = *at(events.first[0] + i);
        if (eventKind(e) != EventKind::End) tree_->references.push_back(triangles_[eventTriangle(e)]);
    }
    const auto count = static_cast<std::uint32_t>(tree_->references.size()) - first;
    tree_->nodes[index] = {BuildNode::kLeaf, 0, first, count};
}

/// Replaces all below a node by a leaf: its splits did not pay. Nodes and references below it are the
/// last ones.
void ExactSubtreeBuilder::undo(std::uint32_t index, std::size_t firstReference) {
    tree_->nodes.resize(tree_->nodes[index].first);
    auto& references = tree_->references;
    const auto begin = references.begin() + static_cast<std::ptrdiff_t>(firstReference);
    std::sort(begin, references.end());
    references.erase(std::unique(begin, references.end()), references.end());
    tree_->nodes[index] = {BuildNode::kLeaf, 0, static_cast<std::uint32_t>(firstReference),
                           static_cast<std::uint32_t>(references.size() - firstReference)};
}

} // namespace rtcore
