/// A usual display, which says how much errors of radiance count.
#pragma once

#include "rtcore/neural/transfer.h"
#include "rtcore/scene/image.h"
#include "rtcore/simd/portable_math.h"

#include <algorithm>
#include <cmath>

namespace rtcore {

/// How bright and how coarse a usual display shows a radiance.
class UsualDisplay {
  public:
    UsualDisplay(const HdrImage& image, int threads)
        : scale_(exposureForNet({&image.pixels[0].r, sizeof(Colour) / sizeof(float)}, image.width,
                                image.height, threads)) {}

    /// Codes of 255 for a radiance near that luminance.
    double codes(float luminance) const {
        const float x = std::max(luminance, 0.0F) * scale_, shown = x / (1 + x);
        const float slope =
            shown <= 0.0031308F ? 12.92F : 1.055F / 2.4F * portablePow(shown, 1.0F / 2.4F - 1);
        return static_cast<double>(255 * scale_ * slope / ((1 + x) * (1 + x)));
    }
    /// Codes by which a radiance of that luminance is shown brighter once `error` is added: no more than the
    /// display has left.
    double codesOf(float luminance, double error) const {
        const auto shown = [&](double light) {
            const auto x = static_cast<float>(std::min(light * static_cast<double>(scale_), 1e30));
            return static_cast<double>(srgbEncode(x / (1 + x)));
        };
        const double light = std::max(static_cast<double>(luminance), 0.0);
        return std::isfinite(light + error) ? 255 * (shown(light + error) - shown(light)) : 255;
    }
    /// What a squared error at that luminance counts.
    double weight(float luminance) const {
        const double x = static_cast<double>(luminance) * static_cast<double>(scale_ / kKey);
        return 1 / (x * x + kDarkest);
    }

  private:
    static constexpr float kKey = 0.18F;     ///< of the usual exposure
    static constexpr double kDarkest = 0.01; ///< what squares of darker pixels count as, of the mean's
    float scale_;
};

} // namespace rtcore
