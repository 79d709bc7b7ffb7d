/// Rays of a scene that planes cut open.
#pragma once

#include "rtcore/kernels/ray_tracer.h"
#include "rtcore/scene/scene.h"

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace rtcore {

/// Traces with the tracer of what sections leave of surfaces (RayTracer::within()), and with one of surfaces
/// that they leave whole, if any. Where light is whole, rays of the kinds Shadow, Occlusion and Scattered
/// meet all of the surfaces, but for intersectSeen().
class SectionTracer final : public RayTracer {
  public:
    /// `surfaces` has a tracer within() half-spaces; `uncut` may be null.
    SectionTracer(std::shared_ptr<const RayTracer> surfaces, const SectionPlanes& sections,
                  std::shared_ptr<const RayTracer> uncut);

    void intersect(RayKind kind, const RayWave& rays, HitWave& hits) const override;
    void intersectSeen(const RayWave& rays, HitWave& hits) const override;
    void occluded(RayKind kind, const RayWave& rays, std::vector<std::uint8_t>& occluded) const override;
    void findObstacles(const RayWave& rays, std::span<const std::uint8_t> clear,
                       std::vector<Obstacle>& found) const override;
    /// Of the whole model.
    Box3 bounds() const override { return surfaces_->bounds(); }

  private:
    bool meetsLeft(RayKind kind) const;
    void intersectLeft(RayKind kind, const RayWave& rays, HitWave& hits) const;

    std::shared_ptr<const RayTracer> surfaces_, left_, uncut_;
    bool all_; ///< rays of any kind meet what is left
};

/// The surfaces that sections leave whole, by a tree of their own, which is kept until others are asked for.
/// One thread at a time.
class UncutSurfaces {
  public:
    /// Of the scene's parts; null where all may be cut.
    std::shared_ptr<const RayTracer> of(const std::shared_ptr<const RayTracer>& surfaces, const Scene& scene);
    void forget() { *this = {}; }

  private:
    std::shared_ptr<const RayTracer> surfaces_, uncut_;
    PartSet parts_;
};

/// The tracer of the scene's surfaces as its sections leave them: `surfaces` itself where none cuts them.
/// `uncut`: what is known of scenes before.
std::shared_ptr<const RayTracer> withSections(std::shared_ptr<const RayTracer> surfaces, const Scene& scene,
                                              UncutSurfaces& uncut);

} // namespace rtcore
