/// The triangles of a scene near the player, found in the same kd-tree that rays use.
#pragma once

#include "rtcore/accel/kd_tree.h"
#include "rtcore/kernels/ray_wave.h"
#include "rtcore/math/vec.h"
#include "rtcore/motion/world_frame.h"
#include "rtcore/scene/mesh.h"

#include <cstdint>
#include <span>
#include <vector>

namespace rtcore {

/// In metres, z up.
struct Box3d {
    Vec3d lo, hi;
    Box3d grown(double by) const { return {lo - Vec3d{by, by, by}, hi + Vec3d{by, by, by}}; }
    Box3d grown(Vec3d by) const { return {lo - by, hi + by}; }
    bool contains(const Box3d& b) const {
        return lo.x <= b.lo.x && lo.y <= b.lo.y && lo.z <= b.lo.z && hi.x >= b.hi.x && hi.y >= b.hi.y &&
               hi.z >= b.hi.z;
    }
    bool overlaps(const Box3d& b) const {
        return lo.x <= b.hi.x && lo.y <= b.hi.y && lo.z <= b.hi.z && hi.x >= b.lo.x && hi.y >= b.lo.y &&
               hi.z >= b.lo.z;
    }
};

struct SolidTriangle {
    Vec3d a, b, c;
    Box3d box;
    std::uint32_t number = kNoTriangle; ///< of the mesh; kNoTriangle: none of it
};

SolidTriangle solidTriangle(Vec3d a, Vec3d b, Vec3d c);

/// Indices of all triangles that reach into `box` (scene units) and possibly others near it, ascending, each
/// once.
void findTriangles(const KdTree& tree, const Box3& box, std::vector<std::uint32_t>& found);

/// Keeps what it found last for as long as it encloses what is asked for: a large list that serves for a
/// while and a small one out of it for a few steps. One thread.
class NearbyTriangles {
  public:
    /// `tree` and `mesh` must outlive it. The large list reaches `reserve` metres farther than what is asked
    /// for: much saves questions, little makes each cheaper.
    NearbyTriangles(const KdTree& tree, const Mesh& mesh, const WorldFrame& frame, double reserve = 0.5);

    /// At least all triangles that reach into `need` and whose corners are finite, in the order of their
    /// indices. Valid until the next call.
    std::span<const SolidTriangle> in(const Box3d& need);

    /// Another tree of the same mesh, or of a part of it; must outlive it.
    void useTree(const KdTree& tree) {
        tree_ = tree;
        known_ = close_ = {{1, 1, 1}, {-1, -1, -1}};
    }

  private:
    Box3 toScene(const Box3d& box) const;
    void find(const Box3d& box);

    KdTree tree_;
    Mesh mesh_;
    WorldFrame frame_;
    float rounding_; ///< scene units that coordinates of the tree may be off by
    double reserve_;
    bool dense_ = false; ///< where the reserve would bring too many
    Box3d known_{{1, 1, 1}, {-1, -1, -1}}, close_ = known_;
    std::vector<std::uint32_t> indices_;
    std::vector<SolidTriangle> found_;     ///< all that reach into known_
    std::vector<SolidTriangle> triangles_; ///< those of them that reach into close_
};

} // namespace rtcore
