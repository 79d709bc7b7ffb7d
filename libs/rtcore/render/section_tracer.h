/// Rays of a scene that planes cut open.
#pragma once

#include "rtcore/kernels/ray_tracer.h"
#include "rtcore/kernels/section_clip.h"
#include "rtcore/scene/scene.h"

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace rtcore {

/// Traces clipped rays with another tracer. Where light is whole, rays of the kinds Shadow, Occlusion and
/// Scattered pass it as they are; PathIntegrator clips those of a path that has not scattered.
class SectionTracer final : public RayTracer {
  public:
    SectionTracer(std::shared_ptr<const RayTracer> surfaces, const SectionPlanes& sections);

    void intersect(RayKind kind, const RayWave& rays, HitWave& hits) const override;
    void occluded(RayKind kind, const RayWave& rays, std::vector<std::uint8_t>& occluded) const override;
    void findObstacles(const RayWave& rays, std::span<const std::uint8_t> clear,
                       std::vector<Obstacle>& found) const override;
    /// Of the whole model.
    Box3 bounds() const override { return surfaces_->bounds(); }

  private:
    bool clips(RayKind kind) const;

    std::shared_ptr<const RayTracer> surfaces_;
    SectionClip clip_;
    bool all_; ///< rays of any kind
};

/// The tracer of the scene's surfaces as its sections leave them: `surfaces` itself where none cuts them.
std::shared_ptr<const RayTracer> withSections(std::shared_ptr<const RayTracer> surfaces, const Scene& scene);

} // namespace rtcore
