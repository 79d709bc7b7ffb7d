/// The fast builder: candidates are the borders of equal bins (Popov et al. 2006; Shevtsov et al. 2007),
/// boxes are cut by planes instead of clipping triangles, and at most small nodes are left to the exact
/// builder.
#pragma once

#include "rtcore/accel/exact_subtree.h"

#include <memory>

namespace rtcore {

struct FastOptions {
    std::size_t bins = 24;       ///< 4..64, of large nodes
    std::size_t exactBelow = 18; ///< nodes of fewer triangles are built exactly
};

/// The options for a `quality` from kQuickQuality + 1 to 10, to which others are clamped.
FastOptions fastOptions(int quality);

/// Must be called inside an OpenMP parallel region by one thread (or without OpenMP).
std::unique_ptr<Subtree> buildFast(const BuildContext& context, const FastOptions& options, const Box3& cell);

} // namespace rtcore
