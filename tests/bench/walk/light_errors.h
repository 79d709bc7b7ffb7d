/// How far the light of an image is from that of two references with noise of their own.
#pragma once

#include "rtcore/scene/image.h"

#include <vector>

namespace bench {

struct LightErrors {
    /// Mean over pixels of (x - a)(x - b) / (r^2 + 0.01 mean^2), with r = (a + b) / 2: of independent
    /// references, so that their noise drops out of the mean, which may come out below 0 where the image has
    /// hardly an error. It stays in r, so figures compare by the same references only. Without the thousandth
    /// of the pixels in which the references differ most, as scripts/lights and scripts/denoising compute it.
    double relMse = 0;
    /// Mean over squares of 8 x 8 pixels of how far their luminance is from the references' mean, in parts of
    /// that and a tenth of the image's: what is seen as blotches. The references' noise stays in it.
    double blocks = 0;
    double bias = 0; ///< mean of x - r in parts of the mean of r, over all pixels
};

/// All have one size. Rendered from one camera by samples of their own, `one` and `other` are independent.
LightErrors lightErrors(const rtcore::HdrImage& image, const rtcore::HdrImage& one,
                        const rtcore::HdrImage& other);

/// `bias` and `blocks` of those pixels alone, and of those squares of which all pixels are among them; relMse
/// is 0. `pixels` has one entry for each.
LightErrors lightErrorsOf(const std::vector<bool>& pixels, const rtcore::HdrImage& image,
                          const rtcore::HdrImage& one, const rtcore::HdrImage& other);

/// How much luminance changes from one image to the next, which has its size: mean over pixels of the
/// absolute difference, in parts of the mean of `before`.
double changeOfLight(const rtcore::HdrImage& before, const rtcore::HdrImage& now);

} // namespace bench
