/// Bright dots: pixels that a path left far too bright when it found a small bright thing by chance. A net
/// takes one for a thing, and makes a blot of it.
#pragma once

#include "rtcore/render/sample_halves.h"
#include "rtcore/scene/image.h"

#include <cstddef>

namespace rtcore {

/// Dots that were taken from a net's input.
struct TakenDots {
    std::size_t pixels = 0; ///< that were clamped
    double light = 0;       ///< luminances taken, summed over pixels
};

/// Copies `half`, of which `other` is the other one, into `input`, with each bright dot clamped: a pixel more
/// than sixteen times as bright as each of its eight neighbours, and as `other` there, counts as sixteen
/// times as bright as the brightest of these. Its own noise explains what is above: both halves have seen
/// what is really there. Less than that is mostly light that the samples around have missed. The colour of a
/// dot stays. Not in place. The same bits for any number of threads.
TakenDots copyWithoutDots(const HdrImage& half, const HdrImage& other, HdrImage& input, int threads);

} // namespace rtcore
