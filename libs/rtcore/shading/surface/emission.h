/// The light that the surfaces of a wave give off by themselves.
#pragma once

#include "rtcore/shading/surface/material_table.h"
#include "rtcore/shading/surface/surface_wave.h"

namespace rtcore {

/// Sets `emitted` to what reaches the sample of each point's emission and reflected ambient light, as if the
/// point were no mirror; leaves it as it is where there is no point.
void emissionOf(const MaterialTable& materials, const SurfaceWave& surfaces, const ArraysOf3& emitted);

} // namespace rtcore
