#include "rtcore/math/packed_light.h"

#include "rtcore/math/packed_light-inl.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace rtcore {

namespace {

constexpr int kBias = HWY_NAMESPACE::kLightBias, kMantissaBits = HWY_NAMESPACE::kLightMantissaBits;
constexpr int kMaxExponent = 31, kFloatBias = 127;
constexpr float kMaxLight = 65408;

} // namespace

std::uint32_t packLight(Colour light) {
    // fmin and fmax take the number of a number and NaN.
    const auto within = [](float v) { return std::fmin(std::fmax(v, 0.0F), kMaxLight); };
    const float r = within(light.r), g = within(light.g), b = within(light.b);
    const float largest = std::max({r, g, b});
    if (!(largest > 0)) return 0;
    // The exponent of the power of two above the largest, also where rounding lifts it to that.
    const int above = static_cast<int>(std::bit_cast<std::uint32_t>(largest) >> 23) - kFloatBias + 1;
    int exponent = std::clamp(above + kBias, 0, kMaxExponent);
    const auto scaled = [&](float v) {
        const int power = kFloatBias + kMantissaBits + kBias - exponent;
        const auto scale = std::bit_cast<float>(static_cast<std::uint32_t>(power) << 23);
        return static_cast<std::uint32_t>(v * scale + 0.5F);
    };
    if (scaled(largest) > 511 && exponent < kMaxExponent) ++exponent;
    const auto mantissa = [&](float v) { return std::min(scaled(v), 511U); };
    return mantissa(r) | mantissa(g) << 9 | mantissa(b) << 18 | static_cast<std::uint32_t>(exponent) << 27;
}

Colour unpackLight(std::uint32_t packed) {
    const Vec3 light = HWY_NAMESPACE::unpackedLight<float>(packed);
    return {light.x, light.y, light.z};
}

} // namespace rtcore
