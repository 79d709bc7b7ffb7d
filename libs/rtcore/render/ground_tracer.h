/// Rays that meet the ground of a scene beside its surfaces.
#pragma once

#include "rtcore/kernels/ray_tracer.h"
#include "rtcore/scene/scene.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace rtcore {

/// Which rays meet the ground.
enum class GroundRole : std::uint8_t {
    Seen,     ///< those of the camera, mirrored and refracted ones
    Mirrored, ///< mirrored ones alone: it is a part of a background that is hidden
    Catcher   ///< those of the camera, which meet nothing else: to see what shadows fall on it
};

/// Traces the scene's surfaces with another tracer, and the scene's ground where that is nearer. Rays towards
/// lights and surroundings pass the ground: the sky's own ground is the same below it, and brings its light
/// to what stands on it.
class GroundTracer final : public RayTracer {
  public:
    GroundTracer(std::shared_ptr<const RayTracer> surfaces, std::shared_ptr<const SkyGround> ground,
                 GroundRole role = GroundRole::Seen);

    void intersect(RayKind kind, const RayWave& rays, HitWave& hits) const override;
    void intersectSeen(const RayWave& rays, HitWave& hits) const override {
        surfaces_->intersectSeen(rays, hits);
    }
    void occluded(RayKind kind, const RayWave& rays, std::vector<std::uint8_t>& occluded) const override;
    void findObstacles(const RayWave& rays, std::span<const std::uint8_t> clear,
                       std::vector<Obstacle>& found) const override;
    Box3 bounds() const override { return surfaces_->bounds(); }

  private:
    bool meets(RayKind kind) const;

    std::shared_ptr<const RayTracer> surfaces_;
    std::shared_ptr<const SkyGround> ground_;
    std::uint32_t first_; ///< triangle of the ground
    GroundRole role_;
};

/// Hits of a wave of so many rays that meet nothing.
void missAll(std::size_t count, HitWave& hits);

/// The tracer of the scene as it is shown: `surfaces` itself where it shows no ground.
std::shared_ptr<const RayTracer> withGround(std::shared_ptr<const RayTracer> surfaces, const Scene& scene,
                                            GroundRole role = GroundRole::Seen);

} // namespace rtcore
