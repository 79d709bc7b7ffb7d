/// How much a light gives off.
#pragma once

#include "rtcore/math/constants.h"
#include "rtcore/scene/light.h"

namespace rtcore {

/// All that a light of intensity 1 gives off, W: its integral over all directions. A spot's is that of its
/// cone, with half of its rim, by the integral of the smoothstep. Of a directional light, which has no end:
/// 1, the irradiance on a surface that faces it, W/m^2.
inline float powerFactor(const Light& light) {
    const LightTraits& traits = traitsOf(light);
    if (!traits.position) return 1;
    switch (traits.beam) {
    case Beam::Cosine:
        return kPi;
    case Beam::Cone:
        return 2 * kPi * (1 - 0.5F * (light.cosInner + light.cosOuter));
    case Beam::Even:
        break;
    }
    return 4 * kPi;
}

/// Lumens of a radiant watt, and lux of a watt per square metre, as the sky counts them (sky/atmosphere.h).
inline constexpr double kLumensPerWatt = 683;

/// What a light gives off where a scene unit has so many metres. `power`: its luminance times powerFactor(),
/// which counts with distances in scene units: W per square metre of a square scene unit; what directional
/// lights throw on a surface does not depend on distances.
inline double radiantWatts(const Light& light, double power, double metresPerUnit) {
    return traitsOf(light).position ? power * metresPerUnit * metresPerUnit : power;
}
/// The way back.
inline double powerOfWatts(const Light& light, double watts, double metresPerUnit) {
    return watts / radiantWatts(light, 1, metresPerUnit);
}

} // namespace rtcore
