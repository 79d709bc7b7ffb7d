/// Colours that tell values.
#pragma once

#include "rtcore/scene/image.h"

namespace rtcore {

/// From dark violet at 0 by blue and green to yellow at 1; beyond, as at the ends; NaN as at 0. Equal steps
/// look equal, and lightness grows with the value, so that it can be told in black and white and without
/// seeing red from green. (viridis: S. van der Walt, N. Smith and E. Firing 2015, CC0; 16 of its colours, and
/// lines between them)
Rgba8 valueColour(float value);

} // namespace rtcore
