/// The image that a net made, mixed with the sampled one by what is known of the errors of both.
///
/// P is the mean of all samples, Q what the net makes of it, and shown = Q + k (P - Q). A and B are the
/// halves of the samples (render/sample_halves.h), f the fraction of A, N(A) and N(B) what the net makes of
/// each alone: N(A) knows nothing of the noise of B, so that N(A) - B holds the error of one and the noise of
/// the other and nothing of both. Expected squares and products, pooled over the channels and some 8 x 8
/// pixels:
///     V, the variance of P             f (1 - f) (A - B)^2
///     C, the noise of P that Q has     half of that of N(A): the mean of (N(A) - B) (A - B) and
///                                      (N(B) - A) (B - A), less (A - B)^2 / 2
///     D, apart                         (Q - P)^2 = E + V - 2 C
///     E, the squared error of Q        D - V + 2 C, and at least (N(A) - N(B))^2 / 4, the net's own variance
/// k = (E - C) / D leaves the smallest error: the net where it is right, P where the net is wrong, and P in
/// the end, since V and C fall as samples come and E does not. E - C counts less its standard error, and V is
/// that of 3 x 3 pixels where that is larger: of what is not sure, the net's image is shown. Squares count in
/// proportion to brightness, so that a bright spot does not rule its surroundings.
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
    const HdrImage& net; ///< of all samples
    const SampleHalves& halves;
    const HdrImage& netFirst;
    const HdrImage& netSecond;
    const std::vector<PixelCoverage>& coverage; ///< per pixel
};

/// The estimated error of an image, root mean square of the channels, in codes of 255 of a display that shows
/// it by the exposure that a net takes (exposureForNet) and the curve `luminance`: those by which a pixel
/// gets brighter once its standard error is added.
struct EstimatedError {
    float all = 0;             ///< of the whole image
    float largestBlock = 0;    ///< of the 8 x 8 pixels where it is largest
    std::vector<float> pixels; ///< of each, by the 8 x 8 around it

    static constexpr std::size_t kBytesPerPixel = sizeof(float);
};

/// Mixes into `shown`, which may be `net`. Pixels that all samples saw as background are those of
/// `sampled` to the bit, and so are those whose sampled standard error is below a quarter of a code, by a
/// smooth transition that ends at half a code; unless the pixels around them are so noisy, by more than 5
/// codes, that these have missed what others found. Of less than kMixedSamples the net's image is shown
/// alone. Uses `threads` itself (0 = all cores), with the same bits for any number of them.
EstimatedError mixWithNet(const NetMixInput& input, HdrImage& shown, int threads);

} // namespace rtcore
