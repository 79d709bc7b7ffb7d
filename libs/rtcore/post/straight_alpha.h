/// From images without their background to colours with an alpha of their own ("straight", not
/// premultiplied), as PNG and most programs have them.
#pragma once

#include "rtcore/math/colour.h"
#include "rtcore/scene/image.h"

#include <vector>

namespace rtcore {

/// How much of the background is hidden, 0..1, where that part of it is seen.
float alphaOf(Colour transmitted);
/// The same of each pixel, for a channel of a file.
std::vector<float> alphasOf(const HdrImage& transmitted);

/// The radiance of what is before the background, as if it filled each pixel; as it is where nothing is.
void straighten(const HdrImage& radiance, const HdrImage& transmitted, HdrImage& straight);

/// Sets the alpha of each pixel; black where it is 0. The images have one size.
void setAlpha(const HdrImage& transmitted, LdrImage& image);

} // namespace rtcore
