/// Vectors and colours in bulk, as vector code likes them.
#pragma once

#include "rtcore/math/colour.h"
#include "rtcore/math/vec.h"

#include <cstddef>

namespace rtcore {

/// Three arrays that are one array of vectors or colours.
struct ArraysOf3 {
    float *x = nullptr, *y = nullptr, *z = nullptr;

    Vec3 at(std::size_t i) const { return {x[i], y[i], z[i]}; }
    void set(std::size_t i, Vec3 v) const { x[i] = v.x, y[i] = v.y, z[i] = v.z; }
    Colour colourAt(std::size_t i) const { return {x[i], y[i], z[i]}; }
    void set(std::size_t i, Colour c) const { x[i] = c.r, y[i] = c.g, z[i] = c.b; }
    /// Without the first of them.
    ArraysOf3 from(std::size_t first) const { return {x + first, y + first, z + first}; }
};

} // namespace rtcore
