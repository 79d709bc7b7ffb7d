/// A small piece of a quick tree: few candidates for each split, and all numbers of a node in vectors.
#pragma once

#include "rtcore/accel/box_lists.h"
#include "rtcore/accel/exact_subtree.h"
#include "rtcore/accel/uninitialized_array.h"

#include <array>
#include <memory>

namespace rtcore {

/// Triangles of a mesh by their numbers; without numbers the first `count`.
struct TriangleList {
    std::uint32_t operator[](std::size_t i) const {
        return numbers == nullptr ? static_cast<std::uint32_t>(i) : numbers[i];
    }

    const std::uint32_t* numbers = nullptr;
    std::size_t count = 0;
};

/// Builds the trees of small pieces one after another, in memory that it keeps. For one thread at a time.
class QuickSubtreeBuilder {
  public:
    /// `context` must outlive the builder.
    explicit QuickSubtreeBuilder(const BuildContext& context) : context_(context) {}

    struct Rules {
        float weight = 1;          ///< so many triangles are meant by each one
        std::size_t leafBelow = 0; ///< nodes of fewer are not split
    };

    /// The tree below a node at `depth`, which has these triangles. It depends on nothing else; in its leaves
    /// they keep their order.
    std::unique_ptr<Subtree> build(const TriangleList& triangles, const Box3& cell, const Rules& rules,
                                   int depth, ReferenceBudget budget);

  private:
    void load(const TriangleList& triangles, const Box3& cell);
    void buildNode(std::uint32_t index, std::size_t first, std::size_t count, std::size_t top,
                   const Box3& cell, int depth, ReferenceBudget budget);
    Split findSplit(const BoxLists& boxes, std::size_t count, const Box3& cell) const;
    void makeLeaf(std::uint32_t index, std::size_t first, std::size_t count);
    void makeRoom(std::size_t top, std::size_t count);
    BoxLists at(std::size_t first);

    const BuildContext& context_;
    CostModel cost_;
    std::size_t leafBelow_ = 0;
    std::unique_ptr<Subtree> tree_;
    std::array<UninitializedArray<float>, 6> numbers_; ///< lists of the nodes that wait, as a stack
    UninitializedArray<std::uint32_t> triangles_;
};

} // namespace rtcore
