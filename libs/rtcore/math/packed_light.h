/// Radiance in four bytes.
#pragma once

#include "rtcore/math/colour.h"

#include <cstdint>

namespace rtcore {

/// Three mantissas of 9 bits with one exponent of 5: within 1/512 of the largest channel, from 2^-15 to
/// 65408. (OpenGL's RGB9_E5)
std::uint32_t packLight(Colour light);
Colour unpackLight(std::uint32_t packed);

} // namespace rtcore
