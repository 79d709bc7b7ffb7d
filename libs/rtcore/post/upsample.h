/// Upsampling of a small image, for a quick first look.
#pragma once

#include "rtcore/scene/image.h"

namespace rtcore {

/// Fills `image`, whose size is set: pixel (x, y) of `small` stands in the middle of the square of `block` x
/// `block` pixels from (x * block, y * block) on, and what lies between is interpolated, in the eight bits of
/// the display. `small` has a pixel for each square, also for those that the edge cuts; block is 2, 4 or 8.
/// `threads` = 0: all cores.
void upsample(const LdrImage& small, int block, int threads, LdrImage& image);

} // namespace rtcore
