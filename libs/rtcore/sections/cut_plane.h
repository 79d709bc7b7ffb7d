/// The plane of a section, with axes of its own.
#pragma once

#include "rtcore/math/box.h"
#include "rtcore/math/vec.h"
#include "rtcore/scene/section_planes.h"

#include <array>
#include <vector>

namespace rtcore {

/// A position in a plane, in scene units.
using FlatPoint = std::array<double, 2>;
using FlatLoop = std::vector<FlatPoint>;

inline Vec3d exact(Vec3 v) { return {v.x, v.y, v.z}; }

/// Seen from the side that is taken away, `right` points to the right and `up` upwards.
struct CutPlane {
    Vec3d origin;
    Vec3d right, up, normal; ///< of unit length; `normal` = right x up

    /// How far a position lies on the side that is taken away.
    double above(Vec3d p) const { return dot(normal, p - origin); }
    FlatPoint flat(Vec3d p) const { return {dot(right, p - origin), dot(up, p - origin)}; }
    Vec3d point(const FlatPoint& p) const { return origin + right * p[0] + up * p[1]; }
};

/// The plane as rays meet it (SectionClip): further out by what positions of `bounds`, those of the model,
/// are rounded. Upright where `sceneUp` lies in it, else as upwardsOf() turns the view of it.
CutPlane cutPlaneOf(const SectionPlane& plane, const Box3& bounds, Vec3 sceneUp);

} // namespace rtcore
