/// Removes the noise of paths by a trained net.
#pragma once

#include "rtcore/neural/net_denoiser.h"
#include "rtcore/neural/net_files.h"
#include "rtcore/post/bright_dots.h"
#include "rtcore/post/effect.h"
#include "rtcore/post/net_mix.h"
#include "rtcore/post/net_report.h"
#include "rtcore/scene/image.h"
#include "rtcore/settings/render_settings.h"

#include <optional>
#include <vector>

namespace rtcore {

/// The net of the settings; nothing where they use none.
std::optional<Net> netOf(const RenderSettings& settings);

/// The U-Net of Open Image Denoise over radiance and the frame's guides. Pixels that all of their rays and
/// samples saw as background have no noise, and stay to the bit; so does the whole image without
/// EffectRun::net, or without guides of its size. With halves of at least kEstimatedSamples the net runs
/// three times: its error is known then, bright dots are kept from it, and from kMixedSamples on it is mixed
/// with the sampled image (net_mix.h). With EffectRun::steady it is mixed with that before, from
/// kSteadySamples on by the same halves (steady_mix.h), else evenly. Not for parts of previews.
class NetDenoise final : public Effect {
  public:
    const HdrImage& apply(const HdrImage& picture, const Aovs& aovs, const EffectRun& run) override;

    /// Memory that is kept for each pixel, beside that of the net for a tile (NetDenoiser::kMaxBytes).
    static constexpr std::size_t bytesPerPixel() { return 4 * sizeof(Colour) + sizeof(PixelCoverage); }

  private:
    /// A run of three, or the only one.
    enum class Turn { Only, FirstHalf, SecondHalf, Whole };
    bool runNet(Turn turn, const HdrImage& picture, const EffectRun& run, HdrImage& result);
    bool mix(const HdrImage& picture, const EffectRun& run, NetReport& report);
    bool cleanHalf(Turn turn, const EffectRun& run, HdrImage& result, TakenDots& dots);
    void findCoverage(const HdrImage& picture, const EffectRun& run);
    void mixSampled(const HdrImage& picture, const EffectRun& run, NetReport& report);
    void finishAlone(const HdrImage& picture, const EffectRun& run);
    void keepBackground(const HdrImage& picture, const EffectRun& run);

    std::optional<NetDenoiser> denoiser_; ///< of the net that was used last
    HdrImage image_;                      ///< the result
    HdrImage first_, second_, input_;     ///< of the halves, and without bright dots, where it mixes
    std::vector<PixelCoverage> coverage_;
};

extern const EffectRow kNetDenoiseEffect;

} // namespace rtcore
