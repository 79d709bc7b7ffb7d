/// Which leaves and triangles of a scene kernels have to test with care (narrow_noise.h).
#pragma once

#include "rtcore/accel/kd_tree.h"
#include "rtcore/scene/mesh.h"

#include <cstdint>
#include <vector>

namespace rtcore {

/// Empty where a scene has no narrow triangles.
struct NarrowTriangles {
    NarrowTriangles(const KdTree& tree, const Mesh& mesh);

    std::vector<float> noise; ///< narrowNoise() of each triangle
    /// A bit for each reference, 32 to a word: where it is the first of a leaf, whether one there is narrow.
    std::vector<std::uint32_t> leaves;
};

inline bool isBitSet(const std::uint32_t* bits, std::size_t i) { return bits[i / 32] >> i % 32 & 1U; }

} // namespace rtcore
