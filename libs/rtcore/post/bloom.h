/// Bloom: light spread around what is bright, as in a lens or an eye. (thesis 5)
#pragma once

#include "rtcore/post/airy_blur.h"
#include "rtcore/post/effect.h"
#include "rtcore/post/gaussian_blur.h"
#include "rtcore/scene/image.h"
#include "rtcore/settings/render_settings.h"

namespace rtcore {

/// The standard deviation of the bloom, in pixels of an image that is `width` wide, when the settings ask
/// for another width: bloom has its size by the whole image. 0: none.
float bloomSigma(const RenderSettings& settings, int width);

/// (1 - share) image + share (kernel * image), of unbounded linear radiance. The light is spread, none
/// comes or goes. No threshold: what is dark blooms as well, invisibly.
class Bloom final : public Effect {
  public:
    const HdrImage& apply(const HdrImage& picture, const Aovs& aovs, const EffectRun& run) override;
    bool beginRows(const HdrImage& coarse, int block, const EffectRun& run) override;
    void changeRow(const RowPart& part, const Colour* radiance, Colour* changed) const override;

  private:
    void mix(const HdrImage& picture, float fraction, const EffectRun& run, HdrImage& result);

    GaussianBlur gaussian_;
    AiryBlur airy_;
    HdrImage result_;
    HdrImage spread_; ///< for rows: kernel * image
    int block_ = 1;   ///< pixels of a row's image for each of spread_
    float fraction_ = 0;
};

extern const EffectRow kBloomEffect;

/// The light that is spread to a pixel of an image that has `block` x `block` pixels for each of `spread`,
/// interpolated.
Colour spreadAt(const HdrImage& spread, int block, int x, int y);

} // namespace rtcore
