/// Where people can stand in a model, and what surrounds them there.
#pragma once

#include "rtcore/accel/kd_tree.h"
#include "rtcore/scene/mesh.h"
#include "rtcore/survey/axes.h"

#include <array>
#include <optional>
#include <vector>

namespace rtcore {

/// Free space above a floor.
struct Space {
    Vec3 floor;
    float headroom = 0; ///< up to what is above; infinite under the open sky
};

/// Straight through the model at `place`, whatever its height: the spaces from the highest down.
std::vector<Space> spacesAt(const KdTree& tree, const Mesh& mesh, const Axes& axes, Vec3 place);

/// A place to look around from.
struct Stand {
    static constexpr int kDirections = 32; ///< the i-th is Axes::horizontal(2 pi i / kDirections)

    Vec3 floor, eye;
    float headroom = 0;                    ///< from the floor; infinite under the open sky
    float height = 0;                      ///< the same, but under the open sky to the top of the model
    std::array<float, kDirections> free{}; ///< distance to what is seen there; infinite for nothing
    float enclosed = 0;                    ///< fraction of the directions that end at a surface
    float walled = 0;                      ///< fraction that end at the front of one
    float steep = 0;                       ///< fraction that end at the front of one that is rather upright
    float reach = 0; ///< mean fraction of the distance to the border of the model that is free
    float view = 0;  ///< mean distance to what is seen
    Vec3 openSide;   ///< sum of the directions that end nowhere

    bool covered() const;
};

/// Looks around at `eyeHeight` over the floor.
Stand lookAround(const KdTree& tree, const Mesh& mesh, const Axes& axes, const Space& space, float eyeHeight);

/// A person's eyes, in metres over the floor.
inline constexpr float kEyeHeight = 1.6F;

/// With eyes at kEyeHeight; nothing where the body of a person has no room, below or in furniture, or stands
/// on furniture or on a stair.
std::optional<Stand> standIn(const KdTree& tree, const Mesh& mesh, const Axes& axes, const Space& space);

/// Whether walls surround it, as those of a room do and the skin of a body does not: under a ceiling with
/// windows and doors, or in a court under the sky.
bool isIndoors(const Stand& stand);

/// The same of wherever an eye is.
bool isIndoors(const KdTree& tree, const Mesh& mesh, const Axes& axes, Vec3 eye);

/// Whether at the eye most horizontal directions end at a surface.
bool isEnclosed(const KdTree& tree, const Mesh& mesh, const Axes& axes, Vec3 eye);

/// N x N places in the middle 80 % of the box's length and width. `n` is odd.
std::vector<Vec3> placesIn(const Box3& bounds, const Axes& axes, int n);

} // namespace rtcore
