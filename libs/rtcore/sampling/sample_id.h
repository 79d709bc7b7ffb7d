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

/// Uses of the random numbers of a sample; each dimension is independent of the others. Use `salt` where a
/// path needs several of one dimension: the bounce, the number of a light.
enum class SampleDimension : std::uint32_t {
    Position,
    Lens,
    Occlusion,
    AreaLight,
    Shaft,
    Hole,        ///< whether a surface that is there in part is met
    Glass,       ///< whether light is reflected or passes
    Lobe,        ///< which lobe of a surface scatters
    Direction,   ///< where it scatters to
    Light,       ///< which light is sampled
    Emitter,     ///< which emissive triangle of a cluster
    LightChoice, ///< which lights are traced where there is no time for all
    Facet        ///< which facet of rough glass is met
};

#define RT_FORMULA constexpr
#define RT_BITS std::uint32_t
#include "rtcore/sampling/random_bits_text.h"
#undef RT_BITS
#undef RT_FORMULA

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

/// The name of a pixel's sequences. Images with different seeds are independent.
constexpr std::uint32_t pixelName(SampleId id, std::uint32_t seed) {
    return nameOfPixel(id.x | static_cast<std::uint32_t>(id.y) << 16, seed);
}

/// The argument of nameOfUse(); bounce < 2^24.
constexpr std::uint32_t useBits(SampleDimension dimension, std::uint32_t bounce) {
    return static_cast<std::uint32_t>(dimension) << 24 | bounce;
}

/// Point number id.sub of the sequence of pairs that the id's pixel has for this dimension and bounce. Its
/// first 2^k points are a (0, k, 2)-net; each sequence has a shuffle and scrambles of its own, so that a path
/// may use many of them together. In vector code: owen-inl.h.
constexpr OwenPair pairInSequence(SampleId id, std::uint32_t seed, SampleDimension dimension,
                                  std::uint32_t bounce) {
    return owenPair(id.sub, nameOfUse(pixelName(id, seed), useBits(dimension, bounce)));
}
constexpr SquarePoint pointInSequence(SampleId id, std::uint32_t seed, SampleDimension dimension,
                                      std::uint32_t bounce) {
    const OwenPair pair = pairInSequence(id, seed, dimension, bounce);
    return {unitFloat(pair.u), unitFloat(pair.v)};
}

/// u + shift on the unit circle: 0 <= result < 1 for both in 0..1, without 1.
constexpr float wrapped(float u, float shift) {
    const float sum = u + shift;
    return sum >= 1 ? sum - 1 : sum;
}

} // namespace rtcore
