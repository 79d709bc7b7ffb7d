/// The light of the sky: what reaches the points of a wave from the environment, or from the background where
/// there is none. A ray that escapes the scene brings the radiance of its own direction
/// (scene/environment_light.h), tinted by the panes and dimmed by the fog on its way. A ray that ends at a
/// surface brings nothing, or, with ambient occlusion, that of ambient light which the distance leaves: what
/// the surfaces of a room send to each other.
#pragma once

#include "rtcore/kernels/ray_tracer.h"
#include "rtcore/lights/ambient_light.h"
#include "rtcore/scene/scene.h"
#include "rtcore/shading/light/arriving_light.h"
#include "rtcore/shading/light/hemisphere_wave.h"
#include "rtcore/shading/light/shadows.h"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace rtcore {

class SkyWave final : public HemisphereWave {
  public:
    /// Starts a frame, during which the arguments must live. `fog`: null where there is none.
    void begin(const Scene& scene, const RayTracer& tracer, const RenderSettings& settings,
               const MaterialTable& materials, const FogMedium* fog);

    Colour unoccluded(const SurfaceWave& surfaces, std::size_t point) const override {
        return scattered(surfaces, point) * sky_.light->open(surfaces.shadingNormal.at(point)) * sky_.scale;
    }

  private:
    void start(std::size_t points) override;
    void gather(std::size_t directions, RayStatistics& statistics) override;
    void finish(std::span<const Point> points, std::size_t directions, SurfaceWave& surfaces) override;

    template <typename Ending>
    void addAround(Ending ending);
    Colour arriving(std::size_t i, std::size_t directions, Vec3 normal) const;

    SkySource sky_;
    ShadowTracer obstacles_;
    const RayTracer* tracer_ = nullptr;
    std::optional<OccludedLight> around_; ///< with ambient occlusion
    std::size_t points_ = 0;
    WaveMemory memory_;
    SkySums sums_;
    HitWave hits_;
    std::vector<std::uint8_t> ended_; ///< for each ray
    std::vector<float> near_;         ///< sums of how far rays went that hit something: 0 at once, 1 far away
};

} // namespace rtcore
