/// Which vertices of a mesh lie at the same place.
#pragma once

#include "rtcore/io/import/mesh/hash.h"
#include "rtcore/math/vec.h"

#include <bit>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

namespace rtcore {

/// The form in which positions are compared: coordinates nearer to 0 than 1e-30 are 0. In a model that is
/// large enough to be traced it makes no difference, and subnormal numbers, which are slow, do not come up.
inline Vec3 withoutTraces(Vec3 p) {
    constexpr float kMinCoordinate = 1e-30F;
    const auto clean = [](float v) { return std::fabs(v) < kMinCoordinate ? 0.0F : v; };
    return {clean(p.x), clean(p.y), clean(p.z)};
}

/// Whether it is of numbers up to 1e12: squares of distances stay finite in float.
inline bool isUsablePosition(Vec3 p) {
    constexpr float kLargestCoordinate = 1e12F;
    // False for NaN, too.
    return std::fabs(p.x) <= kLargestCoordinate && std::fabs(p.y) <= kLargestCoordinate &&
           std::fabs(p.z) <= kLargestCoordinate;
}

/// The hash of a position that went through withoutTraces().
inline std::uint64_t hashOfPosition(Vec3 p) {
    return finishedHash(mixedHash(mixedHash(0, bitsOfPair(p.x, p.y)), std::bit_cast<std::uint32_t>(p.z)));
}

/// For each position the number of the first that is equal; for those that are not usable their own. Nothing
/// where all differ (first_of_same.h).
std::vector<std::uint32_t> firstOfEqualPositions(std::span<const Vec3> positions);

} // namespace rtcore
