#include "rtcore/accel/exact_builder.h"

#include "rtcore/platform/task_errors.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace rtcore {

namespace {

/// The two halves of a large node, each with events of its own.
struct Halves {
    EventLists lower, upper;
};

/// Clips the straddling triangles to one side: their new events, with the parent's numbers, and for each
/// triangle of the parent whether this side has it.
void clipTo(const BuildContext& context, const EventLists& lists,
            const std::vector<std::uint32_t>& straddling, const Box3& cell, AxisEvents& events,
            std::vector<std::uint8_t>& kept) {
    for (const std::uint32_t local : straddling) {
        kept[local] = addClippedEvents(context, lists.triangles[local], local, cell, events) ? 1 : 0;
    }
    for (auto& list : events) std::sort(list.begin(), list.end());
}

/// New consecutive numbers for the triangles of one side, in the old order.
struct Numbering {
    std::vector<std::uint32_t> newNumber;

    Numbering(const std::vector<std::uint8_t>& kept, const std::vector<std::uint32_t>& oldTriangles,
              std::vector<std::uint32_t>& triangles)
        : newNumber(kept.size()) {
        for (std::size_t i = 0; i < kept.size(); ++i) {
            newNumber[i] = static_cast<std::uint32_t>(triangles.size());
            if (kept[i] != 0) triangles.push_back(oldTriangles[i]);
        }
    }
    void apply(std::vector<Event>& events) const {
        for (Event& e : events)
            e = (e & ~static_cast<Event>(kEventTriangleMask)) | newNumber[eventTriangle(e)];
    }
};

Halves divide(const BuildContext& context, EventLists& lists, const Split& split, const Box3& lowerCell,
              const Box3& upperCell) {
    const std::size_t count = lists.triangles.size();
    std::vector<Side> sides(count);
    std::vector<std::uint32_t> straddling;
    const auto& along = lists.axis[static_cast<std::size_t>(split.axis)];
    classify(along.data(), along.size(), split, sides.data(), straddling);

    std::vector<std::uint8_t> inLower(count);
    std::vector<std::uint8_t> inUpper(count);
    for (std::size_t i = 0; i < count; ++i) {
        inLower[i] = sides[i] == Side::Lower ? 1 : 0;
        inUpper[i] = sides[i] == Side::Upper ? 1 : 0;
    }
    AxisEvents addedLower;
    AxisEvents addedUpper;
    clipTo(context, lists, straddling, lowerCell, addedLower, inLower);
    clipTo(context, lists, straddling, upperCell, addedUpper, inUpper);

    Halves halves;
    const Numbering lowerNumbers(inLower, lists.triangles, halves.lower.triangles);
    const Numbering upperNumbers(inUpper, lists.triangles, halves.upper.triangles);
    TaskErrors errors;
#pragma omp taskloop grainsize(1) default(shared)
    for (std::size_t a = 0; a < 3; ++a) {
        errors.guard([&] {
            std::vector<Event> events = std::move(lists.axis[a]);
            std::vector<Event>& lower = halves.lower.axis[a];
            std::vector<Event>& upper = halves.upper.axis[a];
            lower.resize(events.size() + 1 + addedLower[a].size());
            upper.resize(events.size() + 1 + addedUpper[a].size());
            const PartitionCounts sizes =
                partition(events.data(), events.size(), sides.data(), lower.data(), upper.data());
            lower.resize(mergeEvents(lower.data(), sizes.lower, addedLower[a]));
            upper.resize(mergeEvents(upper.data(), sizes.upper, addedUpper[a]));
            lower.shrink_to_fit();
            upper.shrink_to_fit();
            lowerNumbers.apply(lower);
            upperNumbers.apply(upper);
        });
    }
    errors.rethrow();
    return halves;
}

Split findSplit(const BuildContext& context, const EventLists& lists, const Box3& cell) {
    std::array<Split, 3> splits;
#pragma omp taskloop grainsize(1) default(shared)
    for (int axis = 0; axis < 3; ++axis) {
        const auto a = static_cast<std::size_t>(axis);
        splits[a] =
            cheapestSplit(lists.axis[a].data(), lists.axis[a].size(),
                          static_cast<std::uint32_t>(lists.triangles.size()), cell, axis, context.cost);
    }
    Split best;
    for (const Split& s : splits) {
        if (s.cost < best.cost) best = s;
    }
    return best;
}

void buildNode(const BuildContext& context, TaskErrors& errors, EventLists lists, const Box3& cell, int depth,
               ReferenceBudget budget, std::unique_ptr<Subtree>& out) {
    if (errors.any()) return;
    if (lists.triangles.size() <= kSerialTriangles || depth >= context.maxDepth ||
        !budget.allows(lists.triangles.size())) {
        out = buildExactSubtree(context, std::move(lists), cell, depth, budget);
        return;
    }
    context.checkCancelled();
    const Split split = findSplit(context, lists, cell);
    if (!split.valid() ||
        split.cost >= context.cost.leaf(static_cast<std::uint32_t>(lists.triangles.size()))) {
        out = buildExactSubtree(context, std::move(lists), cell, depth, budget);
        return;
    }
    Box3 lowerCell = cell;
    Box3 upperCell = cell;
    lowerCell.hi[split.axis] = upperCell.lo[split.axis] = split.position;
    Halves halves = divide(context, lists, split, lowerCell, upperCell);
    const std::size_t all = halves.lower.triangles.size() + halves.upper.triangles.size();
    const ReferenceBudget lowerBudget = budget.share(halves.lower.triangles.size(), all);
    const ReferenceBudget upperBudget = budget.share(halves.upper.triangles.size(), all);
    out = std::make_unique<Subtree>();
    out->axis = split.axis;
    out->split = split.position;
    Subtree* const node = out.get();
    const auto upper = std::make_shared<EventLists>(std::move(halves.upper));
#pragma omp task default(shared) firstprivate(upper, upperCell, upperBudget, depth, node)
    errors.guard([&] {
        buildNode(context, errors, std::move(*upper), upperCell, depth + 1, upperBudget, node->upper);
    });
    errors.guard([&] {
        buildNode(context, errors, std::move(halves.lower), lowerCell, depth + 1, lowerBudget, node->lower);
    });
#pragma omp taskwait
}

} // namespace

