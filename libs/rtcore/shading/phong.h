/// The physical Phong model: radiance = albedo terms times irradiance, so that lights in W/sr and surfaces of
/// any shininess agree in brightness, and no surface reflects more than it gets (Lafortune and Willems 1994).
#pragma once

#include "rtcore/math/colour.h"
#include "rtcore/math/vec.h"

#include <algorithm>

namespace rtcore {

inline constexpr float kPi = 3.14159265358979F;

/// Below this exponent cos^n ends in a step, at right angles to the mirrored light: a share 1 - n of the
/// glossy light is then scattered by roughLobe(), the rest by the lobe of this exponent.
inline constexpr float kLeastShininess = 1;

/// Keeps the rough lobe finite where light and viewer graze the surface.
inline constexpr float kLeastCosines = 1e-18F;

/// f_r of a metal of roughness 1: GGX with alpha = 1 and the height-correlated masking of Smith, which comes
/// to 1 / 2 pi (cos i + cos o). The cosines of light and viewer with the normal, >= 0.
inline float roughLobe(float light, float viewer) {
    return 1 / (2 * kPi * std::max(light + viewer, kLeastCosines));
}

/// f_r of the Phong lobe: (n + 2) / 2 pi cos^n of the angle between the mirrored light and the viewer.
inline float phongLobe(float cosine, float shininess) {
    if (cosine <= 0) return 0;
    return (shininess + 2) / (2 * kPi) * portablePow(cosine, shininess);
}

/// Smooth normals show a hard edge where the triangles turn away from the light. This factor on the
/// irradiance softens it (Chiang et al. 2019, "Taming the Shadow Terminator"). All vectors of unit length,
/// towards the outside.
inline float terminatorFactor(Vec3 geometricNormal, Vec3 shadingNormal, Vec3 toLight) {
    const float geometric = dot(geometricNormal, toLight);
    const float shading = dot(shadingNormal, toLight);
    if (geometric <= 0 || shading <= 0) return 0;
    const float both = shading * std::max(dot(geometricNormal, shadingNormal), 1e-6F);
    const float g = std::min(1.0F, geometric / both);
    return g * (1 + g * (1 - g));
}

} // namespace rtcore
