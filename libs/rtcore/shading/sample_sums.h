/// The sums of what primary rays see, ray i for sample i.
#pragma once

#include "rtcore/math/colour.h"
#include "rtcore/shading/material_table.h"
#include "rtcore/shading/surface_wave.h"

#include <cstdint>

namespace rtcore {

/// Begins the sum of each sample: `background` where the ray missed, else zero. Sets `hit` to 1 where there
/// is a surface, else 0, and surfaces.share to 1.
void startSums(Colour background, const SurfaceWave& surfaces, const ArraysOf3& radiance, std::uint8_t* hit);

/// Sets `glow` to what the material of each point gives off, emission and reflected ambient light, as if it
/// were no mirror; leaves it as it is where there is no point.
void glowOf(const MaterialTable& materials, const SurfaceWave& surfaces, const ArraysOf3& glow);

/// radiance += surfaces.added, sample by sample.
void addToSums(const SurfaceWave& surfaces, const ArraysOf3& radiance);

} // namespace rtcore
