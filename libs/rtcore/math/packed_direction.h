/// Directions in 32 bits, for millions of samples: an error of 1/20,000.
#pragma once

#include "rtcore/math/octahedron-inl.h"
#include "rtcore/math/vec.h"

#include <cstdint>

namespace rtcore {

/// Of a direction of any length but 0.
inline std::uint32_t packDirection(Vec3 direction) {
    const auto point = HWY_NAMESPACE::octahedronPoint<float>(direction);
    const auto whole = [](float x) { return static_cast<std::uint32_t>(x * 65535 + 0.5F) & 0xFFFFU; };
    return whole(point.x) | whole(point.y) << 16;
}
/// Of unit length.
inline Vec3 unpackDirection(std::uint32_t bits) {
    const auto part = [](std::uint32_t x) { return static_cast<float>(x & 0xFFFFU) / 65535; };
    return normalize(HWY_NAMESPACE::octahedronDirection<float>(part(bits), part(bits >> 16)));
}

} // namespace rtcore
