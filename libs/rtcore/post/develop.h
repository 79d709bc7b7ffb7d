/// From radiance to what a display shows: effects, exposure, tone mapping, sRGB, eight bits. (thesis 3.2)
#pragma once

#include "rtcore/post/effect_chain.h"
#include "rtcore/post/exposure.h"
#include "rtcore/post/false_colours.h"
#include "rtcore/post/net_report.h"
#include "rtcore/post/tone_map_block.h"
#include "rtcore/render/frame.h"
#include "rtcore/render/pixel_area.h"
#include "rtcore/scene/image.h"
#include "rtcore/settings/render_settings.h"

#include <atomic>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace rtcore {

/// Develops frames one after another and keeps the memory of its threads, so that a frame of the size of the
/// one before it allocates nothing. Not for several threads at once: it uses `threads` itself, 0 = all cores.
/// The same input gives the same bits, for any number of threads.
class PictureDeveloper {
  public:
    /// The constant c of L = Y / (Y + c): the fixed value, or what suits the frame (exposure.h), without the
    /// effects: bloom would brighten what is dark.
    float exposure(const Frame& frame, const ExposureSettings& settings, int threads);

    /// The same where ExposureMode::Incident has what it needs, LightMeter's `white`: then that of a surface
    /// of albedo 0.9 in this light, whatever the frame is. Without it, as ExposureMode::Automatic, whose mean
    /// each curve shows as the thesis' does.
    float exposure(const Frame& frame, const RenderSettings& settings, std::optional<float> white,
                   int threads);

    /// The frame with the effects of EffectStage::Radiance. frame.radiance itself when there are none; else
    /// valid until the next call. A frame that is larger or smaller than the settings say gets effects in
    /// proportion. Of illuminance it is below 0 where no surface is seen at all, and not darker where one is
    /// seen in a part of a pixel. Returns soon, with an image that is undefined, when `stop` (may be null)
    /// becomes true. `netFraction` (may be null) gets how far a net is, 0..1.
    const HdrImage& finish(const Frame& frame, const RenderSettings& settings, int threads,
                           const std::atomic<bool>* stop = nullptr,
                           std::atomic<float>* netFraction = nullptr);

    /// The effects of EffectStage::Display, then tone mapping with the constant `exposure`, quantised into
    /// `image`, whose memory is reused when the size fits. Or false colours, in place of all that.
    void develop(const HdrImage& radiance, const RenderSettings& settings, float exposure, int threads,
                 LdrImage& image);
    /// The same for what finish() made of the frame. Where that has its background hidden, the image has
    /// straight alpha.
    void developFinished(const HdrImage& finished, const Frame& frame, const RenderSettings& settings,
                         float exposure, int threads, LdrImage& image);
    /// The same for finish() of the frame.
    void develop(const Frame& frame, const RenderSettings& settings, float exposure, int threads,
                 LdrImage& image);

    /// The unit of the light in images from now on, for false colours.
    void useUnit(const LuminanceUnit& unit) { unit_ = unit; }
    /// Whether the scale of false colours stays as it is while it roughly suits the images: for those that
    /// move.
    void holdScale(bool hold) { holdsScale_ = hold; }
    /// Those of the last develop(), for paintLegend(); null where it showed none.
    const FalseColours* falseColours() const { return falseColours_ ? &*falseColours_ : nullptr; }

    /// For images from now on whose settings ask for it (netOf()); null: they stay as they are.
    void useNet(std::shared_ptr<const UNet> net) { net_ = std::move(net); }
    /// What the net did in the last finish().
    const NetReport& netReport() const { return netReport_; }
    /// EstimatedError::pixels of its image; empty where they are not known.
    const std::vector<float>& netErrors() const { return netErrors_; }

  private:
    void paintFalseColours(const HdrImage& radiance, const RenderSettings& settings, int threads,
                           LdrImage& image);
    const HdrImage& onSurfaces(const Frame& frame, const HdrImage& finished);
    std::optional<float> average(const Frame& frame, bool background, int threads);
    const HdrImage& withBackground(const Frame& frame);

    std::vector<LuminanceHistogram> histograms_; ///< by thread
    EffectChain effects_;
    std::shared_ptr<const UNet> net_;
    NetReport netReport_;
    std::vector<float> netErrors_;
    std::vector<std::vector<Colour>> rows_; ///< by thread
    LuminanceUnit unit_;
    bool holdsScale_ = false;
    ScaleChoice scale_;
    HdrImage onSurfaces_, withBackground_, straight_;
    std::optional<FalseColours> falseColours_;
    std::vector<FalseColourPainter> painters_; ///< by thread
};

/// A part of what develop() makes of a frame's radiance, into an image of its size, by one thread. `effects`
/// know the image from afar, by EffectChain::beginRows(EffectStage::Radiance, ...) of a coarser one of the
/// same view; before that there are none. Reads no other pixels of `radiance`, so others may still be
/// rendered. With `how.falseColours` the part is that of FalseColourPainter, by those.
void developPart(const HdrImage& radiance, const Development& how, const EffectChain& effects,
                 const PixelArea& part, LdrImage& image);

} // namespace rtcore
