/// The one small interface between shading and the kernels: trace these rays, of this kind.
#pragma once

#include "rtcore/accel/kd_tree.h"
#include "rtcore/accel/uninitialized_array.h"
#include "rtcore/kernels/kernel_scene.h"
#include "rtcore/kernels/narrow_triangles.h"
#include "rtcore/kernels/ray_wave.h"
#include "rtcore/math/half_space.h"
#include "rtcore/scene/mesh.h"

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace rtcore {

/// The obstacle that a shadow ray meets.
enum class Obstacle : std::uint8_t {
    None,
    Opaque, ///< at least one triangle of a material that lets no light through
    Unknown ///< nothing opaque is known: perhaps triangles that let light through, one behind the other
};

struct RaySpan;

/// Answers whole waves. Safe from many threads, each with waves of its own.
class RayTracer {
  public:
    virtual ~RayTracer() = default;

    /// Closest hit of each ray in [tMin, tMax]; of several on one surface (one_surface.h) the triangle with
    /// the lowest index. Resizes `hits`.
    virtual void intersect(RayKind kind, const RayWave& rays, HitWave& hits) const = 0;
    /// The same for rays of the kind Scattered that no surface has scattered yet, as those in mirrors:
    /// sections cut them, too, where they cut for the camera alone. This implementation knows none.
    virtual void intersectSeen(const RayWave& rays, HitWave& hits) const {
        intersect(RayKind::Scattered, rays, hits);
    }
    /// 1 for each ray that hits anything in [tMin, tMax], else 0. Resizes `occluded`.
    virtual void occluded(RayKind kind, const RayWave& rays, std::vector<std::uint8_t>& occluded) const = 0;
    /// The obstacle to each ray in [tMin, tMax]; `clear` has an element for each material, not 0 where light
    /// may pass. Resizes `found`. This implementation finds all Unknown.
    virtual void findObstacles(const RayWave& rays, std::span<const std::uint8_t> clear,
                               std::vector<Obstacle>& found) const;
    /// Bounds of all that rays may hit.
    virtual Box3 bounds() const = 0;

    /// A tracer of the same surfaces without these triangles, for as long as this one; `left` has one value
    /// for each, not 0: it is left out. This implementation has none: null.
    virtual std::shared_ptr<const RayTracer> without(std::span<const std::uint8_t> left) const;

    /// A tracer of what all of these leave of the same surfaces, for as long as this one. This implementation
    /// has none: null.
    virtual std::shared_ptr<const RayTracer> within(std::span<const HalfSpace> halves) const;
};

/// How leaves find the corners of their triangles.
enum class LeafRecords {
    Shared, ///< through the mesh's own vertices: no memory of their own
    Inline  ///< through copies in the order of the leaves (leaf_records.h): 40 bytes a reference, faster
};

/// Inline, unless that takes more than a gigabyte, or `expectedRays` (0 = not known) are so few that making
/// the copies would take longer than they save.
LeafRecords chooseLeafRecords(const KdTree& tree, std::uint64_t expectedRays);

/// By the kd-tree, in packets and streams. What is found does not depend on how: not on the instruction set,
/// not on what else is in the wave. `tree` and the arrays behind `mesh` must outlive it. Each thread that
/// calls it keeps some MB until it ends.
class KdRayTracer final : public RayTracer {
  public:
    KdRayTracer(const KdTree& tree, const Mesh& mesh, LeafRecords records = LeafRecords::Inline);
    /// At once: by a tree of a part of what `whole` has, with LeafRecords::Shared. `whole` may go.
    KdRayTracer(const KdTree& tree, const KdRayTracer& whole);

    void intersect(RayKind kind, const RayWave& rays, HitWave& hits) const override;
    void occluded(RayKind kind, const RayWave& rays, std::vector<std::uint8_t>& occluded) const override;
    /// Unknown only where a ray passes triangles that let light through, and meets no other.
    void findObstacles(const RayWave& rays, std::span<const std::uint8_t> clear,
                       std::vector<Obstacle>& found) const override;
    Box3 bounds() const override { return tree_.bounds; }
    /// At once, with LeafRecords::Shared.
    std::shared_ptr<const RayTracer> without(std::span<const std::uint8_t> left) const override;
    /// At once: rays are clipped to their intervals within all of these, and walk treeWithin(); all but its
    /// nodes is shared.
    std::shared_ptr<const RayTracer> within(std::span<const HalfSpace> halves) const override;

    /// From now on rays hit only what `filter` keeps, whose arrays and holes must outlive that. Not while
    /// other threads trace.
    void setFilter(const CandidateFilter& filter) { scene_.filter = filter; }

    /// Bytes of the tree and of all that is kept beside it and the mesh.
    std::size_t memory() const;

  private:
    /// Of the triangles in leaves.
    struct Leaves {
        NarrowTriangles narrow;
        UninitializedArray<float> records;
    };

    static std::shared_ptr<const Leaves> makeLeaves(const KdTree& tree, const Mesh& mesh,
                                                    NarrowTriangles narrow, LeafRecords records);
    KdRayTracer(const KdTree& tree, const Mesh& mesh, NarrowTriangles narrow, LeafRecords records);
    KdRayTracer(const KdTree& tree, const Mesh& mesh, std::shared_ptr<const Leaves> leaves);
    /// Settles the hits with these indices, which have kTiedHit.
    void settleTies(const RaySpan& rays, std::span<const std::uint32_t> tied, HitWave& hits) const;

    KdTree tree_;
    Mesh mesh_;
    std::shared_ptr<const Leaves> leaves_;
    KernelScene scene_;
    std::vector<HalfSpace> halves_; ///< what of surfaces lies beyond any of these is not hit
    float nearLimit_;
};

} // namespace rtcore
