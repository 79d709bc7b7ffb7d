#include "renderer/preview_filter.h"

namespace renderer {

namespace {

constexpr int kPasses = 5; ///< of the denoiser: one sample of each pixel needs wide ones

} // namespace

const rtcore::Frame& PreviewFilter::apply(const rtcore::Frame& frame, const rtcore::Aovs& surfaces,
                                          const rtcore::RenderSettings& settings, std::uint32_t samples,
                                          int threads, const std::atomic<bool>& stop) {
    rtcore::RenderSettings filter = settings;
    const bool finallyFiltered = rtcore::filterPasses(settings) > 0;
    if (!finallyFiltered) filter.denoise.passes = kPasses;
    const rtcore::HdrImage& smooth =
        denoiser_.apply(frame.radiance, surfaces, {.settings = filter, .threads = threads, .stop = &stop});
    if (&smooth == &frame.radiance) return frame;
    const float noisy =
        finallyFiltered ? 0 : static_cast<float>(samples) / static_cast<float>(settings.path.samples);
    filtered_.covered = frame.covered;
    filtered_.radiance = smooth;
    for (std::size_t i = 0; i < smooth.pixels.size(); ++i) {
        rtcore::Colour& pixel = filtered_.radiance.pixels[i];
        pixel = pixel + (frame.radiance.pixels[i] - pixel) * noisy;
    }
    return filtered_;
}

} // namespace renderer
