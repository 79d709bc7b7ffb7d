/// The background behind an image whose noise was taken away without it.
#pragma once

#include "rtcore/post/effect.h"

namespace rtcore {

/// Adds to `image` what is seen of a background of that colour; `transmitted` as Frame::transmitted.
void addBackground(const HdrImage& transmitted, Colour behind, HdrImage& image);

/// Whether images of those settings are to be rendered apart from their background, Background::Apart: all
/// light of paths is filtered, so that outlines would blur into what is behind them.
bool rendersApart(const RenderSettings& settings);

/// EffectRun::transmitted and behind, after all that takes noise away.
class BackgroundEffect final : public Effect {
  public:
    const HdrImage& apply(const HdrImage& picture, const Aovs& aovs, const EffectRun& run) override;

  private:
    HdrImage result_;
};

extern const EffectRow kBackgroundEffect;

} // namespace rtcore
