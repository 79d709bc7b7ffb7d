/// One wave of rays on its way through the integrator.
#pragma once

#include "rtcore/kernels/ray_statistics.h"
#include "rtcore/kernels/ray_wave.h"
#include "rtcore/sampling/sample_id.h"
#include "rtcore/shading/paths/wave_paths.h"
#include "rtcore/shading/surface/surface_wave.h"

#include <cstddef>
#include <cstdint>
#include <span>

namespace rtcore {

/// One for each thread; keeps its memory from wave to wave.
struct Wave {
    RayKind kind = RayKind::Primary;
    const RayWave* rays = nullptr; ///< directions of unit length
    WavePaths paths;               ///< of the rays
    std::span<const SampleId>
        samples; ///< names of the samples; may be empty where no random numbers are needed
    HitWave hits;
    SurfaceWave surfaces;

    std::size_t size() const { return surfaces.size(); }
    Vec3 direction(std::size_t ray) const { return {rays->dx[ray], rays->dy[ray], rays->dz[ray]}; }
    /// Without names, the pixel of a sample is its index.
    SampleId sampleId(std::size_t ray) const {
        const std::uint32_t sample = paths.sample(ray);
        if (!samples.empty()) return samples[sample];
        return {static_cast<std::uint16_t>(sample), static_cast<std::uint16_t>(sample >> 16), 0};
    }
};

} // namespace rtcore
