/// The irradiance of records by surfaces that emit, which their rays leave out.
#pragma once

#include "rtcore/gathering/gather_rays.h"
#include "rtcore/kernels/ray_statistics.h"
#include "rtcore/math/colour.h"
#include "rtcore/pathtracing/path_integrator.h"
#include "rtcore/shading/light/shadows.h"

#include <algorithm>
#include <memory>
#include <span>
#include <vector>

namespace rtcore {

/// The irradiance that a pass finds, and the sum of its directions, weighted by luminance.
struct PassLight {
    Colour irradiance;
    Vec3 vector;

    /// Adds radiance from a direction of unit length, times its projected solid angle; nothing where that is
    /// no number or beyond all light.
    void add(Colour radiance, Vec3 direction, float cosine, float projected) {
        constexpr float kMinCosine = 0.2F; // below, single rays would count too much
        constexpr float kMaxLight = 1e9F;
        const Colour light = radiance * projected;
        if (!(maxComponent(light) < kMaxLight) || !isFinite(light)) return;
        irradiance += light;
        vector += direction * (luminance(light) / std::max(cosine, kMinCosine));
    }
};

/// Keeps its memory, some KB for each thread.
class EmitterRays {
  public:
    /// Adds what some rays of each pass find that go to points of emitters, as next event does. The same bits
    /// for any number of threads.
    void add(const PathFrame& paths, std::span<const GatherPass> passes, int threads,
             std::span<PassLight> light);

  private:
    struct Worker {
        ShadowTracer shadows;
        RayStatistics statistics;
        RayWave rays;
        std::vector<Colour> radiance; ///< of each ray, times its projected solid angle
    };
    static void aim(const PathFrame& paths, const GatherPass& pass, Worker& worker);

    std::vector<std::unique_ptr<Worker>> workers_; ///< by thread
};

} // namespace rtcore
