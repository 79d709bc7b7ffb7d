/// Is a kd-tree what it claims to be? For trees that come from files, for tests, and for `BSPBuilder -vv`.
#pragma once

#include "rtcore/accel/kd_tree.h"
#include "rtcore/platform/sentence.h"
#include "rtcore/scene/mesh.h"

#include <cstddef>
#include <optional>

namespace rtcore {

/// Checks the whole structure in linear time and constant memory: that nodes and references stand in the one
/// valid order of kd_tree.h and are all used (so there is no cycle, no sharing, nothing unreachable), that no
/// leaf is deeper than kMaxKdDepth, every split is inside its cell, and every leaf's references are ascending
/// and below `triangleCount`. The bounds must be finite with lo <= hi; only a lone leaf without references
/// may have the empty box. After it, any traversal is safe. Nothing when the tree is sound, else what is
/// wrong; no content throws.
std::optional<Sentence> validateKdTree(const KdTree& tree, std::size_t triangleCount);

/// Checks the geometry by clipping every triangle against every cell on its way down, in double precision: a
/// leaf must hold each triangle that reaches into its cell by more than a tolerance (10^-6 of the largest
/// coordinate) and may hold none whose box lies farther outside than that; every triangle must be in some
/// leaf. `tree` and the indices of `mesh` must be sound. Takes seconds for millions of triangles.
std::optional<Sentence> validateCoverage(const KdTree& tree, const Mesh& mesh);

} // namespace rtcore
