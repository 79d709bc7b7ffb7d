/// The light that the surfaces of a wave give off by themselves.
#pragma once

#include "rtcore/shading/surface/material_table.h"
#include "rtcore/shading/surface/surface_wave.h"

namespace rtcore {

/// Sets `emitted` to what reaches the sample of each point's emission, and of the ambient light that it
/// reflects, but for points with the trait kMetallic, whose part of that comes with their lobes
/// (light_division.h); leaves it as it is where there is no point. Before the light is divided.
void emissionOf(const MaterialTable& materials, const SurfaceWave& surfaces, const ArraysOf3& emitted);

} // namespace rtcore
