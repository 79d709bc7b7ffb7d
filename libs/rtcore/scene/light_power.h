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

} // namespace rtcore
