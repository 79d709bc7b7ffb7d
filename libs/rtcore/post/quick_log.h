/// A logarithm of many pixels, the same on every processor.
#pragma once

#include <bit>
#include <cstdint>

namespace rtcore {

/// log2 of a normal x > 0, within 1e-6.
inline float quickLog2(float x) {
    const auto bits = std::bit_cast<std::uint32_t>(x);
    // The exponent for a mantissa in [sqrt(1/2), sqrt(2)).
    const std::uint32_t shifted = bits + (0x3F800000U - 0x3F3504F3U);
    const float exponent = static_cast<float>(static_cast<int>(shifted >> 23)) - 127;
    const float m = std::bit_cast<float>((shifted & 0x7FFFFFU) + 0x3F3504F3U);
    const float s = (m - 1) / (m + 1), z = s * s;
    return exponent + s * (2.88539008F + z * (0.961796694F + z * (0.577078016F + z * 0.412198583F)));
}

} // namespace rtcore
