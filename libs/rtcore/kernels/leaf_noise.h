/// What rounding does to the distances of triangles (precise_hit.h), for kernels that meet many of them.
#pragma once

#include "rtcore/accel/kd_tree.h"
#include "rtcore/scene/mesh.h"

#include <cstdint>
#include <vector>

namespace rtcore {

struct LeafNoise {
    LeafNoise(const KdTree& tree, const Mesh& mesh);

    /// noiseOfTriangle() of each.
    std::vector<float> ofTriangle;
    /// For the first reference of each leaf: 1 where one of its triangles has a negative noise. Empty where
    /// none has.
    std::vector<std::uint8_t> narrow;

    bool isNarrow(std::uint32_t firstReference) const {
        return !narrow.empty() && narrow[firstReference] != 0;
    }
};

} // namespace rtcore
