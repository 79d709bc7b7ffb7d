/// The one small interface between shading and the kernels: trace these rays, of this kind.
#pragma once

#include "rtcore/accel/kd_tree.h"
#include "rtcore/kernels/ray_wave.h"
#include "rtcore/scene/mesh.h"

#include <cstdint>
#include <vector>

namespace rtcore {

/// Answers whole waves. Safe from many threads, each with waves of its own.
class RayTracer {
  public:
    virtual ~RayTracer() = default;

    /// Closest hit of each ray in [tMin, tMax]; at equal distance the triangle with the lower index. Resizes
    /// `hits`.
    virtual void intersect(RayKind kind, const RayWave& rays, HitWave& hits) const = 0;
    /// 1 for each ray that hits anything in [tMin, tMax], else 0. Resizes `occluded`.
    virtual void occluded(RayKind kind, const RayWave& rays, std::vector<std::uint8_t>& occluded) const = 0;
};

/// By the kd-tree. `tree` and the arrays behind `mesh` must outlive it.
class KdRayTracer final : public RayTracer {
  public:
    KdRayTracer(const KdTree& tree, const Mesh& mesh) : tree_(tree), mesh_(mesh) {}

    void intersect(RayKind kind, const RayWave& rays, HitWave& hits) const override;
    void occluded(RayKind kind, const RayWave& rays, std::vector<std::uint8_t>& occluded) const override;

  private:
    KdTree tree_;
    Mesh mesh_;
};

} // namespace rtcore
