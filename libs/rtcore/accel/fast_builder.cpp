#include "rtcore/accel/fast_builder.h"

#include "rtcore/accel/bins.h"
#include "rtcore/accel/exact_builder.h"
#include "rtcore/accel/float4.h"
#include "rtcore/accel/pool.h"
#include "rtcore/accel/task_loop.h"
#include "rtcore/platform/task_errors.h"

#include <algorithm>
#include <bit>
#include <utility>
#include <vector>

namespace rtcore {

namespace {

using Item = BoundedTriangle;
using ItemList = UninitializedArray<Item>;

/// A large node's triangles are counted by several threads, so many each.
constexpr std::size_t kChunk = 16'384;

/// Copies each item to its side or, cut in two, to both. `lower` has room for one more than come; `upper` may
/// be `items` itself. Returns the numbers.
struct Counts {
    std::size_t lower, upper;
};
Counts divide(const Item* items, std::size_t count, const Split& split, Item* lower, Item* upper) {
    const auto axis = static_cast<std::size_t>(split.axis);
    Float4 lowerHi = set4(Box3::kHuge);
    Float4 upperLo = set4(-Box3::kHuge);
    lowerHi[split.axis] = upperLo[split.axis] = split.position;
    Counts n{0, 0};
    for (std::size_t i = 0; i < count; ++i) {
        const Float4 lo = load4(items[i].lo); // with the triangle
        const Float4 hi = load4(items[i].hi);
        const float first = items[i].lo[axis];
        const float last = items[i].hi[axis];
        const bool planar = (first == split.position) & (last == split.position);
        store4(lo, lower[n.lower].lo);
        store4(min4(hi, lowerHi), lower[n.lower].hi);
        store4(max4(lo, upperLo), upper[n.upper].lo);
        store4(hi, upper[n.upper].hi);
        n.lower += static_cast<std::size_t>((first < split.position) | (planar & split.planarLower));
        n.upper += static_cast<std::size_t>((last > split.position) | (planar & !split.planarLower));
    }
    return n;
}

/// Everything below one node of at most kSerialTriangles, by one thread.
class SerialFastBuilder {
  public:
    SerialFastBuilder(const BuildContext& context, const FastOptions& options)
        : context_(context), options_(options), exact_(context) {}

    std::unique_ptr<Subtree> build(const ItemList& items, const Box3& cell, int depth,
                                   ReferenceBudget budget) {
        tree_ = std::make_unique<Subtree>();
        makeRoom(0, items.size());
        std::copy(items.data(), items.data() + items.size(), arena_.data());
        tree_->nodes.emplace_back();
        buildNode(0, 0, items.size(), items.size(), cell, depth, budget);
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
            Bins counted(cell, bins);
            counted.add(arena_.data() + first, count);
            split = counted.cheapest(cell, static_cast<std::uint32_t>(count), context_.cost);
        }
        if (!(split.cost < context_.cost.leaf(static_cast<std::uint32_t>(count)))) {
            makeLeaf(index, first, count);
            return;
        }
        makeRoom(top, count + 1);
        Item* const own = arena_.data() + first;
        const Counts n = divide(own, count, split, arena_.data() + top, own);
        const Halves cells(cell, split.axis, split.position);
        const auto children = static_cast<std::uint32_t>(tree_->nodes.size());
        tree_->nodes.resize(tree_->nodes.size() + 2);
        tree_->nodes[index] = {split.axis, split.position, children, children + 1};
        buildNode(children, top, n.lower, top + n.lower, cells.lower, depth + 1,
                  budget.portion(n.lower, n.lower + n.upper));
        buildNode(children + 1, first, n.upper, top, cells.upper, depth + 1,
                  budget.portion(n.upper, n.lower + n.upper));
    }

    /// For `count` items from `top` on.
    void makeRoom(std::size_t top, std::size_t count) {
        if (arena_.capacity() >= top + count) return;
        ItemList larger(std::max(top + count, arena_.capacity() * 3 / 2));
        std::copy(arena_.data(), arena_.data() + top, larger.data());
        arena_ = std::move(larger);
    }

    void makeLeaf(std::uint32_t index, std::size_t first, std::size_t count) {
        const auto firstReference = static_cast<std::uint32_t>(tree_->references.size());
        for (std::size_t i = 0; i < count; ++i)
            tree_->references.push_back(arena_.data()[first + i].triangle());
        tree_->nodes[index] = {BuildNode::kLeaf, 0, firstReference, static_cast<std::uint32_t>(count)};
    }

