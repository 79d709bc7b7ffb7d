/// Four numbers at once, in what every processor of the baseline has. For a box, whose three axes are one
/// vector; loops over many things choose wider vectors when the program runs.
#pragma once

#include <cstdint>
#include <cstring>

namespace rtcore {

using Float4 = float __attribute__((vector_size(16)));
using Int4 = std::int32_t __attribute__((vector_size(16)));

inline Float4 load4(const float* from) {
    Float4 v;
    std::memcpy(&v, from, sizeof v);
    return v;
}
inline void store4(Float4 v, float* to) { std::memcpy(to, &v, sizeof v); }
inline Float4 set4(float x) { return Float4{x, x, x, x}; }
inline Float4 min4(Float4 a, Float4 b) { return a < b ? a : b; }
inline Float4 max4(Float4 a, Float4 b) { return a > b ? a : b; } // b when a is not a number
/// Towards zero.
inline Int4 truncate4(Float4 v) { return __builtin_convertvector(v, Int4); }

} // namespace rtcore
