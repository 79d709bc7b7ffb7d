/// Fog along a whole wave of rays: its transmittance, its in-scattering, and its transmittance towards
/// lights. Vector code; the formulas are those of fog_math-inl.h.
#pragma once

#include "rtcore/kernels/ray_wave.h"
#include "rtcore/kernels/wave_memory.h"
#include "rtcore/scene/light.h"
#include "rtcore/shading/fog/fog.h"
#include "rtcore/shading/paths/wave_paths.h"
#include "rtcore/shading/surface/surface_wave.h"

#include <cstddef>
#include <cstdint>

namespace rtcore {

/// The rays of a wave in fog, one element for each and room for whole blocks of kWaveBlock.
struct FogRays {
    std::size_t count = 0;
    ArraysOf3 origin, direction;
    float* distance = nullptr; ///< how far it goes through fog, scene units; 0 inside of solids
    float* from = nullptr;     ///< the stretch of the ray outside of which fog adds nothing noticeable
    float* to = nullptr;
    float* transmittance = nullptr; ///< 0..1
    ArraysOf3 scattered; ///< radiance that reaches the beginning of the ray from the fog on its way
};

/// One for each thread; keeps its memory from wave to wave.
class FogWave {
  public:
    /// Ready for waves of one frame.
    void begin(const FogMedium& medium) { medium_ = medium; }
    /// Where it is false, nothing else needs to be called.
    bool on() const { return medium_.on; }
    const FogMedium& medium() const { return medium_; }

    /// Takes the rays (directions of unit length) as far as `hits` and `traits` (0 = nothing hit) say; those
    /// whose path is inside a solid pass no fog. Sets `transmittance`, and `scattered` to the fog's own
    /// light.
    void enter(const RayWave& rays, const HitWave& hits, const std::uint32_t* traits, const WavePaths& paths);

    const FogRays& rays() const { return rays_; }

    /// weight *= transmittance, where there is a point.
    void dimWeights(SurfaceWave& surfaces) const;
    /// contribution *= what is left of one stratum in the whole light at each point.
    void dimLight(const Light& light, SurfaceWave& surfaces) const;

  private:
    FogMedium medium_;
    WaveMemory memory_;
    FogRays rays_;
};

} // namespace rtcore
