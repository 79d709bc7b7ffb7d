/// The player's capsule among the triangles around it.
#pragma once

#include "rtcore/motion/nearby_triangles.h"
#include "rtcore/motion/sweep.h"
#include "rtcore/motion/walk_shape.h"

#include <optional>
#include <span>
#include <vector>

namespace rtcore {

/// Positions are of the feet: the hard capsule reaches from `skin` above them to `skin` below the crown.
/// Holds views; lives for one step.
class Body {
  public:
    Body(std::span<const SolidTriangle> triangles, const WalkShape& shape, double height)
        : triangles_(triangles), shape_(&shape), height_(height) {}

    const WalkShape& shape() const { return *shape_; }
    double reach() const { return shape_->radius + shape_->skin; }
    /// The middle of the lower sphere.
    Vec3d lowCentre(Vec3d feet) const { return feet + Vec3d{0, 0, reach()}; }
    UprightLine core(Vec3d feet) const;
    Box3d box(Vec3d feet) const;

    Sweep sweep(Vec3d feet, Vec3d direction, double distance) const;
    /// The triangle nearest to the core, if one is within the reach of the capsule and its skin.
    std::optional<Separation> nearest(Vec3d feet) const;
    /// Nothing is inside the hard capsule.
    bool isFree(Vec3d feet) const;
    /// All that the skin touches at `feet`, or nearly; the nearest first.
    std::vector<Separation> contacts(Vec3d feet) const;
    /// The face hit first straight down from `from` within `distance`: its height and whether it can be
    /// walked on.
    struct Floor {
        double z = 0;
        bool walkable = false;
    };
    std::optional<Floor> floorBelow(Vec3d from, double distance) const;

  private:
    std::span<const SolidTriangle> triangles_;
    const WalkShape* shape_;
    double height_;
};

} // namespace rtcore
