/// The metallic-roughness model of glTF 2 in terms of Material's lobes. Formulas: docs/import.md.
#pragma once

#include "rtcore/scene/material.h"

namespace rtcore {

/// Reflectance of what is no metal, at normal incidence.
inline constexpr float kDielectricReflectance = 0.04F;

/// The reflectance `f0` at normal incidence as a highlight of the width that `roughness` (0..1) gives, and as
/// mirrored rays that fade out where roughness would blur them.
void setReflection(Material& material, Colour f0, float roughness);

/// `base` is the colour of the diffuse lobe of what is no metal and of the reflection of what is one, 0..1;
/// `textureMean` the mean colour of the texture that multiplies it. `metallic`, `roughness`: 0..1. What has
/// to do with transparency, emission and textures stays.
void setMetallicRoughness(Material& material, Colour base, Colour textureMean, float metallic,
                          float roughness);

/// What setMetallicRoughness() would have to be given; of other materials the nearest to it: the roughness
/// whose lobe has their shininess, 1 where they have none.
Colour baseColourOf(const Material& material, Colour textureMean);
float roughnessOf(const Material& material);

/// Scales the specular albedo, keeping its hue, so that no channel gives off more than it gets.
void conserveEnergy(Material& material);

} // namespace rtcore
