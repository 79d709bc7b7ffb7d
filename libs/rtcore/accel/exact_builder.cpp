#include "rtcore/accel/exact_builder.h"

#include "rtcore/accel/pool.h"
#include "rtcore/platform/task_errors.h"

#include <algorithm>
#include <memory>
#include <utility>

namespace rtcore {

namespace {

/// A thread's scratch memory for dividing a node: room for an entry per triangle of the mesh.
struct Scratch {
    explicit Scratch(std::size_t triangles)
        : sides(std::make_unique_for_overwrite<Side[]>(triangles)),
          numbers(std::make_unique_for_overwrite<std::uint32_t[]>(triangles)) {}

    std::unique_ptr<Side[]> sides;
    std::unique_ptr<std::uint32_t[]> numbers;
};

/// The events of the straddling triangles on one side of a split, and how many triangles are there in fact.
struct Clipped {
    AxisEvents events;
    std::uint32_t inside = 0;
};

Clipped clipTo(const BuildContext& context, const std::vector<std::uint32_t>& straddling, const Box3& cell) {
    Clipped clipped;
    clipped.inside = clipEvents(
        context, straddling, [](std::uint32_t triangle) { return triangle; }, cell, clipped.events);
    return clipped;
}

/// Splits one axis' events: the lower side gets a list of its own, the upper side keeps the node's if it can.
void divideAxis(EventList& events, const Side* sides, const std::vector<Event>& addedLower,
                const std::vector<Event>& addedUpper, EventList& lower, EventList& upper) {
    const PartitionCounts counts =
        partition(events.data(), events.size(), sides, lower.data(), events.data());
    lower.setSize(mergeEvents(lower.data(), counts.lower, addedLower));
    upper = std::move(events);
    if (counts.upper + addedUpper.size() > upper.capacity()) {
        EventList larger(counts.upper + addedUpper.size());
        std::copy(upper.data(), upper.data() + counts.upper, larger.data());
        upper = std::move(larger);
    }
    upper.setSize(mergeEvents(upper.data(), counts.upper, addedUpper));
}

class ExactBuilder {
  public:
    explicit ExactBuilder(const BuildContext& context) : context_(context) {}

    void buildNode(EventLists lists, const Box3& cell, int depth, ReferenceBudget budget,
                   std::unique_ptr<Subtree>& out) {
        if (errors_.any()) return;
        Split split;
        if (lists.triangles > kSerialTriangles && depth < context_.maxDepth &&
            budget.allows(lists.triangles)) {
            context_.checkCancelled();
            split = findSplit(lists, cell);
        }
        if (!split.valid() || split.cost >= context_.cost.leaf(lists.triangles)) {
            out = buildPiece(std::move(lists), cell, depth, budget);
            return;
        }
        const Halves cells(cell, split.axis, split.position);
        EventLists lower;
        const auto upper = std::make_shared<EventLists>();
        divide(std::move(lists), split, cells.lower, cells.upper, lower, *upper);
        const std::size_t all = std::size_t{lower.triangles} + upper->triangles;
        const ReferenceBudget lowerBudget = budget.portion(lower.triangles, all);
        const ReferenceBudget upperBudget = budget.portion(upper->triangles, all);
        out = std::make_unique<Subtree>();
        out->axis = split.axis;
        out->split = split.position;
        Subtree* const node = out.get();
#pragma omp task default(shared) firstprivate(upper, cells, upperBudget, depth, node)
        errors_.guard(
            [&] { buildNode(std::move(*upper), cells.upper, depth + 1, upperBudget, node->upper); });
        errors_.guard([&] { buildNode(std::move(lower), cells.lower, depth + 1, lowerBudget, node->lower); });
#pragma omp taskwait
    }

    TaskErrors& errors() { return errors_; }

