/// What there is to see from places in the middle of a model: whether one stands in a room, on a stage, or
/// beside an object.
#pragma once

#include "rtcore/accel/kd_tree.h"
#include "rtcore/math/vec.h"
#include "rtcore/scene/mesh.h"

#include <optional>
#include <vector>

namespace rtcore {

/// The horizontal axes of a model and the one that goes up; unit vectors.
struct Axes {
    explicit Axes(Vec3 upwards);
    Vec3 up, right, front;

    /// Radians from `right` towards `front`.
    Vec3 horizontal(float angle) const;
};

/// How far the box reaches along one of its axes.
float extentAlong(const Box3& box, Vec3 axis);

/// A place to stand on, and what can be seen from it.
struct Stand {
    Vec3 eye;
    float enclosed = 0; ///< fraction of horizontal directions that end at a surface
    float walled = 0;   ///< fraction of horizontal directions that end at the front of one
    float reach = 0;    ///< mean fraction of the distance to the border of the model that is free
    float view = 0;     ///< mean distance to what is seen
    Vec3 longestView;
    Vec3 openSide; ///< sum of the directions that end nowhere
};

/// From a place above the floor, at eye height over it; nothing where there is no floor.
std::optional<Stand> standAt(const KdTree& tree, const Mesh& mesh, const Axes& axes, Vec3 place);

/// Whether walls surround it, as those of a room do and the skin of a body does not.
bool isIndoors(const Stand& stand);

/// N x N places in the middle 80 % of the model's length and width, at half its height. `n` is odd.
std::vector<Vec3> placesIn(const Box3& bounds, const Axes& axes, int n);

/// What 5 x 5 such places tell of the model.
struct Survey {
    std::optional<Stand> indoors; ///< the widest place with walls all around, when there are several such
    Vec3 openSide;                ///< the one side on which a stage is open, else zero
};

/// `tree.bounds` must not be empty.
Survey survey(const KdTree& tree, const Mesh& mesh, const Axes& axes);

} // namespace rtcore
