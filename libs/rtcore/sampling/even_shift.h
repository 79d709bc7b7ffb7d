/// Shifts for the patterns of a picture's samples: as random as randomShift(), but neighbours differ as much
/// as they can, so that the noise is fine and even.
#pragma once

#include "rtcore/sampling/sample_id.h"

#include <cstdint>
#include <cstdlib>

namespace rtcore {

/// Place of a cell on Hilbert's curve through 64 x 64 of them.
constexpr std::uint32_t hilbertIndex(std::uint32_t x, std::uint32_t y) {
    std::uint32_t index = 0;
    for (std::uint32_t half = 32; half > 0; half /= 2) {
        const bool right = (x & half) != 0, lower = (y & half) != 0;
        index += half * half * ((right ? 3U : 0U) ^ (lower ? 1U : 0U));
        if (!lower) {
            if (right) {
                x = 63 - x;
                y = 63 - y;
            }
            const std::uint32_t old = x;
            x = y;
            y = old;
        }
    }
    return index;
}

inline SquarePoint evenShift(SampleId id, Draw draw, std::uint32_t salt = 0) {
    static const int mode = std::getenv("AO_SHIFT") ? std::atoi(std::getenv("AO_SHIFT")) : 0;
    if (mode == 0) return randomShift(id, draw, salt);
    const std::uint32_t use = mixBits(static_cast<std::uint32_t>(draw) << 24 | salt);
    std::uint32_t u = 0, v = 0;
    if (mode == 1) { // IGN
        const auto ign = [](std::uint32_t x, std::uint32_t y) {
            const std::uint32_t inner = x * 288237715U + y * 25070459U;
            return static_cast<std::uint32_t>(std::uint64_t{inner} * 3555661U >> 16); // 52.98.. * 65536 = 3472289
        };
        u = ign(id.x, id.y);
        v = ign(id.x + 5171U, id.y + 1093U);
    }
    if (mode == 2) { // Hilbert + R2
        const std::uint32_t h = hilbertIndex(id.x & 63U, id.y & 63U);
        u = h * 3242174889U;
        v = h * 2447445414U;
    }
    if (mode == 3) { // R2 lattice in x and y
        u = id.x * 3242174889U + id.y * 2447445414U;
        v = id.x * 2447445414U - id.y * 3242174889U;
    }
    if (mode == 4) { // IGN for the azimuth, Hilbert for the height
        const std::uint32_t inner = id.x * 288237715U + id.y * 25070459U;
        v = static_cast<std::uint32_t>(std::uint64_t{inner} * 3472289U >> 16);
        u = hilbertIndex(id.x & 63U, id.y & 63U) * 2654435769U;
    }
    u += id.sub * 3242174889U + use;
    v += id.sub * 2447445414U + mixBits(use);
    return {unitFloat(u), unitFloat(v)};
}

} // namespace rtcore
