/// Builds the kd-tree of a mesh by the surface area heuristic (thesis 2.2.2; Wald and Havran 2006, "On
/// building fast kd-trees for ray tracing, and on doing that in O(N log N)").
#pragma once

#include "rtcore/accel/build_options.h"
#include "rtcore/accel/kd_tree.h"
#include "rtcore/scene/mesh.h"

#include <stdexcept>

namespace rtcore {

/// Thrown when BuildProgress::cancel was set.
struct BuildCancelled : std::runtime_error {
    BuildCancelled() : std::runtime_error("building the kd-tree was stopped") {}
};

/// The tree over all triangles of `mesh`; degenerate triangles are kept where they lie. Positions must be
/// finite (asserted). The same input and options give the same tree, whatever the number of threads. Throws
/// std::length_error when a tree would not fit into 2^30 nodes or references, and BuildCancelled.
KdTree buildKdTree(const Mesh& mesh, const BuildOptions& options, BuildTimes* times = nullptr,
                   BuildProgress* progress = nullptr);

/// K_I / K_T that `intersectionCost` = 0 stands for. Small, since a vector of rays passes most triangles of a
/// leaf by (docs/lab/kernels.md), and smaller for larger models, whose trees have to stay in the caches.
float automaticIntersectionCost(std::size_t triangles);

} // namespace rtcore
