/// Takes most of the noise out of an image by paths that viewers see while it has few samples.
#pragma once

#include "rtcore/post/denoise.h"
#include "rtcore/render/aovs.h"
#include "rtcore/render/frame.h"
#include "rtcore/settings/render_settings.h"

#include <atomic>
#include <cstdint>

namespace renderer {

/// For one thread at a time; keeps its memory.
class PreviewFilter {
  public:
    /// `frame` after `samples` of the settings' path.samples, through rtcore::Denoiser, as the last image
    /// will be. Where that is not to be filtered: the whole of it at first, less and less towards the last
    /// sample, so that the image grows into the unfiltered one without a step. `frame` itself where
    /// `surfaces`, its AOVs, are of another size. Valid until the next call; undefined once `stop` is true.
    const rtcore::Frame& apply(const rtcore::Frame& frame, const rtcore::Aovs& surfaces,
                               const rtcore::RenderSettings& settings, std::uint32_t samples, int threads,
                               const std::atomic<bool>& stop);

  private:
    rtcore::Denoiser denoiser_;
    rtcore::Frame filtered_;
};

} // namespace renderer
