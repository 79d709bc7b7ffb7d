/// Vectors of double, for positions that many small moves add up to. Plain aggregates.
#pragma once

#include <cmath>

namespace rtcore {

struct Vec3d {
    double x = 0, y = 0, z = 0;

    friend bool operator==(const Vec3d&, const Vec3d&) = default;
    friend Vec3d operator-(Vec3d a) { return {-a.x, -a.y, -a.z}; }
    friend Vec3d operator+(Vec3d a, Vec3d b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
    friend Vec3d operator-(Vec3d a, Vec3d b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
    friend Vec3d operator*(Vec3d a, double s) { return {a.x * s, a.y * s, a.z * s}; }
    Vec3d& operator+=(Vec3d b) { return *this = *this + b; }
};

inline double dot(Vec3d a, Vec3d b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline Vec3d cross(Vec3d a, Vec3d b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline double length(Vec3d a) { return std::sqrt(dot(a, a)); }
inline bool isFinite(Vec3d a) { return std::isfinite(a.x) && std::isfinite(a.y) && std::isfinite(a.z); }
/// Zero for zero.
inline Vec3d normalize(Vec3d a) {
    const double l = length(a);
    return l > 0 ? a * (1 / l) : Vec3d{};
}
/// The part of `a` across the z axis.
inline Vec3d horizontal(Vec3d a) { return {a.x, a.y, 0}; }

} // namespace rtcore
