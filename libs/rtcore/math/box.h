/// Axis-aligned boxes.
#pragma once

#include "rtcore/math/vec.h"

#include <algorithm>
#include <limits>

namespace rtcore {

/// Closed box [lo, hi]. A default box is empty: lo > hi on every axis, and `extend` makes it what it is
/// given.
struct Box3 {
    Vec3 lo{kHuge, kHuge, kHuge};
    Vec3 hi{-kHuge, -kHuge, -kHuge};

    static constexpr float kHuge = std::numeric_limits<float>::max();

    void extend(Vec3 p) {
        for (int a = 0; a < 3; ++a) {
            lo[a] = std::min(lo[a], p[a]);
            hi[a] = std::max(hi[a], p[a]);
        }
    }
    void extend(const Box3& b) {
        extend(b.lo);
        extend(b.hi);
    }
    bool empty() const { return lo.x > hi.x || lo.y > hi.y || lo.z > hi.z; }
    bool contains(Vec3 p) const {
        return p.x >= lo.x && p.y >= lo.y && p.z >= lo.z && p.x <= hi.x && p.y <= hi.y && p.z <= hi.z;
    }
    bool meets(const Box3& b) const {
        return lo.x <= b.hi.x && lo.y <= b.hi.y && lo.z <= b.hi.z && b.lo.x <= hi.x && b.lo.y <= hi.y &&
               b.lo.z <= hi.z;
    }
    Vec3 size() const { return hi - lo; }
    Vec3 centre() const { return lo * 0.5F + hi * 0.5F; }
    float diagonal() const { return empty() ? 0.0F : length(size()); }
    /// Half of the surface area: all that the surface area heuristic needs.
    float halfArea() const {
        const Vec3 d = size();
        return d.x * d.y + d.y * d.z + d.z * d.x;
    }
    friend bool operator==(const Box3&, const Box3&) = default;
};

/// The parts of a box below and above a plane across `axis`: both contain the plane.
struct Halves {
    Halves(const Box3& box, int axis, float position) : lower(box), upper(box) {
        lower.hi[axis] = upper.lo[axis] = position;
    }

    Box3 lower, upper;
};

} // namespace rtcore
