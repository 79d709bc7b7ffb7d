/// An image as a lens without flaws shows it: each point becomes a disc with rings, by diffraction at its
/// round aperture. Red has larger ones than blue.
#pragma once

#include "rtcore/post/cosine_transform.h"
#include "rtcore/scene/image.h"

#include <optional>
#include <vector>

namespace rtcore {

/// Airy's pattern (2 J1(x) / x)^2 for light of 650, 532 and 450 nm in red, green and blue, averaged over the
/// area of each pixel. It is applied as a product of spectra, where it is known in closed form - the overlap
/// of two apertures (Goodman, Introduction to Fourier Optics, 6.3), with those frequencies folded back that
/// the pixels cannot hold - so that none of its wide rings is cut off. Borders are mirrors as in
/// GaussianBlur. Keeps its memory from image to image; not for several threads at once.
class AiryBlur {
  public:
    /// `sigma` >= 0.25 in pixels: that of the Gaussian which has the peak and the volume of the green
    /// pattern. The first dark ring of green has the radius 2.7096 sigma, of red 3.3106, of blue 2.2920.
    /// The rest as in GaussianBlur::blur.
    void blur(const HdrImage& image, float sigma, float fraction, int threads, HdrImage& result);

  private:
    std::optional<CosineTransform> across_, down_;
    std::vector<TransformScratch> scratch_; ///< by thread
    std::vector<float> pixelY_;
};

/// How much of the frequency (x, y), in cycles a pixel, Airy's pattern keeps that ends at `cutoff`; sampled
/// at pixels and averaged over their area. 1 at zero.
float airyResponse(float x, float y, float cutoff);

} // namespace rtcore