EventLists makeEvents(const Mesh& mesh) {
    const auto count = static_cast<std::uint32_t>(mesh.triangles.size());
    EventLists lists;
    lists.triangles.resize(count);
    std::iota(lists.triangles.begin(), lists.triangles.end(), 0U);
    TaskErrors errors;
#pragma omp taskloop grainsize(1) default(shared)
    for (int axis = 0; axis < 3; ++axis) {
        errors.guard([&] {
            auto& events = lists.axis[static_cast<std::size_t>(axis)];
            events.resize(2 * std::size_t{count});
            Event* out = events.data();
            for (std::uint32_t i = 0; i < count; ++i) {
                Box3 box;
                for (int corner = 0; corner < 3; ++corner) box.extend(mesh.position(i, corner));
                out = writeEvents(box, axis, i, out);
            }
            events.resize(static_cast<std::size_t>(out - events.data()));
            std::vector<Event> scratch;
            sortEvents(events, scratch);
        });
    }
    errors.rethrow();
    return lists;
}

std::unique_ptr<Subtree> buildExact(const BuildContext& context, EventLists lists, const Box3& cell) {
    TaskErrors errors;
    std::unique_ptr<Subtree> root;
    const auto budget = ReferenceBudget::ofScene(lists.triangles.size());
    errors.guard([&] { buildNode(context, errors, std::move(lists), cell, 0, budget, root); });
    errors.rethrow();
    return root;
}

} // namespace rtcore
