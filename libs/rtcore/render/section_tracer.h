/// Rays of a scene that planes cut open.
#pragma once

#include "rtcore/kernels/ray_tracer.h"
#include "rtcore/math/half_space.h"
#include "rtcore/scene/scene.h"

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace rtcore {

/// Traces with the tracer of what sections leave of surfaces, and with one of surfaces that they leave whole,
/// if any. Where light is whole, rays of the kinds Shadow, Occlusion and Scattered meet all of the surfaces,
/// but for intersectSeen().
class SectionTracer final : public RayTracer {
  public:
    /// `uncut` may be null. Throws std::invalid_argument where one of the others is.
    SectionTracer(std::shared_ptr<const RayTracer> surfaces, std::shared_ptr<const RayTracer> left,
                  std::shared_ptr<const RayTracer> uncut, SectionLight light);

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

/// One by one the same bits.
bool sameHalves(std::span<const HalfSpace> a, std::span<const HalfSpace> b);

/// The tracers that sections need of surfaces, each of which is kept until another one is asked for. One
/// thread at a time.
class SectionSurfaces {
  public:
    /// What half-spaces leave (RayTracer::within()).
    std::shared_ptr<const RayTracer> left(const std::shared_ptr<const RayTracer>& surfaces,
                                          std::span<const HalfSpace> halves);
    /// Another tracer of the same is kept in its place, such as one by a tree that was built of what is left
    /// (buildTreeWithin()).
    void useLeft(std::shared_ptr<const RayTracer> surfaces, std::span<const HalfSpace> halves,
                 std::shared_ptr<const RayTracer> left);
    /// What the sections of the scene leave whole, by a tree of its own; null where all may be cut.
    std::shared_ptr<const RayTracer> uncut(const std::shared_ptr<const RayTracer>& surfaces,
                                           const Scene& scene);
    void forget() { *this = {}; }

  private:
    std::shared_ptr<const RayTracer> cut_, left_; ///< the surfaces, and what is left of them
    std::vector<HalfSpace> halves_;
    std::shared_ptr<const RayTracer> surfaces_, uncut_;
    PartSet parts_;
};

/// The tracer of the scene's surfaces as its sections leave them: `surfaces` itself where none cuts them.
/// `known`: what is kept of scenes before.
std::shared_ptr<const RayTracer> withSections(std::shared_ptr<const RayTracer> surfaces, const Scene& scene,
                                              SectionSurfaces& known);

} // namespace rtcore
