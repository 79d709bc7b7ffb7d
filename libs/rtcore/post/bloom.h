/// Glow around what is bright, as in a lens or an eye. (thesis 5)
#pragma once

#include "rtcore/post/airy_blur.h"
#include "rtcore/post/gaussian_blur.h"
#include "rtcore/scene/image.h"
#include "rtcore/settings/render_settings.h"

namespace rtcore {

/// The standard deviation of the glow, in pixels of a picture that is `width` wide, when the settings ask for
/// another width: glow has its size by the whole picture. 0: none.
float bloomSigma(const RenderSettings& settings, int width);

/// (1 - share) picture + share (kernel * picture), of unbounded linear radiance. The light is spread, none
/// comes or goes. No threshold: what is dark glows as well, but nobody sees it. Keeps its memory from picture
/// to picture; not for several threads at once.
class Bloom {
  public:
    /// Sets `glow` to kernel * picture.
    void spread(const HdrImage& radiance, const RenderSettings& settings, int threads, HdrImage& glow);
    /// The picture with its glow, valid until the next call. `radiance` itself when there is none.
    const HdrImage& apply(const HdrImage& radiance, const RenderSettings& settings, int threads);

  private:
    GaussianBlur gaussian_;
    AiryBlur airy_;
    void mix(const HdrImage& radiance, const RenderSettings& settings, float share, int threads,
             HdrImage& result);

    HdrImage result_;
};

/// One pixel: glow where there is some.
inline Colour withGlow(Colour radiance, Colour glow, float share) {
    if (share >= 1) return glow;
    return radiance * (1 - share) + glow * share;
}

/// The glow at a pixel of a picture that has `block` x `block` pixels for each of `glow`, interpolated.
Colour glowAt(const HdrImage& glow, int block, int x, int y);

} // namespace rtcore
