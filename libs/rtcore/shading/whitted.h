/// Whitted's ray tracing (1980), wave by wave: all rays of one kind are traced at once, what they hit is lit
/// by one light after another, and the rays that follow wait in queues. Nothing recurses.
#pragma once

#include "rtcore/kernels/ray_statistics.h"
#include "rtcore/kernels/ray_tracer.h"
#include "rtcore/scene/scene.h"
#include "rtcore/settings/render_settings.h"
#include "rtcore/shading/path_queue.h"
#include "rtcore/shading/shadows.h"
#include "rtcore/shading/surface.h"
#include "rtcore/shading/surface_split.h"

#include <atomic>
#include <span>
#include <vector>

namespace rtcore {

/// One for each thread; reuses its memory from wave to wave. The arguments must outlive it.
/// The result for a wave depends on nothing but the wave.
class WhittedIntegrator {
  public:
    WhittedIntegrator(const Scene& scene, const RayTracer& tracer, const RenderSettings& settings);

    /// Radiance along each primary ray (directions of unit length), and 1 where it hits something, else 0.
    /// The spans have the size of the wave.
    void trace(const RayWave& primary, std::span<Colour> radiance, std::span<std::uint8_t> hit);

    /// Becomes true: trace() returns soon, with radiance undefined. May be null.
    void stopWhen(const std::atomic<bool>* flag) { stop_ = flag; }

    /// All rays since construction.
    const RayStatistics& statistics() const { return statistics_; }

  private:
    struct Point {
        Surface surface;
        SurfaceSplit split;
        Path path;
    };

    void traceWave(RayKind kind);
    void addBackground(const Path& path, Vec3 direction);
    void addPoint(const Ray& ray, const Hit& hit, Path path);
    void passThroughHole(const Ray& ray, const Surface& surface, Path path);
    void addGlow(const Point& point);
    void addLight(const Light& light);
    void spawnMirrored(const Point& point);
    void spawnTransmitted(const Point& point);
    bool matters(Colour weight) const;
    bool stopped() const { return stop_ != nullptr && stop_->load(std::memory_order_relaxed); }

    const Scene& scene_;
    const RayTracer& tracer_;
    const RenderSettings& settings_;
    ShadowTracer shadows_;
    RayStatistics statistics_;
    const std::atomic<bool>* stop_ = nullptr;

    std::span<Colour> radiance_;
    std::span<std::uint8_t> hit_;
    PathQueue wave_; ///< being traced
    PathQueue mirrored_, refracted_;
    HitWave hits_;
    std::vector<Point> points_;
    RayWave shadowRays_;
    std::vector<Colour> unshadowed_; ///< what each shadow ray's light would add
    std::vector<std::uint32_t> unshadowedSample_;
};

} // namespace rtcore
