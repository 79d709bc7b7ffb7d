/// Takes most of the noise out of an image by paths that viewers see while it has few samples.
#pragma once

#include "renderer/net_pace.h"

#include "rtcore/post/denoise.h"
#include "rtcore/post/net_denoise.h"
#include "rtcore/render/image_renderer.h"
#include "rtcore/settings/render_settings.h"

#include <atomic>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

namespace renderer {

/// For one thread at a time; keeps its memory.
class PreviewFilter {
  public:
    /// For settings that ask for one.
    void useNet(std::shared_ptr<const rtcore::UNet> net) { net_ = std::move(net); }

    /// The frame of the pass through the net, or through rtcore::Denoiser, as the last image will be. Where
    /// that is not to be filtered: the whole of it at first, less and less towards the last sample, so that
    /// the image grows into the unfiltered one without a step. The frame itself where the pass has neither
    /// guides nor surfaces for it. Valid until the next call; undefined once `stop` is true. Null where the
    /// net would take longer than the samples since the last image did: the image before is shown on.
    const rtcore::Frame* apply(const rtcore::ImagePass& pass, const rtcore::RenderSettings& settings,
                               int threads, const std::atomic<bool>& stop);

    /// The error that the net left in the last image.
    const rtcore::NetReport& report() const { return report_; }
    const std::vector<float>& errors() const { return errors_; } ///< of its pixels; empty: not known

  private:
    const rtcore::HdrImage& smooth(const rtcore::ImagePass& pass, const rtcore::EffectRun& run);

    std::shared_ptr<const rtcore::UNet> net_;
    rtcore::NetDenoise netDenoiser_;
    rtcore::NetReport report_;
    std::vector<float> errors_;
    NetPace pace_;
    rtcore::Denoiser denoiser_;
    rtcore::Frame filtered_;
};

} // namespace renderer
