/// Copies of the triangles' corners in the order in which leaves refer to them: more memory than fetching
/// them through the mesh (40 bytes a reference), and no three dependent memory accesses.
#pragma once

#include "rtcore/accel/kd_tree.h"
#include "rtcore/accel/uninitialized_array.h"
#include "rtcore/scene/mesh.h"

#include <cstddef>
#include <cstdint>
#include <span>

namespace rtcore {

inline constexpr std::size_t kFloatsPerRecord = 10;

/// The records of a leaf begin at kFloatsPerRecord * firstReference: ten arrays of count() numbers, the x, y
/// and z of the first corner of each triangle, then of the second and of the third, and the bits of its
/// index. A vector's length of padding follows the last leaf. `references` are those of the tree, in any
/// order inside a leaf.
UninitializedArray<float> makeLeafRecords(const KdTree& tree, std::span<const std::uint32_t> references,
                                          const Mesh& mesh);

} // namespace rtcore
