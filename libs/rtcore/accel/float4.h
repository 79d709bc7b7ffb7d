/// Four numbers at once, in what every processor of the baseline has. For a box, whose three axes are one
/// vector; loops over many things choose wider vectors when the program runs.
#pragma once

#include "rtcore/math/box.h"
#include "rtcore/scene/mesh.h"

#include <cstddef>
#include <cstdint>
#include <cstring>

namespace rtcore {

using Float4 = float __attribute__((vector_size(16)));
using Int4 = std::int32_t __attribute__((vector_size(16)));

inline Float4 load4(const void* from) {
    Float4 v;
    std::memcpy(&v, from, sizeof v);
    return v;
}
inline void store4(Float4 v, void* to) { std::memcpy(to, &v, sizeof v); }
inline Float4 set4(float x) { return Float4{x, x, x, x}; }
inline Float4 min4(Float4 a, Float4 b) { return a < b ? a : b; }
inline Float4 max4(Float4 a, Float4 b) { return a > b ? a : b; } // b when a is not a number
/// Towards zero.
inline Int4 truncate4(Float4 v) { return __builtin_convertvector(v, Int4); }

struct Bounds4 {
    Float4 lo, hi; ///< the fourth numbers mean nothing
};

inline Box3 boxOf(const Bounds4& b) { return {{b.lo[0], b.lo[1], b.lo[2]}, {b.hi[0], b.hi[1], b.hi[2]}}; }

/// Keeps the numbers of `a` where both are equal, as std::min does.
inline Bounds4 extended(const Bounds4& a, const Bounds4& b) { return {min4(b.lo, a.lo), max4(b.hi, a.hi)}; }

/// The box of a triangle of the mesh.
inline Bounds4 boundsOf(const Mesh& mesh, std::size_t triangle) {
    const auto corner = [&](int k) { return load4(&mesh.vertices[mesh.triangles[triangle].v[k]]); };
    const Float4 a = corner(0);
    const Float4 b = corner(1);
    const Float4 c = corner(2);
    return extended(extended({a, a}, {b, b}), {c, c});
}

} // namespace rtcore
