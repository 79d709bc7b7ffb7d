/// Materials of the metallic-roughness model of glTF 2, and what Phong's model makes of them. Formulas:
/// docs/import.md.
#pragma once

#include "rtcore/scene/material.h"

namespace rtcore {

/// Reflectance of what is no metal, at normal incidence.
inline constexpr float kDielectricReflectance = 0.04F;

/// Mirrored rays show the surroundings in surfaces of less roughness; the rougher, the fainter.
inline constexpr float kMirrorsBelow = 0.3F;

/// The means of a material's textures, 1 where there is none.
struct TextureMeans {
    Colour diffuse = kWhite; ///< linear
    float roughness = 1, metallic = 1;
};

/// `base` is the colour of the diffuse lobe of what is no metal and of the reflection of what is one, 0..1.
/// `metallic`, `roughness`: 0..1, multiplied by metallicRoughnessTexture if there is one. What has to do with
/// transparency, emission and textures stays.
void setMetallicRoughness(Material& material, Colour base, float metallic, float roughness);

/// Makes it one of Phong's model that looks about the same: a highlight of the width that its roughness
/// gives, and mirrored rays that fade out where roughness would blur them. Others stay as they are.
void setPhong(Material& material, const TextureMeans& means);

/// The roughness whose lobe has the material's shininess, if it has none of its own; 1 without a highlight.
float roughnessOf(const Material& material);

/// Scales the specular albedo of Phong's model, keeping its hue, so that no channel gives off more than it
/// gets.
void conserveEnergy(Material& material);

} // namespace rtcore
