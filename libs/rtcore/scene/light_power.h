/// How much a light gives off.
#pragma once

#include "rtcore/math/colour.h"
#include "rtcore/math/constants.h"
#include "rtcore/scene/light.h"
#include "rtcore/scene/photometry.h"

namespace rtcore {

/// The intensity of a light that has a position, as a fraction of `Light::intensity`: its mean over all
/// directions. A spot's is that of its cone, with half of its rim, by the integral of the smoothstep.
template <typename F = float>
F meanIntensity(const Light& light) {
    switch (traitsOf(light).beam) {
    case Beam::Cosine:
        return F(0.25);
    case Beam::Cone:
        return F(0.5) - F(0.25) * (F(light.cosInner) + F(light.cosOuter));
    case Beam::Measured:
        return F(photometryOf(light).mean);
    case Beam::Even:
        break;
    }
    return 1;
}

/// The power of a light of intensity 1, W: its integral over all directions. For a directional light, which
/// has no end: 1, the irradiance on a surface that faces it, W/m^2.
template <typename F = float>
F powerFactor(const Light& light) {
    return traitsOf(light).position ? 4 * kPi * meanIntensity<F>(light) : 1;
}

/// The power of a light, as luminance: W, where distances count in scene units; W/m^2 for a directional
/// light.
template <typename F = float>
F powerOf(const Light& light) {
    return luminance(light.intensity) * powerFactor<F>(light);
}

/// Lumens of a radiant watt, and lux of a watt per square metre, as the sky counts them (sky/atmosphere.h).
inline constexpr double kLumensPerWatt = 683;

/// The power of a light where a scene unit has so many metres. `power`: its powerOf(), which counts with
/// distances in scene units: W per square metre of a square scene unit; the irradiance by directional lights
/// does not depend on distances.
inline double radiantWatts(const Light& light, double power, double metresPerUnit) {
    return traitsOf(light).position ? power * metresPerUnit * metresPerUnit : power;
}
/// The way back.
inline double powerOfWatts(const Light& light, double watts, double metresPerUnit) {
    return watts / radiantWatts(light, 1, metresPerUnit);
}

} // namespace rtcore
