/// Shadows of a whole wave of rays towards one light: black, or tinted by what lets light through.
#pragma once

#include "rtcore/kernels/ray_statistics.h"
#include "rtcore/kernels/ray_tracer.h"
#include "rtcore/scene/scene.h"
#include "rtcore/shading/surface.h"

#include <vector>

namespace rtcore {

/// Reuses its memory from wave to wave; one for each thread. `scene` and `tracer` must outlive it.
class ShadowTracer {
  public:
    ShadowTracer(const Scene& scene, const RayTracer& tracer, bool textures, bool refractions);

    /// For each ray (directions of unit length) the share of light that arrives along it: 1 unhindered, 0
    /// behind anything opaque. Transparent surfaces take (1 - Fresnel) of it and tint it; light goes straight
    /// on through them, without focusing. Valid until the next call.
    const std::vector<Colour>& transmittance(const RayWave& rays, RayStatistics& statistics);

  private:
    void tracePlain(const RayWave& rays, RayStatistics& statistics);
    void traceTinted(const RayWave& rays, RayStatistics& statistics);
    /// What one surface leaves of the light; the ray came from the surface before it, hit.t away.
    Colour throughSurface(const Surface& surface, const Hit& hit) const;

    const Scene& scene_;
    const RayTracer& tracer_;
    bool textures_, refractions_;
    bool tinted_; ///< something in the scene lets light through

    std::vector<Colour> transmittance_;
    std::vector<std::uint8_t> occluded_;
    HitWave hits_;
    RayWave current_, next_;
    std::vector<std::uint32_t> currentIndex_, nextIndex_;
};

} // namespace rtcore
