/// How light divides at glass; mirrors are in fresnel-inl.h.
#pragma once

#include "rtcore/math/vec.h"

#include <algorithm>
#include <cmath>

namespace rtcore {

/// Reflectance of a dielectric for unpolarised light. `cosine` (0..1) is on the side where the light comes
/// from, `eta` the index of refraction of the other side over that of this one. 1 under total internal
/// reflection.
inline float fresnelDielectric(float cosine, float eta) {
    const float ci = std::clamp(cosine, 0.0F, 1.0F);
    const float sine2 = (1 - ci * ci) / (eta * eta);
    if (eta == 1) return 0; // at right angles, too
    if (sine2 >= 1) return 1;
    const float ct = std::sqrt(1 - sine2);
    const float s = (ci - eta * ct) / (ci + eta * ct);
    const float p = (eta * ci - ct) / (eta * ci + ct);
    return (s * s + p * p) / 2;
}

/// A thin wall has two interfaces; with all the reflections between them it reflects 2R/(1+R).
inline float thinWallReflectance(float interfaceReflectance) {
    return 2 * interfaceReflectance / (1 + interfaceReflectance);
}

/// Direction of `d` (unit, dot(d, n) <= 0) after refraction, by Snell's law; false under total internal
/// reflection.
inline bool refract(Vec3 d, Vec3 n, float eta, Vec3& refracted) {
    const float ci = -dot(d, n);
    const float sine2 = (1 - ci * ci) / (eta * eta);
    if (sine2 >= 1) return false;
    refracted = normalize(d / eta + n * (ci / eta - std::sqrt(1 - sine2)));
    return true;
}

} // namespace rtcore
