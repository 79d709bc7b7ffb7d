/// Small vectors. Plain aggregates: no invariants, any bit pattern is a value.
#pragma once

#include <cmath>
#include <concepts>

namespace rtcore {

struct Vec2 {
    float x = 0, y = 0;
    friend bool operator==(const Vec2&, const Vec2&) = default;
};

inline float copySign(float size, float sign) { return std::copysign(size, sign); }

#define RT_FORMULA inline
#include "rtcore/math/vec3_text.h"
#undef RT_FORMULA

using Vec3 = Vec3T<float>;
/// For positions that many small moves add up to.
using Vec3d = Vec3T<double>;
using Basis = BasisT<float>;

template <typename T>
T length(Vec3T<T> a) {
    return std::sqrt(dot(a, a));
}
template <typename T>
bool isFinite(Vec3T<T> a) {
    return std::isfinite(a.x) && std::isfinite(a.y) && std::isfinite(a.z);
}

/// Between them the square of a vector's length has all its digits.
inline constexpr float kMinSquare = 1e-28F, kMaxSquare = 1e28F;

/// The unit vector along `a`, also where the square of its length would over- or underflow; (0,0,0) for a
/// vector that is zero or not finite.
inline Vec3 normalize(Vec3 a) {
    const float square = dot(a, a);
    if (square > kMinSquare && square < kMaxSquare) return a / std::sqrt(square);
    const float largest = std::fmax(std::fabs(a.x), std::fmax(std::fabs(a.y), std::fabs(a.z)));
    if (!(largest > 0) || !isFinite(a)) return {};
    if (largest < 1e-15F || largest > 1e15F) {
        // Two divisions, since the reciprocal of a denormal number is infinite.
        a = a / largest;
    }
    return a / length(a);
}

/// Zero for zero. (A template, so that normalize({x, y, z}) means Vec3.)
template <std::same_as<double> T>
Vec3T<T> normalize(Vec3T<T> a) {
    const T l = length(a);
    return l > 0 ? a * (1 / l) : Vec3T<T>{};
}
/// The part of `a` across the z axis.
inline Vec3d horizontal(Vec3d a) { return {a.x, a.y, 0}; }

} // namespace rtcore
