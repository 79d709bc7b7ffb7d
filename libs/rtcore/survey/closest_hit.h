/// The closest surface in a direction, whatever its material.
#pragma once

#include "rtcore/kernels/single_ray.h"

#include <limits>
#include <optional>

namespace rtcore {

/// The distance is in lengths of `direction`.
inline std::optional<Hit> closestHit(const KdTree& tree, const Mesh& mesh, Vec3 from, Vec3 direction) {
    Hit hit;
    if (!intersect(tree, mesh, {from, 0, direction, std::numeric_limits<float>::max()}, hit))
        return std::nullopt;
    return hit;
}

} // namespace rtcore
