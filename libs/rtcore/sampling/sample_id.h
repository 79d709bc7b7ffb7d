/// Ids of the samples of an image, and random numbers derived from an id: the same in every frame, for every
/// number of threads and order of tiles.
#pragma once

#include "rtcore/math/vec.h"

#include <cstdint>

namespace rtcore {

/// Which of the image's samples a ray began with.
struct SampleId {
    std::uint16_t x = 0, y = 0; ///< its pixel
    std::uint32_t sub = 0;      ///< which of the pixel's samples
};

/// What random numbers of a sample are for; each dimension is independent of the others. Use `salt` where a
/// path needs several of one dimension: the bounce, the number of a light.
enum class SampleDimension : std::uint32_t { Position, Lens, Occlusion, AreaLight, Shaft };

/// Well mixed bits of 32 others (Wellons' lowbias32, 2018): a bijection.
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

/// Random bits, independent of those of any other sample or dimension.
constexpr std::uint32_t randomBits(SampleId id, SampleDimension dimension, std::uint32_t salt = 0) {
    const std::uint32_t pixel = mixBits(id.x | static_cast<std::uint32_t>(id.y) << 16);
    return mixBits(mixBits(pixel + 0x9E3779B9U * id.sub) ^
                   (static_cast<std::uint32_t>(dimension) << 24 | salt));
}

/// Where the sample's pattern for `dimension` is shifted to on the unit torus: independent of its
/// neighbours'.
constexpr SquarePoint randomShift(SampleId id, SampleDimension dimension, std::uint32_t salt = 0) {
    const std::uint32_t u = randomBits(id, dimension, salt);
    return {unitFloat(u), unitFloat(mixBits(u + 0x85EBCA6BU))};
}

/// u + shift on the unit circle: 0 <= result < 1 for both in 0..1, without 1.
constexpr float wrapped(float u, float shift) {
    const float sum = u + shift;
    return sum >= 1 ? sum - 1 : sum;
}

} // namespace rtcore
