/// The surroundings of a walker: triangles that a step may touch, and the floor below a scene.
#pragma once

#include "rtcore/motion/body.h"
#include "rtcore/motion/cut_surroundings.h"
#include "rtcore/motion/nearby_triangles.h"
#include "rtcore/motion/walk_shape.h"
#include "rtcore/motion/walk_state.h"

#include <span>
#include <vector>

namespace rtcore {

/// Metres around what a step may touch.
inline constexpr double kStepMargin = 0.1;

/// One thread.
class WalkSurroundings {
  public:
    /// `tree`, `mesh` and `shape` must outlive it.
    WalkSurroundings(const KdTree& tree, const Mesh& mesh, const WorldFrame& frame, const WalkShape& shape);

    /// Another tree of the same mesh, or of a part of it; must outlive it.
    void useTree(const KdTree& tree);
    /// What they take away counts from the next gather() on; `uncut` as CutSurroundings has it.
    void useSections(std::span<const SectionPlane> planes, std::span<const std::uint8_t> uncut);

    /// Finds the triangles that a body with this state may touch while it goes at most `move` metres.
    void gather(const WalkState& state, double move);
    /// Found by gather(); valid until it is called again.
    std::span<const SolidTriangle> triangles() const { return triangles_; }
    /// A body of that height among them.
    Body body(double height) const { return {triangles_, shape_, height}; }
    /// One with room to rise from where it is to `top`, where it may climb a ledge.
    Body climber(const WalkState& state, double top);

    /// Nothing is between the two.
    bool sees(Vec3d from, Vec3d to) const;
    /// Something is under the body of an eye.
    bool anythingBelow(Vec3d eye) const;
    /// Height of the scene's lowest point, metres.
    double lowest() const { return lowest_; }

    /// A floor at the lowest point that is not seen: counts from the next gather() on.
    void haveUnseenFloor(bool there) { unseenFloor_ = there; }
    bool hasUnseenFloor() const { return unseenFloor_; }

  private:
    /// What is left of them; the same ones where nothing is cut.
    std::span<const SolidTriangle> leftOf(std::span<const SolidTriangle> triangles, Vec3d feet,
                                          std::vector<SolidTriangle>& left) const;
    std::span<const SolidTriangle> withUnseenFloor(std::span<const SolidTriangle> triangles,
                                                   const Box3d& box);

    KdTree tree_;
    Mesh mesh_;
    WorldFrame frame_;
    const WalkShape& shape_;
    NearbyTriangles nearby_, nearLedge_;
    CutSurroundings cut_;
    std::vector<SolidTriangle> left_, leftAtLedge_;
    std::span<const SolidTriangle> triangles_;
    double lowest_;
    bool unseenFloor_ = false;
    std::vector<SolidTriangle> withFloor_; ///< triangles_, where it is among them
};

} // namespace rtcore
