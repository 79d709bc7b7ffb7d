/// Exposure that suits a picture, as an eye would choose it.
#pragma once

#include "rtcore/math/colour.h"

#include <cstdint>
#include <optional>
#include <span>

namespace rtcore {

/// The robust log-average luminance: of the pixels with luminance > 0, without the darkest and brightest
/// tenth, each weighted by `weights` (255: geometry counts, 0: background does not). Nothing when the weight
/// on such pixels is less than 1 % of what a picture full of geometry has. The spans have one size. The same
/// bits for the same input.
std::optional<float> logAverageLuminance(std::span<const Colour> pixels,
                                         std::span<const std::uint8_t> weights);

} // namespace rtcore
