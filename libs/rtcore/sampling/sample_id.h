/// Names for the samples of a picture, and the numbers that a sample draws by its name: the same in every
/// frame, for every number of threads and order of tiles.
#pragma once

#include "rtcore/math/vec.h"

#include <cstdint>

namespace rtcore {

/// Which of the picture's samples a ray began with.
struct SampleId {
    std::uint16_t x = 0, y = 0; ///< its pixel
    std::uint32_t sub = 0;      ///< which of the pixel's samples
};

/// What a sample draws numbers for. Each purpose has numbers of its own; add `salt` for what comes several
/// times on one path: the bounce, the number of a light.
enum class Draw : std::uint32_t { Position, Lens, Occlusion, Lamp, Shaft };

/// Well mixed bits of 32 others (Wellons' lowbias32, 2018): another number for each.
constexpr std::uint32_t mixBits(std::uint32_t x) {
    x ^= x >> 16;
    x *= 0x7FEB352DU;
    x ^= x >> 15;
    x *= 0x846CA68BU;
    return x ^ x >> 16;
}

/// 0 <= u < 1 from the upper 24 bits.
constexpr float unitFloat(std::uint32_t bits) { return static_cast<float>(bits >> 8) * 0x1p-24F; }

/// A point of the unit square.
struct SquarePoint {
    float u = 0, v = 0; ///< 0..1, without 1
};

/// Bits that have nothing to do with those of any other sample or purpose.
constexpr std::uint32_t randomBits(SampleId id, Draw draw, std::uint32_t salt = 0) {
    const std::uint32_t pixel = mixBits(id.x | static_cast<std::uint32_t>(id.y) << 16);
    return mixBits(mixBits(pixel + 0x9E3779B9U * id.sub) ^ (static_cast<std::uint32_t>(draw) << 24 | salt));
}

/// Where the sample's pattern for `draw` is shifted to on the unit torus: independent of its neighbours'.
constexpr SquarePoint randomShift(SampleId id, Draw draw, std::uint32_t salt = 0) {
    const std::uint32_t u = randomBits(id, draw, salt);
    return {unitFloat(u), unitFloat(mixBits(u + 0x85EBCA6BU))};
}

/// u + shift on the unit circle: 0 <= result < 1 for both in 0..1, without 1.
constexpr float wrapped(float u, float shift) {
    const float sum = u + shift;
    return sum >= 1 ? sum - 1 : sum;
}

} // namespace rtcore
