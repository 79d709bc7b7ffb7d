/// Statistics of a kd-tree, for `BSPBuilder -v`, `-vv` and `-hist`.
#pragma once

#include "rtcore/accel/kd_tree.h"

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace rtcore {

struct KdStatistics {
    std::uint64_t nodes = 0, leaves = 0, emptyLeaves = 0;
    std::uint64_t references = 0;
    std::uint64_t largestLeaf = 0; ///< references
    int depth = 0;                 ///< of the deepest leaf; a lone root has 0
    double averageLeafDepth = 0;
    double averageFilledLeaf = 0; ///< references per leaf that has any
    double expectedCost = 0;      ///< of a random ray, by the surface area heuristic, in traversal steps
    std::uint64_t bytes = 0;      ///< nodes and references

    std::vector<std::uint64_t> leavesBySize;  ///< index: number of references
    std::vector<std::uint64_t> leavesByDepth; ///< index: depth
};

/// Walks the whole tree. The costs are those that the tree was built with.
KdStatistics computeStatistics(const KdTree& tree, float traversalCost, float intersectionCost);

/// A text histogram of `counts` (index = value) in at most `bands` bands of equal width, one line each.
std::string drawHistogram(const std::string& title, const std::vector<std::uint64_t>& counts, int bands);

} // namespace rtcore
