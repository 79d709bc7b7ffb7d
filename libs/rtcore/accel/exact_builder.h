/// The exact builder for large nodes: same splits as exact_subtree.h, spread over threads.
#pragma once

#include "rtcore/accel/exact_subtree.h"

#include <memory>

namespace rtcore {

/// Nodes of at most this many triangles are built by one thread. A constant, so that the tree does not depend
/// on the number of threads.
inline constexpr std::size_t kSerialTriangles = 4096;

/// Must be called inside an OpenMP parallel region by one thread (or without OpenMP): it makes tasks for the
/// others.
std::unique_ptr<Subtree> buildExact(const BuildContext& context, EventLists lists, const Box3& cell);

} // namespace rtcore
