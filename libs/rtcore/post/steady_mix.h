/// The image that a net made, mixed with a steady one: Whitted's rays with the light of irradiance records,
/// which has no noise and is the same for every seed, but is wrong here and there.
///
/// Q is the steady image, N the net's, P the sampled one; N(A), N(B) are the net's of the halves A and B of
/// the samples (net_mix.h), and shown = Q + k (N - Q). Squares and products, pooled over the channels and
/// some 8 x 8 pixels, and counted in proportion to brightness:
///     G, the gain     (Q - P)(Q - N) - (N(A) - N(B))(A - B) / 4: the expected product of the error of Q and
///                     of Q - N, since noise that P and N have in common is taken out
///     D, apart        (Q - N)^2
///     F, flicker      (N(A) - N(B))^2 / 4, the variance of N
/// k = G / D would leave the smallest error; G / (D + 2 F) gives some of that for less flicker. Of few
/// samples G says little at one place. So k there is a mean of what its pool says and of what the whole image
/// says, each by how sure it is. Where N and Q differ by far more than N varies around there (D beside F)
/// k goes to 1 whatever G says: most often Q lacks light there, and else the image is no worse than N.
#pragma once

#include "rtcore/post/net_mix.h"
#include "rtcore/render/sample_halves.h"
#include "rtcore/scene/image.h"

#include <vector>

namespace rtcore {

/// Images that a net made: of all samples, and of each half of them.
struct NetImages {
    HdrImage& all;
    HdrImage& first;
    HdrImage& second;
};

/// All of one size, which is not 0.
struct SteadyMixInput {
    const HdrImage& sampled;
    const HdrImage& steady;
    const SampleHalves& halves;                 ///< of at least kSteadySamples
    const std::vector<PixelCoverage>& coverage; ///< per pixel
};

/// Mixes the steady image into all three, so that what is known by the halves holds of the mixed ones, too.
/// Pixels that surfaces do not cover stay, and those whose steady radiance is not finite. Uses `threads`
/// itself (0 = all cores), with the same bits for any number of them.
void mixWithSteady(const SteadyMixInput& input, const NetImages& net, int threads);

/// The same of too few samples for halves: the mean of both, in `net`.
void mixEvenly(const HdrImage& steady, const std::vector<PixelCoverage>& coverage, HdrImage& net,
               int threads);

} // namespace rtcore
