/// Light inside a transparent solid.
#pragma once

#include "rtcore/math/colour.h"
#include "rtcore/scene/material.h"

#include <algorithm>

namespace rtcore {

/// Extinction per scene unit that leaves `transmission` after `attenuationDistance` (Beer's law); zero for a
/// material that tints at its surface instead.
inline Colour extinctionOf(const Material& m) {
    if (!(m.attenuationDistance > 0)) return {};
    constexpr float kLn2 = 0.69314718F;
    constexpr float kDarkest = 1e-6F; // black glass still has a finite extinction
    const auto component = [&](float weight) {
        return -portableLog2(std::clamp(weight, kDarkest, 1.0F)) * kLn2 / m.attenuationDistance;
    };
    return {component(m.transmission.r), component(m.transmission.g), component(m.transmission.b)};
}

/// Transmittance of `distance`.
inline Colour absorption(Colour extinction, float distance) {
    if (isBlack(extinction)) return kWhite;
    return {portableExp(-extinction.r * distance), portableExp(-extinction.g * distance),
            portableExp(-extinction.b * distance)};
}

/// The tint of a solid whose material has no attenuation distance: all of it at once, on entering.
inline Colour tintOnEntering(const Material& m) {
    return m.attenuationDistance > 0 ? kWhite : m.transmission;
}

} // namespace rtcore
