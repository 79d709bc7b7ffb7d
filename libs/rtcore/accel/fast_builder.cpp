#include "rtcore/accel/fast_builder.h"

#include "rtcore/accel/exact_builder.h"
#include "rtcore/platform/task_errors.h"

#include <algorithm>
#include <utility>

namespace rtcore {

namespace {

constexpr std::size_t kMaxBins = 64;

using Item = BoundedTriangle;

/// Where the items of a node begin and end along one axis, counted by bins.
class Bins {
  public:
    Bins(const Box3& cell, int axis, std::size_t count)
        : axis_(axis), count_(count), lo_(cell.lo[axis]), extent_(cell.hi[axis] - cell.lo[axis]),
          scale_(static_cast<float>(count) / extent_) {}

    bool usable() const { return extent_ > 0 && scale_ < Box3::kHuge; }
    void add(const Item& item) {
        const float lo = item.box.lo[axis_];
        const float hi = item.box.hi[axis_];
        ++starts_[bin(lo)];
        ++ends_[bin(hi)];
        first_ = std::min(first_, lo);
        last_ = std::max(last_, hi);
    }

    /// The cheapest border of a bin, or end of all items: that cuts off empty space exactly.
    Split cheapest(const Box3& cell, std::uint32_t items, const CostModel& cost) const {
        Split best;
        const AreaOfParts area(cell, axis_);
        const auto consider = [&](float position, std::uint32_t lower, std::uint32_t upper) {
            if (!(position > area.lo && position < area.hi)) return;
            const float c = cost.split(area.lower(position), area.upper(position), lower, upper);
            if (c < best.cost) best = {c, position, axis_, position != first_};
        };
        std::uint32_t lower = 0;
        std::uint32_t upper = items;
        for (std::size_t i = 1; i < count_; ++i) {
            lower += starts_[i - 1];
            upper -= ends_[i - 1];
            consider(lo_ + extent_ * (static_cast<float>(i) / static_cast<float>(count_)), lower, upper);
        }
        consider(first_, 0, items);
        consider(last_, items, 0);
        return best;
    }

  private:
    std::size_t bin(float x) const {
        const float place = (x - lo_) * scale_;
        return place > 0 ? std::min(static_cast<std::size_t>(place), count_ - 1) : 0;
    }

    int axis_;
    std::size_t count_;
    float lo_, extent_, scale_;
    float first_ = Box3::kHuge, last_ = -Box3::kHuge;
    std::array<std::uint32_t, kMaxBins> starts_{}, ends_{};
};

Split cheapestBinned(const Item* items, std::size_t count, const Box3& cell, std::size_t bins,
                     const CostModel& cost) {
    Split best;
    for (int axis = 0; axis < 3; ++axis) {
        Bins counted(cell, axis, bins);
        if (!counted.usable()) continue;
        for (std::size_t i = 0; i < count; ++i) counted.add(items[i]);
        const Split s = counted.cheapest(cell, static_cast<std::uint32_t>(count), cost);
        if (s.cost < best.cost) best = s;
    }
    return best;
}

/// Copies each item to its side or, cut in two, to both. `upper` may be `items` itself. Returns the numbers.
struct Counts {
    std::size_t lower, upper;
};
Counts divide(const Item* items, std::size_t count, const Split& split, Item* lower, Item* upper) {
    const int axis = split.axis;
    Counts n{0, 0};
    for (std::size_t i = 0; i < count; ++i) {
        const Item item = items[i];
        const float lo = item.box.lo[axis];
        const float hi = item.box.hi[axis];
        const bool planar = lo == split.position && hi == split.position;
        const bool inLower = planar ? split.planarLower : lo < split.position;
        const bool inUpper = planar ? !split.planarLower : hi > split.position;
        if (inLower) {
            lower[n.lower] = item;
            lower[n.lower++].box.hi[axis] = std::min(hi, split.position);
        }
        if (inUpper) {
            upper[n.upper] = item;
            upper[n.upper++].box.lo[axis] = std::max(lo, split.position);
        }
    }
    return n;
}

/// Everything below one node of at most kSerialTriangles, by one thread.
class SerialFastBuilder {
  public:
    SerialFastBuilder(const BuildContext& context, const FastOptions& options)
        : context_(context), options_(options), tree_(std::make_unique<Subtree>()), exact_(context) {}

    std::unique_ptr<Subtree> build(const std::vector<Item>& items, const Box3& cell, int depth,
                                   ReferenceBudget budget) {
        arena_ = items;
        tree_->nodes.emplace_back();
        buildNode(0, 0, items.size(), arena_.size(), cell, depth, budget);
        return std::move(tree_);
    }

