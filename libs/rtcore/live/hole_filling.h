/// The picture of points, of some of which no light is known.
#pragma once

#include "rtcore/live/live_points.h"
#include "rtcore/render/frame.h"
#include "rtcore/render/pixel_area.h"

namespace rtcore {

/// Writes the area's pixels: the light of their points, or what lit points around them on the same surface
/// make likely, or, where there are none, the means of those around.
void showPoints(const LiveImage& image, const PixelArea& area, Frame& frame);

} // namespace rtcore
