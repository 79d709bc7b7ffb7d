/// How a kd-tree is built.
#pragma once

#include "rtcore/math/box.h"

#include <atomic>
#include <cstdint>
#include <optional>

namespace rtcore {

enum class BuildMethod {
    Exact, ///< every clipped triangle bound is a candidate, O(n log n) (Wald and Havran 2006)
    Fast,  ///< binned candidates for large nodes, exact ones for small ones, see fastQuality
};

/// Trees of up to this fastQuality are for few rays.
inline constexpr int kQuickQuality = 4;

struct BuildOptions {
    BuildMethod method = BuildMethod::Exact;
    float traversalCost = 1;    ///< K_T
    float intersectionCost = 0; ///< K_I; 0 = by size, see automaticIntersectionCost()
    float emptyBonus = 0.2F;    ///< 0..1: a split that cuts off empty space costs this fraction less
    int lookAhead = 1;          ///< splits in a row that may fail to pay; undone when they did not in the end
    int fastQuality = 5; ///< 1..10, Fast only: up to kQuickQuality few candidates and samples, above it more
                         ///< and more bins, and small nodes exactly
    int threads = 0;     ///< 0 = all cores; the tree does not depend on it
    std::optional<Box3> bounds = {}; ///< of the tree, in place of those of the triangles, which lie inside
};

/// Seconds of each phase, filled by the builder.
struct BuildTimes {
    double prepare = 0; ///< bounds, events, sorting
    double split = 0;   ///< the splits
    double emit = 0;    ///< nodes and references in their final order
    double total() const { return prepare + split + emit; }
};

/// Shared with another thread that shows progress or stops the build.
struct BuildProgress {
    std::atomic<std::uint64_t> triangles{0}; ///< of the input
    std::atomic<std::uint64_t> finished{0};  ///< triangle references settled so far; in the end more than
                                             ///< `triangles`, since some are in several leaves
    std::atomic<bool> cancel{false};
};

} // namespace rtcore
