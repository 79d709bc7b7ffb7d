/// Fog along a whole wave of rays: what it leaves of the light that they meet, what it adds to them, and what
/// it leaves of the light of lamps. Vector code; the formulas are those of fog.h.
#pragma once

#include "rtcore/kernels/ray_wave.h"
#include "rtcore/scene/light.h"
#include "rtcore/shading/fog.h"
#include "rtcore/shading/path_queue.h"
#include "rtcore/shading/surface_wave.h"
#include "rtcore/shading/wave_memory.h"

#include <cstddef>
#include <cstdint>

namespace rtcore {

/// One for each thread; keeps its memory from wave to wave. Arrays have one element for each ray and room for
/// whole blocks of kWaveBlock.
class FogWave {
  public:
    /// Ready for waves of one frame.
    void begin(const FogMedium& medium) { medium_ = medium; }
    /// Where it is false, nothing else needs to be called.
    bool on() const { return medium_.on; }
    const FogMedium& medium() const { return medium_; }

    /// Takes the rays (directions of unit length) as far as `hits` and `traits` (0 = nothing hit) say.
    /// `bounces` is that of a PathQueue: rays inside a solid pass no fog; null: none is. Sets transmittance,
    /// and `scattered` to the fog's own light.
    void enter(const RayWave& rays, const HitWave& hits, const std::uint32_t* traits,
               const std::uint32_t* bounces);

    std::size_t size() const { return size_; }
    const float* transmittance() const { return transmittance_; } ///< 0..1
    /// Radiance that reaches the beginning of each ray from the fog on its way.
    const ArraysOf3& scattered() const { return scattered_; }

    /// share *= transmittance, where there is a point.
    void dimShares(SurfaceWave& surfaces) const;
    /// added *= what is left of the lamp's light at each point.
    void dimLight(const Light& light, SurfaceWave& surfaces) const;

    /// Adds the lamp's light, unshadowed, to `scattered`: single scattering, the same to all sides.
    ///
    /// Directional lamps in closed form. Others, from their middle, by the integral of density * e^-tau / r^2
    /// over the ray, where tau counts both ways; with t = tp + h sinh(q), h the lamp's distance from the ray
    /// and tp its foot, dt / r^2 = dq / r, which is smooth, by Gauss-Legendre quadrature on either side of tp
    /// (4 to 12 nodes each). h is at least the lamp's radius (half of what a rectangle measures), and 1e-4 of
    /// its distance. (Kulla and Fajardo 2012 have the same substitution but for the angle in place of q.)
    /// Rays that fall into ever thicker fog have a third stretch at their end. The error is below 1e-5 of
    /// density * integral, or of 1 where that is less.
    void addLight(const Light& light);

  private:
    friend class FogShafts;

    FogMedium medium_;
    std::size_t size_ = 0;
    WaveMemory memory_;
    ArraysOf3 origin_, direction_;
    float* distance_ = nullptr; ///< 0 of rays without fog
    float* from_ = nullptr;     ///< the stretch of the ray outside of which fog adds nothing that counts
    float* to_ = nullptr;
    float* transmittance_ = nullptr;
    ArraysOf3 scattered_;
};

} // namespace rtcore
