/// The quick builder: the top of the tree is that of a sample, by which all triangles are handed out at once;
/// small pieces are built in vectors (quick_subtree.h).
#pragma once

#include "rtcore/accel/exact_subtree.h"

#include <memory>

namespace rtcore {

/// Must be called inside an OpenMP parallel region by one thread (or without OpenMP). The tree does not
/// depend on the number of threads.
std::unique_ptr<Subtree> buildQuick(const BuildContext& context, const Box3& cell);

} // namespace rtcore
