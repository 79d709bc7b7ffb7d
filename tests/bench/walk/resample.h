/// Radiance in other pixels, for comparison with images of the same camera that have these.
#pragma once

#include "rtcore/scene/image.h"

namespace bench {

/// What an image of `width` x `height` pixels shows of it, if both are of one camera: the left and right
/// edges are the same, pixels are squares, and the middles lie on each other. Each pixel is the mean over its
/// square, which cuts pixels of `image` where sizes are no multiples. Not wider than `image`, and of about
/// its shape: squares beyond its upper and lower edge are cut there, and each has a part inside.
rtcore::HdrImage averagedDown(const rtcore::HdrImage& image, int width, int height);

/// An image with the same edges, interpolated linearly between the middles of its pixels: unlike
/// rtcore::upsample() it keeps all light, however much brighter than the rest a part is.
rtcore::HdrImage interpolated(const rtcore::HdrImage& image, int width, int height);

} // namespace bench
