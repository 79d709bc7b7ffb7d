/// The directions of a model, and how large a metre is in it.
#pragma once

#include "rtcore/math/box.h"
#include "rtcore/math/vec.h"
#include "rtcore/scene/scene.h"

namespace rtcore {

/// The horizontal axes of a model and the one that goes up; unit vectors.
struct Axes {
    /// `upwards` is a unit vector; `metresPerUnit` above 0, finite.
    explicit Axes(Vec3 upwards, float metresPerUnit = 1);

    Vec3 up, right, front;
    float metre; ///< scene units

    /// Radians from `right` towards `front`.
    Vec3 horizontal(float angle) const;
};

/// The axes of a scene's model.
inline Axes axesOf(const SceneLook& scene) { return Axes(scene.up, scene.metresPerUnit); }

/// How far the box reaches along one of its axes.
float extentAlong(const Box3& box, Vec3 axis);

/// Where it ends along one of its axes: the lower and the upper end.
struct Range {
    float low = 0, high = 0;
};
Range rangeAlong(const Box3& box, Vec3 axis);

} // namespace rtcore