    const BuildContext& context_;
    const FastOptions& options_;
    std::unique_ptr<Subtree> tree_;
    ItemList arena_;
    ExactSubtreeBuilder exact_;
};

class FastBuilder {
  public:
    FastBuilder(const BuildContext& context, const FastOptions& options)
        : context_(context), options_(options) {}

    std::unique_ptr<Subtree> build(const Box3& cell) {
        std::unique_ptr<Subtree> root;
        errors_.guard([&] {
            ItemList items = makeItems();
            const auto budget = ReferenceBudget::ofScene(items.size());
            buildNode(std::move(items), cell, 0, budget, root);
        });
        errors_.rethrow();
        return root;
    }

  private:
    template <typename Work>
    void forEachChunk(std::size_t count, const Work& work) {
        forEachInTasks((count + kChunk - 1) / kChunk, [&](std::size_t chunk) {
            work(chunk, chunk * kChunk, std::min(count, (chunk + 1) * kChunk));
        });
    }

    ItemList makeItems() {
        const Mesh& mesh = context_.mesh;
        ItemList items(mesh.triangles.size());
        items.setSize(mesh.triangles.size());
        forEachChunk(items.size(), [&](std::size_t, std::size_t first, std::size_t end) {
            for (std::size_t i = first; i < end; ++i) {
                Item& item = items.data()[i];
                Bounds4 box = boundsOf(mesh, i);
                box.lo[3] = std::bit_cast<float>(static_cast<std::uint32_t>(i));
                box.hi[3] = 0;
                store4(box.lo, item.lo);
                store4(box.hi, item.hi);
            }
        });
        return items;
    }

    Split findSplit(const ItemList& items, const Box3& cell) {
        Bins all(cell, options_.bins);
        if (items.size() <= 2 * kChunk) {
            all.add(items.data(), items.size());
        } else {
            std::vector<Bins> parts((items.size() + kChunk - 1) / kChunk, all);
            forEachChunk(items.size(), [&](std::size_t chunk, std::size_t first, std::size_t end) {
                parts[chunk].add(items.data() + first, end - first);
            });
            for (const Bins& part : parts) all.add(part);
        }
        return all.cheapest(cell, static_cast<std::uint32_t>(items.size()), context_.cost);
    }

    void buildNode(ItemList items, const Box3& cell, int depth, ReferenceBudget budget,
                   std::unique_ptr<Subtree>& out) {
        if (errors_.any()) return;
        context_.checkCancelled();
        Split split;
        if (items.size() > kSerialTriangles && depth < context_.maxDepth && budget.allows(items.size())) {
            split = findSplit(items, cell);
        }
        if (!(split.cost < context_.cost.leaf(static_cast<std::uint32_t>(items.size())))) {
            out = buildPiece(items, cell, depth, budget);
            return;
        }
        ItemList lower(items.size() + 1);
        const Counts n = divide(items.data(), items.size(), split, lower.data(), items.data());
        lower.setSize(n.lower);
        items.setSize(n.upper);
        const Halves cells(cell, split.axis, split.position);
        out = std::make_unique<Subtree>();
        out->axis = split.axis;
        out->split = split.position;
        Subtree* const node = out.get();
        const ReferenceBudget lowerBudget = budget.portion(n.lower, n.lower + n.upper);
        const ReferenceBudget upperBudget = budget.portion(n.upper, n.lower + n.upper);
        const auto upper = std::make_shared<ItemList>(std::move(items));
#pragma omp task default(shared) firstprivate(upper, cells, upperBudget, depth, node)
        errors_.guard(
            [&] { buildNode(std::move(*upper), cells.upper, depth + 1, upperBudget, node->upper); });
        errors_.guard([&] { buildNode(std::move(lower), cells.lower, depth + 1, lowerBudget, node->lower); });
#pragma omp taskwait
    }

    std::unique_ptr<Subtree> buildPiece(const ItemList& items, const Box3& cell, int depth,
                                        ReferenceBudget budget) {
        const auto builder =
            builders_.borrow([&] { return std::make_unique<SerialFastBuilder>(context_, options_); });
        auto piece = builder->build(items, cell, depth, budget);
        if (context_.progress != nullptr) context_.progress->finished += items.size();
        return piece;
    }

    const BuildContext& context_;
    const FastOptions& options_;
    TaskErrors errors_;
    Pool<SerialFastBuilder> builders_;
};

} // namespace

FastOptions fastOptions(int quality) {
    const auto q = static_cast<std::size_t>(std::clamp(quality, kQuickQuality + 1, 10));
    return {4 + 4 * q, std::size_t{18} << (q - 5)};
}

std::unique_ptr<Subtree> buildFast(const BuildContext& context, const FastOptions& options,
                                   const Box3& cell) {
    return FastBuilder(context, options).build(cell);
}

} // namespace rtcore
