/// How far a picture on the screen is from the one that should be there.
#pragma once

#include "rtcore/scene/image.h"
#include "support/flip.h"

namespace bench {

struct PictureErrors {
    double psnr = 0; ///< decibels, of the displayed codes
    double flip = 0; ///< mean, 0..1
    /// Of displayed light: mean of (x - r)^2 / (r^2 + 0.01 mean^2); beside paths LightErrors, of radiance.
    double relMse = 0;
    double blocks = 0; ///< LightErrors::blocks, beside paths
    double bias = 0;   ///< the same: mean of x - r in parts of the mean of r
    /// Both of what a turn from the camera before brought into view (uncoveredByTurn()); 0 if nothing.
    double uncoveredBlocks = 0, uncoveredBias = 0;
    double change = 0; ///< changeOfLight() from the picture before, beside paths; 0 of the first one
};

/// A frame smaller than the window, as the window draws it: interpolated linearly.
rtcore::LdrImage upsampled(const rtcore::LdrImage& image, int width, int height);

PictureErrors errorsOf(const rtcore::LdrImage& image, const rtcore::LdrImage& reference,
                       const test::Flip& flip);

} // namespace bench
