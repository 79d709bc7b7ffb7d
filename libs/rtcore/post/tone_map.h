/// The sigmoid L = Y / (Y + c) (thesis 3.2; Reinhard 2007).
#pragma once

#include "rtcore/math/colour.h"

#include <algorithm>

namespace rtcore {

/// [0, infinity] -> [0, 1]; NaN and negative count as 0. c >= 1e-30.
inline float sigmoid(float y, float c) {
    if (!(y > 0)) return 0;
    return 1 / (1 + std::max(c, 1e-30F) / y);
}

inline Colour toneMapChannels(Colour x, float c) {
    return {sigmoid(x.r, c), sigmoid(x.g, c), sigmoid(x.b, c)};
}

/// Maps the luminance and keeps the ratios of the channels. Where a channel would exceed 1, the colour is
/// blended towards the grey of the same luminance just as far as needed, so that bright colours fade to
/// white.
inline Colour toneMapLuminance(Colour x, float c) {
    const float y = luminance(x);
    const float l = sigmoid(y, c);
    if (!(l > 0)) return {};
    if (!isFinite(x) || !(y < 1e30F)) return {l, l, l};
    const Colour scaled = x / (y + std::max(c, 1e-30F));
    const float largest = maxComponent(scaled);
    if (largest <= 1) return scaled;
    const float blend = (1 - l) / (largest - l);
    return Colour{l, l, l} * (1 - blend) + scaled * blend;
}

} // namespace rtcore
