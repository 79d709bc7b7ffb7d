/// All triangles of a mesh as obstacles to a player, looked through one by one: no tree, so that what tests
/// find does not depend on one.
#pragma once

#include "rtcore/motion/separation.h"
#include "rtcore/motion/world_frame.h"
#include "rtcore/scene/mesh.h"

#include <algorithm>
#include <cstdint>
#include <vector>

namespace test {

/// Metres, z up.
class Obstacles {
  public:
    Obstacles() = default;
    Obstacles(const rtcore::Mesh& mesh, const rtcore::WorldFrame& frame) {
        for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) {
            rtcore::Vec3d p[3];
            for (int corner = 0; corner < 3; ++corner) p[corner] = frame.toMetres(mesh.position(i, corner));
            triangles_.push_back({p[0], p[1], p[2], boxOf(p[0], p[1], p[2])});
        }
    }

    /// Those that reach into `box`.
    Obstacles within(const rtcore::Box3d& box) const {
        Obstacles some;
        for (const rtcore::SolidTriangle& t : triangles_) {
            if (t.box.overlaps(box)) some.triangles_.push_back(t);
        }
        return some;
    }

    /// The least distance of a triangle from `line`; at most `max`.
    double clearance(const rtcore::UprightLine& line, double max) const {
        const rtcore::Box3d near =
            rtcore::Box3d{line.foot, line.foot + rtcore::Vec3d{0, 0, line.height}}.grown(max);
        double min = max;
        for (const rtcore::SolidTriangle& t : triangles_) {
            if (t.box.overlaps(near)) min = std::min(min, separate(line, t).distance);
        }
        return min;
    }

    /// The same while the line moves straight to `foot`, to within `error`: in steps in which no distance can
    /// fall by more than that.
    double clearanceOnTheWay(rtcore::UprightLine line, rtcore::Vec3d foot, double max, double error) const {
        const rtcore::Vec3d from = line.foot, way = foot - from;
        const double whole = length(way);
        const rtcore::Box3d swept =
            rtcore::Box3d{minOf(from, foot), maxOf(from, foot) + rtcore::Vec3d{0, 0, line.height}}.grown(max);
        double result = max;
        for (const rtcore::SolidTriangle& t : triangles_) {
            if (!t.box.overlaps(swept)) continue;
            for (double gone = 0; gone <= whole;) {
                line.foot = whole > 0 ? from + way * (gone / whole) : from;
                const double distance = separate(line, t).distance;
                result = std::min(result, distance);
                gone += std::max(distance - result, 0.0) + error;
            }
        }
        return result;
    }

  private:
    static rtcore::Vec3d minOf(rtcore::Vec3d a, rtcore::Vec3d b) {
        return {std::min(a.x, b.x), std::min(a.y, b.y), std::min(a.z, b.z)};
    }
    static rtcore::Vec3d maxOf(rtcore::Vec3d a, rtcore::Vec3d b) {
        return {std::max(a.x, b.x), std::max(a.y, b.y), std::max(a.z, b.z)};
    }
    static rtcore::Box3d boxOf(rtcore::Vec3d a, rtcore::Vec3d b, rtcore::Vec3d c) {
        return {minOf(minOf(a, b), c), maxOf(maxOf(a, b), c)};
    }

    std::vector<rtcore::SolidTriangle> triangles_;
};

} // namespace test
