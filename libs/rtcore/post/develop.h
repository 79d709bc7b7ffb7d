/// From radiance to what a display shows: glow, exposure, tone mapping, sRGB, eight bits. (thesis 3.2)
#pragma once

#include "rtcore/post/bloom.h"
#include "rtcore/post/denoise.h"
#include "rtcore/post/exposure.h"
#include "rtcore/post/local_exposure.h"
#include "rtcore/render/frame.h"
#include "rtcore/render/pixel_area.h"
#include "rtcore/scene/image.h"
#include "rtcore/settings/render_settings.h"

#include <atomic>
#include <optional>
#include <vector>

namespace rtcore {

/// What a part of a picture has from all of it, known from a coarser picture of the same view.
struct RoughEffects {
    HdrImage glow;       ///< Bloom::spread(); empty: none
    int block = 1;       ///< pixels of the picture for each of the coarse one, across and down
    LocalExposure local; ///< where it is asked for
};

/// Develops frames one after another and keeps the memory of its threads, so that a frame of the size of the
/// one before it allocates nothing. Not for several threads at once: it uses `threads` itself, 0 = all cores.
/// The same input gives the same bits, for any number of threads.
class PictureDeveloper {
  public:
    /// The constant c of L = Y / (Y + c): the fixed value, or what suits the frame (exposure.h), without the
    /// effects below: glow would brighten what is dark.
    float exposure(const Frame& frame, const ExposureSettings& settings, int threads);

    /// The frame with the effects that need all of it: denoised, and with its glow. frame.radiance itself
    /// when there are none; else valid until the next call. A frame that is larger or smaller than the
    /// settings say gets effects in proportion. Returns soon, with a picture that is undefined, when `stop`
    /// (may be null) becomes true.
    const HdrImage& finish(const Frame& frame, const RenderSettings& settings, int threads,
                           const std::atomic<bool>* stop = nullptr);

    /// Tone maps with the constant `exposure` and quantises into `image`, whose memory is reused when the
    /// size fits.
    void develop(const HdrImage& radiance, const RenderSettings& settings, float exposure, int threads,
                 LdrImage& image);
    /// The same for finish() of the frame.
    void develop(const Frame& frame, const RenderSettings& settings, float exposure, int threads,
                 LdrImage& image);

    /// For parts of a picture of which `coarse` has a pixel for each `block` x `block`.
    void roughEffects(const Frame& coarse, int block, const RenderSettings& settings, float exposure,
                      int threads, RoughEffects& effects);

  private:
    std::optional<float> average(const Frame& frame, bool background, int threads);

    std::vector<LuminanceHistogram> histograms_; ///< by thread
    Denoiser denoiser_;
    Bloom bloom_;
    LocalExposure local_;
    std::vector<std::vector<Colour>> rows_; ///< by thread
};

/// A part of what develop() makes, into an image of the frame's size, by one thread; with `effects` in place
/// of finish(). Reads nothing else of the frame's pixels, so others may still be rendered.
void developPart(const Frame& frame, const RenderSettings& settings, float exposure,
                 const RoughEffects& effects, const PixelArea& part, LdrImage& image);

/// The same for a single frame, on all cores.
float exposureFor(const Frame& frame, const ExposureSettings& settings);
LdrImage develop(const Frame& frame, const RenderSettings& settings, float exposure);

} // namespace rtcore
