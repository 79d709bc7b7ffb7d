/// Pixels of one sample each, from arrays to the frame.
#pragma once

#include "rtcore/math/colour.h"

#include <cstddef>
#include <cstdint>

namespace rtcore {

/// Writes an 8 x 8 block: r, g, b and hit hold its samples by indexInBlock(); `pixels` and `covered` (255
/// where hit is 1, 0 where it is 0) are its upper left pixel in an image with rows of `width`.
void storeBlock(const float* r, const float* g, const float* b, const std::uint8_t* hit, std::size_t width,
                Colour* pixels, std::uint8_t* covered);

} // namespace rtcore
