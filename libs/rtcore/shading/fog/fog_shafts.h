/// Shafts of light: shadowed in-scattering of a light along rays through fog, by samples on each ray.
#pragma once

#include "rtcore/kernels/ray_wave.h"
#include "rtcore/math/colour.h"
#include "rtcore/scene/light.h"
#include "rtcore/shading/fog/fog_wave.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace rtcore {

/// Samples of one light on some rays of a wave, each with its shadow ray. One for
/// each thread; keeps its memory.
class FogShafts {
  public:
    /// So many rays of a wave at once, a multiple of kWaveBlock, keep the memory of `samples` samples each
    /// bounded.
    static std::size_t raysAtOnce(int samples);

    /// Some of the rays of a wave.
    struct Rays {
        std::size_t first, count; ///< first: a multiple of kWaveBlock
    };
    /// Takes `samples` stratified samples on each of the `rays` of `fog`. `shift` of each ray, 0..1, says
    /// where in its strata they lie. Point and spot lights: equi-angular (Kulla and Fajardo 2012);
    /// directional ones: by the transmittance back to the ray's origin. `counted`: the fog between light and
    /// sample is included; else the caller that traces the rays includes it.
    void sample(const FogWave& fog, const Light& light, Rays rays, int samples, const float* shift,
                bool counted);

    /// Towards the light, from the samples that matter; directions of unit length.
    const RayWave& rays() const { return rays_; }
    /// Adds the samples whose ray is not `occluded`, or as much of each as arrives, to fog.rays().scattered.
    void add(const FogWave& fog, const std::vector<std::uint8_t>& occluded) const;
    void add(const FogWave& fog, const std::vector<Colour>& arriving) const;
    void addAll(const FogWave& fog) const;

  private:
    RayWave rays_;
    Colour scale_;
    std::vector<float> value_;      ///< of each sample: its radiance is scale_ * value
    std::vector<std::uint32_t> of_; ///< of each sample: its ray in the wave
};

} // namespace rtcore
