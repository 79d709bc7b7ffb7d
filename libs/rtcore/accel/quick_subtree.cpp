#include "rtcore/accel/quick_subtree.h"

#include "rtcore/accel/float4.h"

#include <algorithm>
#include <utility>

namespace rtcore {

namespace {

/// Larger nodes are split by what a sample says.
constexpr std::size_t kSampledAbove = 1024;
constexpr std::size_t kCounted = 8;

/// They divide the boxes' bounds evenly.
Planes planesIn(const Box3& bounds) {
    Planes planes;
    for (int a = 0; a < 3; ++a) {
        const float extent = bounds.hi[a] - bounds.lo[a];
        for (std::size_t k = 0; k < kPlanes; ++k) {
            constexpr float kStep = 1.0F / (kPlanes + 1);
            planes[static_cast<std::size_t>(a)][k] =
                bounds.lo[a] + extent * (static_cast<float>(k + 1) * kStep);
        }
    }
    return planes;
}

} // namespace

std::unique_ptr<Subtree> QuickSubtreeBuilder::build(const TriangleList& triangles, const Box3& cell,
                                                    const Rules& rules, int depth, ReferenceBudget budget) {
    tree_ = std::make_unique<Subtree>();
    cost_ = context_.cost;
    cost_.intersection *= rules.weight;
    leafBelow_ = std::max<std::size_t>(rules.leafBelow, 1);
    load(triangles, cell);
    tree_->nodes.emplace_back();
    buildNode(0, 0, triangles.count, triangles.count + BoxLists::kPadding, cell, depth, budget);
    return std::move(tree_);
}

/// The parts of their boxes inside of the cell.
void QuickSubtreeBuilder::load(const TriangleList& triangles, const Box3& cell) {
    makeRoom(0, triangles.count);
    const BoxLists boxes = at(0);
    const Float4 cellLo{cell.lo.x, cell.lo.y, cell.lo.z, 0};
    const Float4 cellHi{cell.hi.x, cell.hi.y, cell.hi.z, 0};
    for (std::size_t i = 0; i < triangles.count; ++i) {
        const Bounds4 box = boundsOf(context_.mesh, triangles[i]);
        const Float4 lo = max4(box.lo, cellLo);
        const Float4 hi = min4(box.hi, cellHi);
        for (std::size_t a = 0; a < 3; ++a) {
            boxes.lo[a][i] = lo[a];
            boxes.hi[a][i] = hi[a];
        }
        boxes.triangle[i] = triangles[i];
    }
    endLists(boxes, triangles.count);
}

/// The node's boxes are [first, first + count); all from `top` on is free.
void QuickSubtreeBuilder::buildNode(std::uint32_t index, std::size_t first, std::size_t count,
                                    std::size_t top, const Box3& cell, int depth, ReferenceBudget budget) {
    Split split;
    if (depth < context_.maxDepth && count >= leafBelow_ && budget.allows(count))
        split = findSplit(at(first), count, cell);
    if (!(split.cost < cost_.leaf(static_cast<std::uint32_t>(count)))) {
        makeLeaf(index, first, count);
        return;
    }
    makeRoom(top, count);
    const SideCounts n = divideBoxes(at(first), count, split, at(top));
    const Halves cells(cell, split.axis, split.position);
    const auto children = static_cast<std::uint32_t>(tree_->nodes.size());
    tree_->nodes.resize(tree_->nodes.size() + 2);
    tree_->nodes[index] = {split.axis, split.position, children, children + 1};
    buildNode(children, top, n.lower, top + n.lower + BoxLists::kPadding, cells.lower, depth + 1,
              budget.portion(n.lower, n.lower + n.upper));
    buildNode(children + 1, first, n.upper, top, cells.upper, depth + 1,
              budget.portion(n.upper, n.lower + n.upper));
}

/// The cheapest of planes that divide the boxes' bounds evenly, and of the bounds themselves: these cut off
/// empty space.
Split QuickSubtreeBuilder::findSplit(const BoxLists& boxes, std::size_t count, const Box3& cell) const {
    const Box3 bounds = boundsOf(boxes, count);
    const Planes planes = planesIn(bounds);
    const PlaneCounts counts = countAtPlanes(boxes, count, count > kSampledAbove ? kCounted : 1, planes);
    const auto all = static_cast<std::uint32_t>(count);
    CostModel cost = cost_;
    Split best;
    for (int axis = 0; axis < 3; ++axis) {
        const auto a = static_cast<std::size_t>(axis);
        const AreaOfParts area(cell, axis);
        const auto consider = [&](float position, std::uint32_t lower, std::uint32_t upper) {
            const float c = cost.split(area.lower(position), area.upper(position), lower, upper);
            if (!(c < best.cost && position > area.lo && position < area.hi)) return;
            best.cost = c;
            best.position = position;
            best.axis = axis;
            best.planarLower = position != bounds.lo[axis];
        };
        cost.intersection = cost_.intersection;
        consider(bounds.lo[axis], 0, all);
        consider(bounds.hi[axis], all, 0);
        cost.intersection *= static_cast<float>(count) / static_cast<float>(counts.boxes);
        for (std::size_t k = 0; k < kPlanes; ++k)
            consider(planes[a][k], counts.lower[a][k], counts.upper[a][k]);
    }
    return best;
}

void QuickSubtreeBuilder::makeLeaf(std::uint32_t index, std::size_t first, std::size_t count) {
    auto& references = tree_->references;
    tree_->nodes[index] = {BuildNode::kLeaf, 0, static_cast<std::uint32_t>(references.size()),
                           static_cast<std::uint32_t>(count)};
    const std::uint32_t* const from = triangles_.data() + first;
    references.insert(references.end(), from, from + count);
}

/// For `count` boxes from `top` on, and their end.
void QuickSubtreeBuilder::makeRoom(std::size_t top, std::size_t count) {
    const std::size_t min = top + count + BoxLists::kPadding;
    if (triangles_.capacity() >= min) return;
    const std::size_t capacity = std::max(min, triangles_.capacity() * 3 / 2);
    const auto grow = [&](auto& list) {
        std::remove_reference_t<decltype(list)> larger(capacity);
        std::copy(list.data(), list.data() + top, larger.data());
        list = std::move(larger);
    };
    for (auto& list : numbers_) grow(list);
    grow(triangles_);
}

BoxLists QuickSubtreeBuilder::at(std::size_t first) {
    const auto axis = [&](std::size_t a) { return numbers_[a].data(); };
    return BoxLists{{axis(0), axis(1), axis(2)}, {axis(3), axis(4), axis(5)}, triangles_.data()}.from(first);
}

} // namespace rtcore
