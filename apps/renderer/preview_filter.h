/// Takes most of the noise out of an image by paths that viewers see while it has few samples.
#pragma once

#include "renderer/net_pace.h"

#include "rtcore/post/denoise.h"
#include "rtcore/post/net_denoise.h"
#include "rtcore/render/aovs.h"
#include "rtcore/render/frame.h"
#include "rtcore/settings/render_settings.h"

#include <atomic>
#include <cstdint>
#include <memory>
#include <utility>

namespace renderer {

/// For one thread at a time; keeps its memory.
class PreviewFilter {
  public:
    /// For settings that ask for one.
    void useNet(std::shared_ptr<const rtcore::UNet> net) { net_ = std::move(net); }

    /// `frame` after `samples` of the settings' path.samples, through the net or rtcore::Denoiser, as the
    /// last image will be. Where that is not to be filtered: the whole of it at first, less and less towards
    /// the last sample, so that the image grows into the unfiltered one without a step. `frame` itself where
    /// `surfaces`, its AOVs, are of another size. Valid until the next call; undefined once `stop` is true.
    /// Null where the net would take longer than the samples since the last image did: the image before is
    /// shown on.
    const rtcore::Frame* apply(const rtcore::Frame& frame, const rtcore::Aovs& surfaces,
                               const rtcore::RenderSettings& settings, std::uint32_t samples, int threads,
                               const std::atomic<bool>& stop);

  private:
    const rtcore::HdrImage& smooth(const rtcore::Frame& frame, const rtcore::Aovs& surfaces,
                                   const rtcore::EffectRun& run);

    std::shared_ptr<const rtcore::UNet> net_;
    rtcore::NetDenoise netDenoiser_;
    NetPace pace_;
    rtcore::Denoiser denoiser_;
    rtcore::Frame filtered_;
};

} // namespace renderer
