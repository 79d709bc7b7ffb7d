/// Makes images smaller.
#pragma once

#include "bridge/stream/pixels.h"

#include <cstddef>
#include <vector>

namespace bridge {

/// Each pixel is the mean of what it covers, of parts of pixels their part, rounded. `width` and `height`: 1
/// to those of `pixels`. `out` gets the bytes; the fourth of each pixel is 255.
Pixels shrink(const Pixels& pixels, int width, int height, std::vector<std::byte>& out);

} // namespace bridge
