/// Which triangles of a scene kernels have to test with care (narrow_noise.h).
#pragma once

#include "rtcore/accel/kd_tree.h"
#include "rtcore/scene/mesh.h"

#include <cstdint>
#include <vector>

namespace rtcore {

/// Empty where a scene has no narrow triangles.
struct NarrowTriangles {
    NarrowTriangles(const KdTree& tree, const Mesh& mesh);
    /// `known`: narrowNoise() of each triangle of the mesh, or nothing where none is narrow.
    NarrowTriangles(const KdTree& tree, std::vector<float> known);

    /// narrowNoise() of it.
    float noiseOf(std::uint32_t triangle) const { return noise.empty() ? 0 : noise[triangle]; }

    std::vector<float> noise;              ///< narrowNoise() of each triangle
    std::vector<std::uint32_t> references; ///< those of the tree, in each leaf the narrow ones last
    std::vector<std::uint32_t> bits;       ///< one for each of them, 32 to a word: whether it is narrow
};

} // namespace rtcore
