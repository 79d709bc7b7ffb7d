/// Ambient occlusion (thesis 7.1.5): the ambient light at the points of a wave, as far as what is near lets
/// it pass.
#pragma once

#include "rtcore/kernels/ray_tracer.h"
#include "rtcore/lights/ambient_light.h"
#include "rtcore/scene/scene.h"
#include "rtcore/shading/light/hemisphere_wave.h"

#include <cstdint>
#include <span>
#include <vector>

namespace rtcore {

class OcclusionWave final : public HemisphereWave {
  public:
    /// Starts a frame, during which the arguments must live.
    void begin(const Scene& scene, const RayTracer& tracer, const RenderSettings& settings,
               const MaterialTable& materials);

    Colour unoccluded(const SurfaceWave& surfaces, std::size_t point) const override {
        return scattered(surfaces, point) * light_.radiance;
    }

  private:
    /// Rays that go on behind holes and glass.
    struct SeeingRays {
        RayWave rays; ///< empty for those that leave the points: the others' are all of them
        std::vector<std::uint32_t> point;
        std::vector<float> weight,
            travelled; ///< of the ray, after what it has passed; the distance that it has come

        std::size_t size() const { return point.size(); }
        bool empty() const { return point.empty(); }
        void start(std::size_t count, std::size_t points);
        void clear();
        void push(const Ray& ray, std::uint32_t ofPoint, float itsWeight, float soFar);
    };

    void start(std::size_t points) override;
    void gather(std::size_t directions, RayStatistics& statistics) override;
    void finish(std::span<const Point> points, std::size_t directions, SurfaceWave& surfaces) override;
    void sumSeeThrough(RayStatistics& statistics);
    void sumHit(const RayWave& rays, std::size_t i);

    const Scene* scene_ = nullptr;
    const RayTracer* tracer_ = nullptr;
    bool textures_ = true, refractions_ = true;
    OccludedLight light_;

    std::vector<float> visible_; ///< of each point: the sum of what its rays let pass
    HitWave hits_;
    SeeingRays current_, next_;
};

} // namespace rtcore
