/// Linear RGB with the primaries and white point of sRGB; 1 is the white of the display before exposure,
/// values may be any size >= 0 (high dynamic range).
#pragma once

#include "rtcore/simd/portable_math.h"

#include <algorithm>
#include <cmath>

namespace rtcore {

struct Colour {
    float r = 0, g = 0, b = 0;

    friend bool operator==(const Colour&, const Colour&) = default;
    friend Colour operator+(Colour a, Colour b) { return {a.r + b.r, a.g + b.g, a.b + b.b}; }
    friend Colour operator-(Colour a, Colour b) { return {a.r - b.r, a.g - b.g, a.b - b.b}; }
    friend Colour operator*(Colour a, Colour b) { return {a.r * b.r, a.g * b.g, a.b * b.b}; }
    friend Colour operator*(Colour a, float s) { return {a.r * s, a.g * s, a.b * s}; }
    friend Colour operator*(float s, Colour a) { return a * s; }
    friend Colour operator/(Colour a, float s) { return {a.r / s, a.g / s, a.b / s}; }
    Colour& operator+=(Colour other) { return *this = *this + other; }
    Colour& operator*=(Colour other) { return *this = *this * other; }
};

inline constexpr Colour kWhite{1, 1, 1};

/// Rec. 709 luminance.
inline constexpr Colour kLuminance{0.2126F, 0.7152F, 0.0722F};
inline float luminance(Colour c) { return kLuminance.r * c.r + kLuminance.g * c.g + kLuminance.b * c.b; }
inline float maxComponent(Colour c) { return std::max(c.r, std::max(c.g, c.b)); }
inline bool isFinite(Colour c) { return std::isfinite(c.r) && std::isfinite(c.g) && std::isfinite(c.b); }
inline bool isBlack(Colour c) { return c.r == 0 && c.g == 0 && c.b == 0; }

/// The sRGB transfer curve (IEC 61966-2-1) of one component in [0, 1].
inline float srgbEncode(float linear) {
    return linear <= 0.0031308F ? 12.92F * linear : 1.055F * portablePow(linear, 1.0F / 2.4F) - 0.055F;
}
inline float srgbDecode(float encoded) {
    return encoded <= 0.04045F ? encoded / 12.92F : portablePow((encoded + 0.055F) / 1.055F, 2.4F);
}

} // namespace rtcore
