/// The fraction of light from all sides that surfaces scatter.
#pragma once

#include "rtcore/math/constants.h"
#include "rtcore/shading/surface/material_table.h"
#include "rtcore/shading/surface/surface_wave.h"

#include <cstddef>

namespace rtcore {

/// The fraction of such light at a point of the wave that reaches its sample by way of all lobes; the light
/// has been divided.
inline Colour scatteredOf(const MaterialTable& materials, const SurfaceWave& surfaces, std::size_t point) {
    const MaterialRow& row = materials.rows()[surfaces.material[point]];
    const bool metallic = (surfaces.traits[point] & traits::kMetallic) != 0;
    Colour specular =
        metallic ? surfaces.gloss.colourAt(point) : Colour{row.specular[0], row.specular[1], row.specular[2]};
    if (!metallic && surfaces.tint.x != nullptr) specular *= surfaces.tint.colourAt(point);
    if (surfaces.coat != nullptr && metallic) specular += kWhite * surfaces.coatAlbedo[point];
    return surfaces.weight.colourAt(point) * (surfaces.diffuseBrdf.colourAt(point) * kPi + specular);
}

} // namespace rtcore
