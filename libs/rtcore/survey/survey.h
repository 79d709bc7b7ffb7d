/// The kind of view that a model offers: rooms to stand in, a stage, or an object.
#pragma once

#include "rtcore/accel/kd_tree.h"
#include "rtcore/scene/mesh.h"
#include "rtcore/survey/standing.h"
#include "rtcore/survey/subject.h"

#include <vector>

namespace rtcore {

/// How a model is best looked at.
struct Survey {
    Axes axes;
    Subject subject;
    std::vector<Stand> rooms; ///< places indoors; empty for what is looked at from outside
    Vec3 openSide;            ///< the one side on which a stage is open, else zero

    bool inside() const { return !rooms.empty(); }
    bool isStage() const { return !(openSide == Vec3{}); }
};

/// Some ten thousand rays, and subjectOf(). The same for the same input.
Survey survey(const KdTree& tree, const Mesh& mesh, const Axes& axes);

/// The height of its rooms in scene units, without regard to how large a unit is; 0: there are none. `up` is
/// a unit vector.
float roomHeight(const KdTree& tree, const Mesh& mesh, Vec3 up);

} // namespace rtcore
