#include "rtcore/accel/fast_builder.h"

#include "rtcore/accel/exact_builder.h"
#include "rtcore/platform/task_errors.h"

#include <algorithm>
#include <utility>

namespace rtcore {

namespace {

constexpr int kMaxBins = 64;

/// A triangle and the box of its part inside the node.
struct Item {
    Box3 box;
    std::uint32_t triangle;
};

/// Which bin a coordinate falls into, clamped to those there are.
struct Binning {
    Binning(const Box3& cell, int axis, int bins)
        : lo(cell.lo[axis]), scale(static_cast<float>(bins) / (cell.hi[axis] - cell.lo[axis])), last(bins - 1) {}
    int bin(float x) const { return std::clamp(static_cast<int>((x - lo) * scale), 0, last); }
    float lo, scale;
    int last;
};

Split cheapestBinnedSplit(const std::vector<Item>& items, const Box3& cell, int axis, int bins,
                          const CostModel& cost) {
    Split best;
    const float extent = cell.hi[axis] - cell.lo[axis];
    const Binning binning(cell, axis, bins);
    if (!(extent > 0) || !(binning.scale < Box3::kHuge)) return best;
    std::array<std::uint32_t, kMaxBins> starts{};
    std::array<std::uint32_t, kMaxBins> ends{};
    for (const Item& item : items) {
        ++starts[static_cast<std::size_t>(binning.bin(item.box.lo[axis]))];
        ++ends[static_cast<std::size_t>(binning.bin(item.box.hi[axis]))];
    }
    const AreaOfParts area(cell, axis);
    std::uint32_t lower = 0;
    auto upper = static_cast<std::uint32_t>(items.size());
    for (int i = 1; i < bins; ++i) {
        lower += starts[static_cast<std::size_t>(i - 1)];
        upper -= ends[static_cast<std::size_t>(i - 1)];
        const float position = cell.lo[axis] + extent * (static_cast<float>(i) / static_cast<float>(bins));
        if (!(position > cell.lo[axis] && position < cell.hi[axis])) continue;
        const float c = cost.split(area.lower(position), area.upper(position), lower, upper);
        if (c < best.cost) best = {c, position, axis, true};
    }
    return best;
}

class FastBuilder {
  public:
    FastBuilder(const BuildContext& context, const FastOptions& options) : context_(context), options_(options) {}

    void buildNode(std::vector<Item> items, const Box3& cell, int depth, std::unique_ptr<Subtree>& out) {
        if (items.size() < options_.exactBelow) {
            out = buildExactSubtree(context_, makeLists(items), cell, depth);
            return;
        }
        if (items.size() > kSerialTriangles) context_.checkCancelled();
        const float leafCost = context_.cost.leaf(static_cast<std::uint32_t>(items.size()));
        Split split;
        for (int axis = 0; depth < context_.maxDepth && axis < 3; ++axis) {
            const Split s = cheapestBinnedSplit(items, cell, axis, options_.bins, context_.cost);
            if (s.cost < split.cost) split = s;
        }
        std::vector<Item> lower;
        std::vector<Item> upper;
        if (split.cost < leafCost) divide(items, split, lower, upper);
        if (!(split.cost < leafCost) || (lower.size() == items.size() && upper.size() == items.size())) {
            // Bins are blind to details: the exact sweep may still find a way, and makes the leaf if not.
            out = buildExactSubtree(context_, makeLists(items), cell, depth);
            return;
        }
        const bool large = items.size() > kSerialTriangles;
        std::vector<Item>().swap(items);
        Box3 lowerCell = cell;
        Box3 upperCell = cell;
        lowerCell.hi[split.axis] = upperCell.lo[split.axis] = split.position;
        out = std::make_unique<Subtree>();
        out->axis = split.axis;
        out->split = split.position;
        Subtree* const node = out.get();
        const auto moved = std::make_shared<std::vector<Item>>(std::move(upper));
#pragma omp task default(shared) firstprivate(moved, upperCell, depth, node) if (large)
        errors_.guard([&] { buildNode(std::move(*moved), upperCell, depth + 1, node->upper); });
        errors_.guard([&] { buildNode(std::move(lower), lowerCell, depth + 1, node->lower); });
#pragma omp taskwait
    }

    void rethrow() const { errors_.rethrow(); }

  private:
    void divide(const std::vector<Item>& items, const Split& split, std::vector<Item>& lower,
                std::vector<Item>& upper) const {
        const int axis = split.axis;
        lower.reserve(items.size());
        upper.reserve(items.size());
        for (const Item& item : items) {
            if (item.box.hi[axis] <= split.position) {
                lower.push_back(item);
            } else if (item.box.lo[axis] >= split.position) {
                upper.push_back(item);
            } else {
                lower.push_back(item);
                lower.back().box.hi[axis] = split.position;
                upper.push_back(item);
                upper.back().box.lo[axis] = split.position;
            }
        }
    }

    static EventLists makeLists(const std::vector<Item>& items) {
        EventLists lists;
        lists.triangles.reserve(items.size());
        for (const Item& item : items) lists.triangles.push_back(item.triangle);
        for (int axis = 0; axis < 3; ++axis) {
            auto& events = lists.axis[static_cast<std::size_t>(axis)];
            events.resize(2 * items.size());
            Event* out = events.data();
            for (std::size_t i = 0; i < items.size(); ++i) {
                out = writeEvents(items[i].box, axis, static_cast<std::uint32_t>(i), out);
            }
            events.resize(static_cast<std::size_t>(out - events.data()));
            std::vector<Event> scratch;
            sortEvents(events, scratch);
        }
        return lists;
    }

    const BuildContext& context_;
    const FastOptions& options_;
    TaskErrors errors_;
};

} // namespace

FastOptions fastOptions(int quality) {
    const int q = std::clamp(quality, 1, 10);
    return {4 + 4 * q, std::size_t{4} << q};
}

std::unique_ptr<Subtree> buildFast(const BuildContext& context, const FastOptions& options, const Box3& cell) {
    std::vector<Item> items(context.mesh.triangles.size());
    for (std::uint32_t i = 0; i < items.size(); ++i) {
        items[i].triangle = i;
        for (int corner = 0; corner < 3; ++corner) items[i].box.extend(context.mesh.position(i, corner));
    }
    FastBuilder builder(context, options);
    std::unique_ptr<Subtree> root;
    builder.buildNode(std::move(items), cell, 0, root);
    builder.rethrow();
    return root;
}

} // namespace rtcore
