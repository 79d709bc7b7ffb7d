/// Ambient occlusion (thesis 7.1.5): the ambient light at the points of a wave, as far as what is near lets
/// it pass.
#pragma once

#include "rtcore/kernels/ray_statistics.h"
#include "rtcore/kernels/ray_tracer.h"
#include "rtcore/kernels/wave_memory.h"
#include "rtcore/lights/ambient_light.h"
#include "rtcore/sampling/hemisphere_pattern.h"
#include "rtcore/scene/scene.h"
#include "rtcore/settings/render_settings.h"
#include "rtcore/shading/light/occlusion_rays.h"
#include "rtcore/shading/surface/material_table.h"
#include "rtcore/shading/surface/surface_wave.h"

#include <array>
#include <atomic>
#include <cstdint>
#include <span>
#include <vector>

namespace rtcore {

/// One for each thread; keeps its memory. What a point gets depends on nothing but the point and its name.
class OcclusionWave {
  public:
    /// Starts a frame, during which the arguments must live.
    void begin(const Scene& scene, const RayTracer& tracer, const RenderSettings& settings,
               const MaterialTable& materials);
    bool on() const { return on_; }

    /// Whether ambient light can contribute at a point.
    bool takes(const SurfaceWave& surfaces, std::size_t point) const;
    /// The ambient light of the point in its sample without occlusion.
    Colour unoccluded(const SurfaceWave& surfaces, std::size_t point) const {
        return scattered(surfaces, point) * light_.radiance;
    }
    /// Has a point lit by the next light(). `bounce` differs where a path meets points one after another.
    void add(const SurfaceWave& surfaces, std::size_t point, SampleId sample, std::uint32_t bounce);
    /// Sets surfaces.added to the contribution of ambient light to the samples: zero at points that were
    /// not added. Forgets the points. Returns soon, with `added` undefined, when `stop` (may be null) becomes
    /// true.
    void light(SurfaceWave& surfaces, RayStatistics& statistics, const std::atomic<bool>* stop);

  private:
    /// A point that waits, and where its pattern is turned to.
    struct Point {
        std::uint32_t index; ///< of the surface wave
        SquarePoint shift;   ///< u: along the width of a ring, v: of the azimuths
        std::uint32_t name;  ///< Random: what its directions are drawn by
    };
    /// Rays that go on behind holes and glass.
    struct SeeingRays {
        RayWave rays; ///< empty for those that leave the points: the others' are all of them
        std::vector<std::uint32_t> point; ///< of the frames
        std::vector<float> weight,
            travelled; ///< of the ray, after what it has passed; the distance that it has come

        std::size_t size() const { return point.size(); }
        bool empty() const { return point.empty(); }
        void start(std::size_t count, std::size_t points);
        void clear();
        void push(const Ray& ray, std::uint32_t ofPoint, float itsWeight, float soFar);
    };
    /// Points of similar weight in the image get the same number of rays.
    static constexpr int kClasses = 3;

    void trace(const std::vector<Point>& points, const std::vector<HemispherePoint>& pattern,
               SurfaceWave& surfaces, RayStatistics& statistics, const std::atomic<bool>* stop);
    void place(std::span<const Point> points, float ring, const SurfaceWave& surfaces);
    void aim(std::span<const Point> points, std::span<const HemispherePoint> pattern, std::size_t first);
    void draw(std::span<const Point> points, std::uint32_t ray);
    void sumSeeThrough(RayStatistics& statistics);
    void sumHit(const RayWave& rays, std::size_t i);
    Colour scattered(const SurfaceWave& surfaces, std::size_t point) const;

    const Scene* scene_ = nullptr;
    const RayTracer* tracer_ = nullptr;
    const MaterialTable* materials_ = nullptr;
    bool on_ = false, textures_ = true, refractions_ = true;
    OcclusionPattern kind_ = OcclusionPattern::Rotated;
    OccludedLight light_;
    std::array<std::vector<HemispherePoint>, kClasses> patterns_;
    std::array<std::vector<Point>, kClasses> points_;

    WaveMemory memory_;
    OcclusionFrames frames_;
    RayWave rays_;
    HitWave hits_;
    std::vector<HemispherePoint> drawn_;
    SeeingRays current_, next_;
};

} // namespace rtcore
