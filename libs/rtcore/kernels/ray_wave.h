/// Rays in bulk: thousands at once, as one array for each coordinate, so that vector code loads them
/// directly.
#pragma once

#include "rtcore/kernels/arrays_of_3.h"
#include "rtcore/math/vec.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace rtcore {

inline constexpr std::uint32_t kNoTriangle = 0xFFFFFFFFU;
/// While rays are traced, a bit in the number of a triangle that is one of several as near.
inline constexpr std::uint32_t kTiedHit = 0x80000000U;

/// A half-line or segment: origin + t * direction, 0 <= tMin <= t <= tMax; empty where tMin > tMax or tMax <
/// 0. The direction must be finite and not zero; its length is free (t is in units of it) from 1e-30 to 1e30:
/// beyond, distances leave the range of single precision, and what is hit at them is left open.
struct Ray {
    Vec3 origin;
    float tMin = 0;
    Vec3 direction;
    float tMax = 0;
};

/// The closest hit: position = (1-u-v) p0 + u p1 + v p2 of the triangle.
struct Hit {
    float t = 0;
    std::uint32_t triangle = kNoTriangle;
    float u = 0, v = 0;
};

/// The purpose of rays; decides how they are traced and how they are counted, never what they find.
enum class RayKind { Primary, Shadow, Mirror, Refracted, Occlusion, Scattered };
inline constexpr int kRayKinds = 6;

/// A queue of rays. clear() keeps the memory, so that a steady frame does not allocate.
struct RayWave {
    std::vector<float> ox, oy, oz, dx, dy, dz, tMin, tMax;

    std::size_t size() const { return ox.size(); }
    bool empty() const { return ox.empty(); }
    void clear();
    void reserve(std::size_t count);
    void push(const Ray& ray);
    /// Adds `count` rays of another wave.
    void append(const RayWave& from, std::size_t first, std::size_t count);
    /// Keeps the first `count` rays; those beyond the present ones are all zero.
    void resize(std::size_t count);
    Ray ray(std::size_t i) const { return {{ox[i], oy[i], oz[i]}, tMin[i], {dx[i], dy[i], dz[i]}, tMax[i]}; }
    ArraysOf3 origins() { return {ox.data(), oy.data(), oz.data()}; }
    ArraysOf3 directions() { return {dx.data(), dy.data(), dz.data()}; }
};

/// One hit for each ray of a wave; a miss has triangle = kNoTriangle and undefined t, u, v.
struct HitWave {
    std::vector<float> t, u, v;
    std::vector<std::uint32_t> triangle;
    /// Empty, or for each hit how far off it, at least, rays have to start that leave: more than
    /// surfaceClearance() of its triangle where other surfaces lie in its plane (one_surface.h), else 0.
    std::vector<float> clearance;

    std::size_t size() const { return t.size(); }
    /// Forgets `clearance`.
    void resize(std::size_t count);
    /// Becomes `count` hits of another wave.
    void take(const HitWave& from, std::size_t first, std::size_t count);
    /// The hit `i` becomes the hit `j` of another wave.
    void put(std::size_t i, const HitWave& from, std::size_t j);
    float clearanceOf(std::size_t i) const { return clearance.empty() ? 0 : clearance[i]; }
    bool isHit(std::size_t i) const { return triangle[i] != kNoTriangle; }
    Hit hit(std::size_t i) const { return {t[i], triangle[i], u[i], v[i]}; }
    void set(std::size_t i, const Hit& hit) {
        t[i] = hit.t;
        triangle[i] = hit.triangle;
        u[i] = hit.u;
        v[i] = hit.v;
    }
};

} // namespace rtcore
