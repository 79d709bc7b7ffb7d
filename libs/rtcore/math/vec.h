/// Small vectors of float. Plain aggregates: no invariants, any bit pattern is a value.
#pragma once

#include <cmath>

namespace rtcore {

struct Vec2 {
    float x = 0, y = 0;
    friend bool operator==(const Vec2&, const Vec2&) = default;
};

struct Vec3 {
    float x = 0, y = 0, z = 0;

    float operator[](int axis) const { return axis == 0 ? x : axis == 1 ? y : z; }
    float& operator[](int axis) { return axis == 0 ? x : axis == 1 ? y : z; }

    friend bool operator==(const Vec3&, const Vec3&) = default;
    friend Vec3 operator-(Vec3 a) { return {-a.x, -a.y, -a.z}; }
    friend Vec3 operator+(Vec3 a, Vec3 b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
    friend Vec3 operator-(Vec3 a, Vec3 b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
    friend Vec3 operator*(Vec3 a, float s) { return {a.x * s, a.y * s, a.z * s}; }
    friend Vec3 operator*(float s, Vec3 a) { return a * s; }
    friend Vec3 operator/(Vec3 a, float s) { return {a.x / s, a.y / s, a.z / s}; }
    Vec3& operator+=(Vec3 b) { return *this = *this + b; }
    Vec3& operator*=(float s) { return *this = *this * s; }
};

inline float dot(Vec3 a, Vec3 b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline Vec3 cross(Vec3 a, Vec3 b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline float length(Vec3 a) { return std::sqrt(dot(a, a)); }
inline bool isFinite(Vec3 a) { return std::isfinite(a.x) && std::isfinite(a.y) && std::isfinite(a.z); }

/// The unit vector along `a`, also where the square of its length would over- or underflow; (0,0,0) for a
/// vector that is zero or not finite.
inline Vec3 normalize(Vec3 a) {
    const float square = dot(a, a);
    if (square > 1e-28F && square < 1e28F) return a / std::sqrt(square);
    const float largest = std::fmax(std::fabs(a.x), std::fmax(std::fabs(a.y), std::fabs(a.z)));
    if (!(largest > 0) || !isFinite(a)) return {};
    if (largest < 1e-15F || largest > 1e15F) {
        // Two divisions, since the reciprocal of a denormal number is infinite.
        a = a / largest;
    }
    return a / length(a);
}

/// Two unit vectors that complete the unit vector `n` to a right-handed basis (Duff et al. 2017, "Building an
/// Orthonormal Basis, Revisited").
struct Basis {
    Vec3 tangent, bitangent;
};
inline Basis basisAround(Vec3 n) {
    const float sign = std::copysign(1.0F, n.z);
    const float a = -1.0F / (sign + n.z);
    const float b = n.x * n.y * a;
    return {{1.0F + sign * n.x * n.x * a, sign * b, -sign * n.x}, {b, sign + n.y * n.y * a, -n.y}};
}

} // namespace rtcore