  private:
    Split findSplit(const EventLists& lists, const Box3& cell) const {
        std::array<Split, 3> splits;
#pragma omp taskloop grainsize(1) default(shared)
        for (int axis = 0; axis < 3; ++axis) {
            const EventList& events = lists.axis[static_cast<std::size_t>(axis)];
            splits[static_cast<std::size_t>(axis)] =
                cheapestSplit(events.data(), events.size(), lists.triangles, cell, axis, context_.cost);
        }
        Split best;
        for (const Split& s : splits) {
            if (s.cost < best.cost) best = s;
        }
        return best;
    }

    void divide(EventLists lists, const Split& split, const Box3& lowerCell, const Box3& upperCell,
                EventLists& lower, EventLists& upper) {
        if (split.lower == 0 || split.upper == 0) { // only empty space is cut off
            (split.lower == 0 ? upper : lower) = std::move(lists);
            return;
        }
        const auto scratch = borrowScratch();
        const auto along = static_cast<std::size_t>(split.axis);
        std::vector<std::uint32_t> straddling;
        EventList& all = lists.axis[along];
        // Events below the plane are of triangles on the lower side and of straddling ones, that clipping
        // keeps.
        EventList below(2 * std::size_t{split.lower} + 1);
        const AlongSplit parts =
            divideAlong(all.data(), all.size(), split, scratch->sides.get(), below.data(), straddling);
        std::array<Clipped, 2> added;
        TaskErrors errors;
#pragma omp taskloop grainsize(1) default(shared)
        for (std::size_t side = 0; side < 2; ++side) {
            errors.guard(
                [&] { added[side] = clipTo(context_, straddling, side == 0 ? lowerCell : upperCell); });
        }
        errors.rethrow();
        lower.triangles = lists.triangles - split.upper + added[0].inside;
        upper.triangles = lists.triangles - split.lower + added[1].inside;
#pragma omp taskloop grainsize(1) default(shared)
        for (std::size_t i = 0; i < 3; ++i) {
            const std::size_t a = (along + 1 + i) % 3;
            if (a == along) {
                lower.axis[a] = std::move(below);
                lower.axis[a].setSize(mergeEvents(lower.axis[a].data(), parts.lower, added[0].events[a]));
                upper.axis[a] = std::move(all);
                upper.axis[a].dropFront(parts.upperFirst);
                upper.axis[a].setSize(mergeEvents(upper.axis[a].data(), parts.upper, added[1].events[a]));
                continue;
            }
            errors.guard([&] {
                lower.axis[a] = EventList(2 * std::size_t{lower.triangles} + 1);
                divideAxis(lists.axis[a], scratch->sides.get(), added[0].events[a], added[1].events[a],
                           lower.axis[a], upper.axis[a]);
            });
        }
        errors.rethrow();
    }

    std::unique_ptr<Subtree> buildPiece(EventLists lists, const Box3& cell, int depth,
                                        ReferenceBudget budget) {
        const auto scratch = borrowScratch();
        // A large piece is a rare one that no split divides: its memory is not worth keeping.
        if (lists.triangles > kSerialTriangles) {
            return ExactSubtreeBuilder(context_).build(std::move(lists), scratch->numbers.get(), cell, depth,
                                                       budget);
        }
        const auto builder =
            builders_.borrow([&] { return std::make_unique<ExactSubtreeBuilder>(context_); });
        return builder->build(std::move(lists), scratch->numbers.get(), cell, depth, budget);
    }

    Pool<Scratch>::Loan borrowScratch() {
        return scratch_.borrow([&] { return std::make_unique<Scratch>(context_.mesh.triangles.size()); });
    }

    const BuildContext& context_;
    TaskErrors errors_;
    Pool<Scratch> scratch_;
    Pool<ExactSubtreeBuilder> builders_;
};

} // namespace

std::unique_ptr<Subtree> buildExact(const BuildContext& context, EventLists lists, const Box3& cell) {
    ExactBuilder builder(context);
    std::unique_ptr<Subtree> root;
    const auto budget = ReferenceBudget::ofScene(lists.triangles);
    builder.errors().guard([&] { builder.buildNode(std::move(lists), cell, 0, budget, root); });
    builder.errors().rethrow();
    return root;
}

} // namespace rtcore
