/// Surroundings of a body in a model that sections cut open.
#pragma once

#include "rtcore/motion/nearby_triangles.h"
#include "rtcore/motion/world_frame.h"
#include "rtcore/scene/section_planes.h"

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace rtcore {

/// One walks through a wall that is taken away, and does not fall through a floor that is. Immutable.
class CutSurroundings {
  public:
    CutSurroundings() = default;
    /// Planes lie `further` out, scene units, as those of rays do (SectionClip): faces in them stay. `uncut`
    /// has a value for each triangle of the mesh that is not 0 where it stays whole, or is empty. `walkable`:
    /// cosine of the steepest floor.
    CutSurroundings(std::span<const SectionPlane> planes, std::span<const std::uint8_t> uncut,
                    const WorldFrame& frame, double further, double walkable);

    /// Nothing is cut.
    bool empty() const { return halves_.empty(); }
    /// There are triangles that stay whole.
    bool leavesParts() const { return !uncut_.empty(); }

    /// Adds to `left` what the body of a walker with its feet there meets of the triangle: all of it where it
    /// is a floor that is not higher, there, than `step` above the feet; else the part that no section takes
    /// away.
    void cut(const SolidTriangle& triangle, Vec3d feet, double step, std::vector<SolidTriangle>& left) const;

    /// From where to where a line from `a` to `b` is in what is left, 0 at `a`, 1 at `b`; empty where the
    /// first is not below the second.
    std::pair<double, double> kept(Vec3d a, Vec3d b) const;

  private:
    /// dot(normal, x) <= offset is kept; metres.
    struct Half {
        Vec3d normal;
        double offset;
        double above(Vec3d p) const { return dot(normal, p) - offset; }
    };

    bool isUncut(const SolidTriangle& triangle) const {
        return triangle.number < uncut_.size() && uncut_[triangle.number] != 0;
    }

    std::vector<Half> halves_;
    std::vector<std::uint8_t> uncut_;
    double walkable_ = 0;
};

} // namespace rtcore
