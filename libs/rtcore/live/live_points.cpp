#include "rtcore/live/live_points.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace rtcore {

namespace {

/// The lower half of the octahedron is folded out around the upper one.
Vec2 folded(float x, float y) {
    return {(1 - std::fabs(y)) * std::copysign(1.0F, x), (1 - std::fabs(x)) * std::copysign(1.0F, y)};
}

constexpr int kBias = 15, kMantissaBits = 9, kMostExponent = 31;
constexpr float kMostLight = 65408;

} // namespace

std::uint16_t packNormal(Vec3 normal) {
    const float sum = std::fabs(normal.x) + std::fabs(normal.y) + std::fabs(normal.z);
    Vec2 flat = sum > 0 ? Vec2{normal.x / sum, normal.y / sum} : Vec2{};
    if (normal.z < 0) flat = folded(flat.x, flat.y);
    const auto bits = [](float v) { return static_cast<std::uint32_t>((v * 0.5F + 0.5F) * 255 + 0.5F); };
    return static_cast<std::uint16_t>(bits(flat.x) | bits(flat.y) << 8);
}

Vec3 unpackNormal(std::uint16_t packed) {
    const auto value = [](int bits) { return static_cast<float>(bits) * (2.0F / 255) - 1; };
    Vec2 flat{value(packed & 0xFF), value(packed >> 8)};
    const float z = 1 - std::fabs(flat.x) - std::fabs(flat.y);
    if (z < 0) flat = folded(flat.x, flat.y);
    return normalize(Vec3{flat.x, flat.y, z});
}

std::uint32_t packLight(Colour light) {
    // fmin and fmax take the number of a number and NaN.
    const auto within = [](float v) { return std::fmin(std::fmax(v, 0.0F), kMostLight); };
    const float r = within(light.r), g = within(light.g), b = within(light.b);
    const float largest = std::max({r, g, b});
    if (!(largest > 0)) return 0;
    // The exponent of the power of two above the largest, also where rounding lifts it to that.
    int exponent = std::clamp(std::ilogb(largest) + 1 + kBias, 0, kMostExponent);
    const auto scaled = [&](float v) {
        return static_cast<std::uint32_t>(std::ldexp(v, kMantissaBits + kBias - exponent) + 0.5F);
    };
    if (scaled(largest) > 511 && exponent < kMostExponent) ++exponent;
    const auto mantissa = [&](float v) { return std::min(scaled(v), 511U); };
    return mantissa(r) | mantissa(g) << 9 | mantissa(b) << 18 | static_cast<std::uint32_t>(exponent) << 27;
}

Colour unpackLight(std::uint32_t packed) {
    const int exponent = static_cast<int>(packed >> 27) - kBias - kMantissaBits;
    const auto scale = std::bit_cast<float>(static_cast<std::uint32_t>(exponent + 127) << 23);
    return Colour{static_cast<float>(packed & 511U), static_cast<float>(packed >> 9 & 511U),
                  static_cast<float>(packed >> 18 & 511U)} *
           scale;
}

} // namespace rtcore
