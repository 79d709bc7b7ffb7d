/// Which leaves and triangles of a scene kernels have to test with care (precise_hit.h).
#pragma once

#include "rtcore/accel/kd_tree.h"
#include "rtcore/scene/mesh.h"

#include <cstdint>
#include <vector>

namespace rtcore {

/// Bits, 32 to a word; empty where a scene has no narrow triangles.
struct NarrowTriangles {
    NarrowTriangles(const KdTree& tree, const Mesh& mesh);

    std::vector<std::uint32_t> triangles; ///< isNarrow() of each
    std::vector<std::uint32_t> leaves;    ///< of each leaf's first reference: whether one of its triangles is
};

inline bool isBitSet(const std::uint32_t* bits, std::size_t i) { return bits[i / 32] >> i % 32 & 1U; }

} // namespace rtcore
