/// The surface area heuristic: what a split is expected to cost a random ray (thesis 2.2.2).
#pragma once

#include "rtcore/math/box.h"

#include <cstdint>
#include <limits>

namespace rtcore {

struct CostModel {
    float traversal = 1;      ///< K_T
    float intersection = 1;   ///< K_I
    float emptyFactor = 0.8F; ///< 1 - bonus for a split that leaves one side empty

    float leaf(std::uint32_t triangles) const { return intersection * static_cast<float>(triangles); }
    /// The areas are fractions of the parent's.
    float split(float lowerArea, float upperArea, std::uint32_t lower, std::uint32_t upper) const {
        const float cost = traversal + intersection * (lowerArea * static_cast<float>(lower) +
                                                       upperArea * static_cast<float>(upper));
        return lower == 0 || upper == 0 ? cost * emptyFactor : cost;
    }
};

struct Split {
    float cost = std::numeric_limits<float>::infinity(); ///< infinite: no split is possible
    float position = 0;
    int axis = -1;
    bool planarLower = false; ///< triangles in the plane go to the lower side
    std::uint32_t lower = 0;  ///< triangles on each side; those cut in two count in both
    std::uint32_t upper = 0;
    bool valid() const { return axis >= 0; }
};

/// How the half area of the two parts of a cell follows from the position of a plane across `axis`.
struct AreaOfParts {
    AreaOfParts(const Box3& cell, int axis) : lo(cell.lo[axis]), hi(cell.hi[axis]) {
        const Vec3 d = cell.size();
        const float u = d[(axis + 1) % 3];
        const float v = d[(axis + 2) % 3];
        const float whole = cell.halfArea();
        const float inverse = whole > 0 ? 1 / whole : 0;
        face = whole > 0 ? u * v * inverse : 1; // in a line or a point no split saves anything
        rim = (u + v) * inverse;
    }
    float lower(float position) const { return face + (position - lo) * rim; }
    float upper(float position) const { return face + (hi - position) * rim; }

    float lo, hi;
    float face; ///< of the plane itself, as a fraction of the cell's half area
    float rim;  ///< per unit of length along the axis
};

} // namespace rtcore
