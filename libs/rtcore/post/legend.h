/// The scale of false colours, painted into an image.
#pragma once

#include "rtcore/post/false_colours.h"
#include "rtcore/scene/image.h"

namespace rtcore {

/// At the left edge: a bar of the colours with its isovalues, and "cd/m^2" above it or "relative" where the
/// image has no absolute unit; of illuminance that word and "lux". Nothing where `how` has no legend.
/// `height` is that of the whole image: a smaller one, to be upsampled, has a smaller legend. Images of whole
/// ones below 120 x 90 have none.
void paintLegend(const FalseColours& how, int height, LdrImage& image);

} // namespace rtcore