  private:
    /// The node's items are arena_[first, first + count); all from `top` on is free.
    void buildNode(std::uint32_t index, std::size_t first, std::size_t count, std::size_t top,
                   const Box3& cell, int depth, ReferenceBudget budget) {
        if (count < options_.exactBelow) {
            exact_.build(arena_.data() + first, count, cell, depth, budget, *tree_, index);
            return;
        }
        // Few items need few bins.
        const std::size_t bins = std::min(options_.bins, std::max<std::size_t>(8, count / 2));
        Split split;
        if (depth < context_.maxDepth && count > 0 && budget.allows(count)) {
            split = cheapestBinned(arena_.data() + first, count, cell, bins, context_.cost);
        }
        if (!(split.cost < context_.cost.leaf(static_cast<std::uint32_t>(count)))) {
            makeLeaf(index, first, count);
            return;
        }
        if (arena_.size() < top + count) arena_.resize(std::max(top + count, arena_.size() * 3 / 2));
        Item* const own = arena_.data() + first;
        const Counts n = divide(own, count, split, arena_.data() + top, own);
        Box3 lowerCell = cell;
        Box3 upperCell = cell;
        lowerCell.hi[split.axis] = upperCell.lo[split.axis] = split.position;
        const auto children = static_cast<std::uint32_t>(tree_->nodes.size());
        tree_->nodes.resize(tree_->nodes.size() + 2);
        tree_->nodes[index] = {split.axis, split.position, children, children + 1};
        buildNode(children, top, n.lower, top + n.lower, lowerCell, depth + 1,
                  budget.share(n.lower, n.lower + n.upper));
        buildNode(children + 1, first, n.upper, top, upperCell, depth + 1,
                  budget.share(n.upper, n.lower + n.upper));
    }

    void makeLeaf(std::uint32_t index, std::size_t first, std::size_t count) {
        const auto firstReference = static_cast<std::uint32_t>(tree_->references.size());
        for (std::size_t i = 0; i < count; ++i) tree_->references.push_back(arena_[first + i].triangle);
        tree_->nodes[index] = {BuildNode::kLeaf, 0, firstReference, static_cast<std::uint32_t>(count)};
    }

    const BuildContext& context_;
    const FastOptions& options_;
    std::unique_ptr<Subtree> tree_;
    std::vector<Item> arena_;
    ExactSubtreeBuilder exact_;
};

class FastBuilder {
  public:
    FastBuilder(const BuildContext& context, const FastOptions& options)
        : context_(context), options_(options) {}

    void buildNode(std::vector<Item> items, const Box3& cell, int depth, ReferenceBudget budget,
                   std::unique_ptr<Subtree>& out) {
        if (errors_.any()) return;
        context_.checkCancelled();
        Split split;
        if (items.size() > kSerialTriangles && depth < context_.maxDepth && budget.allows(items.size())) {
            split = cheapestBinned(items.data(), items.size(), cell, options_.bins, context_.cost);
        }
        if (!(split.cost < context_.cost.leaf(static_cast<std::uint32_t>(items.size())))) {
            const std::size_t count = items.size();
            out = SerialFastBuilder(context_, options_).build(items, cell, depth, budget);
            if (context_.progress != nullptr) context_.progress->finished += count;
            return;
        }
        std::vector<Item> lower(items.size());
        const Counts n = divide(items.data(), items.size(), split, lower.data(), items.data());
        lower.resize(n.lower);
        lower.shrink_to_fit();
        items.resize(n.upper);
        Box3 lowerCell = cell;
        Box3 upperCell = cell;
        lowerCell.hi[split.axis] = upperCell.lo[split.axis] = split.position;
        out = std::make_unique<Subtree>();
        out->axis = split.axis;
        out->split = split.position;
        Subtree* const node = out.get();
        const ReferenceBudget lowerBudget = budget.share(n.lower, n.lower + n.upper);
        const ReferenceBudget upperBudget = budget.share(n.upper, n.lower + n.upper);
        const auto upper = std::make_shared<std::vector<Item>>(std::move(items));
#pragma omp task default(shared) firstprivate(upper, upperCell, upperBudget, depth, node)
        errors_.guard([&] { buildNode(std::move(*upper), upperCell, depth + 1, upperBudget, node->upper); });
        errors_.guard([&] { buildNode(std::move(lower), lowerCell, depth + 1, lowerBudget, node->lower); });
#pragma omp taskwait
    }

    void rethrow() const { errors_.rethrow(); }

  private:
    const BuildContext& context_;
    const FastOptions& options_;
    TaskErrors errors_;
};

} // namespace

FastOptions fastOptions(int quality) {
    const auto q = static_cast<std::size_t>(std::clamp(quality, 1, 10));
    return {4 + 4 * q, q < 5 ? 0 : std::size_t{16} << (q - 5)};
}

std::unique_ptr<Subtree> buildFast(const BuildContext& context, const FastOptions& options,
                                   const Box3& cell) {
    std::vector<Item> items(context.mesh.triangles.size());
    for (std::uint32_t i = 0; i < items.size(); ++i) {
        items[i].triangle = i;
        for (int corner = 0; corner < 3; ++corner) items[i].box.extend(context.mesh.position(i, corner));
    }
    FastBuilder builder(context, options);
    std::unique_ptr<Subtree> root;
    const auto budget = ReferenceBudget::ofScene(items.size());
    builder.buildNode(std::move(items), cell, 0, budget, root);
    builder.rethrow();
    return root;
}

} // namespace rtcore
