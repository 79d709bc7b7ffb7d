/// Light from all directions before the points of a wave, by rays with the density cos / pi. What the rays
/// bring is a matter of the classes that derive from this one: occlusion_wave.h, sky_wave.h.
#pragma once

#include "rtcore/kernels/ray_statistics.h"
#include "rtcore/kernels/wave_memory.h"
#include "rtcore/sampling/hemisphere_pattern.h"
#include "rtcore/settings/render_settings.h"
#include "rtcore/shading/light/hemisphere_rays.h"
#include "rtcore/shading/surface/material_table.h"
#include "rtcore/shading/surface/surface_wave.h"

#include <array>
#include <atomic>
#include <cstdint>
#include <span>
#include <vector>

namespace rtcore {

/// One for each thread; keeps its memory. What a point gets depends on nothing but the point and its name.
class HemisphereWave {
  public:
    virtual ~HemisphereWave() = default;

    bool on() const { return on_; }
    /// Whether such light can contribute at a point.
    bool takes(const SurfaceWave& surfaces, std::size_t point) const;
    /// The light of the point in its sample with nothing in the way.
    virtual Colour unoccluded(const SurfaceWave& surfaces, std::size_t point) const = 0;
    /// Has a point lit by the next light(). `bounce` differs where a path meets points one after another.
    void add(const SurfaceWave& surfaces, std::size_t point, SampleId sample, std::uint32_t bounce);
    /// Sets surfaces.contribution to the contribution of the light to the samples: zero at points that were
    /// not added. Forgets the points. Returns soon, with `added` undefined, when `stop` (may be null) becomes
    /// true.
    void light(SurfaceWave& surfaces, RayStatistics& statistics, const std::atomic<bool>* stop);

  protected:
    /// A point that waits, and where its pattern is turned to.
    struct Point {
        std::uint32_t index; ///< of the surface wave
        SquarePoint shift;   ///< u: along the width of a ring, v: of the azimuths
        std::uint32_t name;  ///< Random: names the random numbers of its directions
    };
    struct Rays {
        OcclusionPattern pattern;
        int count;   ///< of a point
        float reach; ///< scene units
    };

    /// Starts a frame, during which `materials` must live.
    void begin(const MaterialTable& materials, const Rays& rays);
    /// Starts a frame in which nothing is lit.
    void begin() { on_ = false; }

    /// So many points come together, whose sums are zero.
    virtual void start(std::size_t points) = 0;
    /// Adds to their sums what rays() bring: those of all points in one direction, then in the next; so many
    /// directions.
    virtual void gather(std::size_t directions, RayStatistics& statistics) = 0;
    /// Sets surfaces.contribution at the points: of so many directions, all are gathered.
    virtual void finish(std::span<const Point> points, std::size_t directions, SurfaceWave& surfaces) = 0;

    /// The fraction of such light at the point that reaches its sample.
    Colour scattered(const SurfaceWave& surfaces, std::size_t point) const;
    const MaterialTable& materials() const { return *materials_; }
    const RayWave& rays() const { return rays_; }

  private:
    /// Points of similar weight in the image get the same number of rays.
    static constexpr int kClasses = 3;

    void trace(const std::vector<Point>& points, const std::vector<HemispherePoint>& pattern,
               SurfaceWave& surfaces, RayStatistics& statistics, const std::atomic<bool>* stop);
    void place(std::span<const Point> points, float ring, const SurfaceWave& surfaces);
    void aim(std::span<const Point> points, std::span<const HemispherePoint> pattern, std::size_t first);
    void samplePoints(std::span<const Point> points, std::uint32_t ray);

    const MaterialTable* materials_ = nullptr;
    bool on_ = false;
    OcclusionPattern kind_ = OcclusionPattern::Rotated;
    float reach_ = 0;
    std::array<std::vector<HemispherePoint>, kClasses> patterns_;
    std::array<std::vector<Point>, kClasses> points_;

    WaveMemory memory_;
    HemisphereFrames frames_;
    RayWave rays_;
    std::vector<HemispherePoint> samples_;
};

} // namespace rtcore
