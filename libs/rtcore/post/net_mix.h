/// The image that a net made, mixed with the sampled one by what is known of the errors of both.
///
/// With the halves A and B of the samples (render/sample_halves.h), P the mean of all, and nets N(A), N(B) of
/// each alone, Q is the mean of N(A) and N(B). N(A) knows nothing of the noise of B, so that N(A) - B holds
/// the net's error and that noise, and the noise is known by A - B. Expected squares, pooled over the channels
/// and some 8 x 8 pixels:
///     of one net    ((N(A) - B)^2 + (N(B) - A)^2) / 2 - (A - B)^2 / 2
///     E of Q        the same less (N(A) - N(B))^2 / 4, which averaging takes away
///     V of P        f (1 - f) (A - B)^2, with f the fraction of A among the samples
/// and shown = Q + k (P - Q), k = E / (E + V): the net where it is right and P has noise, P where the net is
/// wrong, and P in the end, since V falls as samples come and E does not. V is that of 3 x 3 pixels where that
/// is larger. Squares count in proportion to brightness, so that a bright spot does not rule its surroundings.
#pragma once

#include "rtcore/render/sample_halves.h"
#include "rtcore/scene/image.h"

#include <cstdint>
#include <vector>

namespace rtcore {

/// How much of a pixel surfaces cover. Pixels are pooled with those of the same: colour is over black.
enum class PixelCoverage : std::uint8_t { None, Part, Full };

/// All of one size, which is not 0.
struct NetMixInput {
    const HdrImage& sampled;
    const SampleHalves& halves;
    const HdrImage& netFirst;
    const HdrImage& netSecond;
    const std::vector<PixelCoverage>& coverage; ///< per pixel
};

/// The estimated error of an image, root mean square of the channels, in codes of 255 of a display that shows
/// it by the exposure that a net takes (exposureForNet) and the curve `luminance`.
struct EstimatedError {
    float all = 0;          ///< of the whole image
    float largestBlock = 0; ///< of the 8 x 8 pixels where it is largest
};

/// Mixes into `shown`, which may be `netFirst`. Pixels that all samples saw as background are those of
/// `sampled` to the bit, and so are those whose sampled standard error is below a quarter of a code, by a
/// smooth transition that ends at one code. Uses `threads` itself (0 = all cores), with the same bits for any
/// number of them.
EstimatedError mixWithNet(const NetMixInput& input, HdrImage& shown, int threads);

} // namespace rtcore
