/// The sums of what primary rays see, ray i for sample i.
#pragma once

#include "rtcore/math/colour.h"
#include "rtcore/shading/material_table.h"
#include "rtcore/shading/surface_wave.h"

#include <cstdint>

namespace rtcore {

/// Begins the sum of each sample: `background` where the ray missed, else the glow of its material, as if the point
/// were plain (material_table.h). Sets `hit` to 1 where there is a surface, else 0, and surfaces.share to 1.
void startSums(Colour background, const MaterialTable& materials, const SurfaceWave& surfaces,
               const ArraysOf3& radiance, std::uint8_t* hit);

/// radiance += surfaces.added, sample by sample.
void addToSums(const SurfaceWave& surfaces, const ArraysOf3& radiance);

} // namespace rtcore
