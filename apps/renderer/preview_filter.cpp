#include "renderer/preview_filter.h"

namespace renderer {

namespace {

constexpr int kPasses = 5; ///< of the denoiser: one sample of each pixel needs wide ones

} // namespace

const rtcore::HdrImage& PreviewFilter::smooth(const rtcore::Frame& frame, const rtcore::Aovs& surfaces,
                                              const rtcore::EffectRun& run) {
    if (!rtcore::denoisesByNet(run.settings)) return denoiser_.apply(frame.radiance, surfaces, run);
    const NetPace::Clock::time_point begun = NetPace::Clock::now();
    const rtcore::HdrImage& image = netDenoiser_.apply(frame.radiance, surfaces, run);
    pace_.ran(begun, NetPace::Clock::now());
    return image;
}

const rtcore::Frame* PreviewFilter::apply(const rtcore::Frame& frame, const rtcore::Aovs& surfaces,
                                          const rtcore::RenderSettings& settings, std::uint32_t samples,
                                          int threads, const std::atomic<bool>& stop) {
    const bool byNet = rtcore::denoisesByNet(settings);
    if (byNet && samples > 1 && !pace_.due(NetPace::Clock::now())) return nullptr;
    rtcore::RenderSettings filter = settings;
    const bool finallyFiltered = byNet || rtcore::filterPasses(settings) > 0;
    if (!finallyFiltered) filter.denoise.passes = kPasses;
    const rtcore::HdrImage& smooth = this->smooth(frame, surfaces,
                                                  {.settings = filter,
                                                   .threads = threads,
                                                   .net = net_,
                                                   .stop = &stop,
                                                   .halves = frame.halves.empty() ? nullptr : &frame.halves});
    if (&smooth == &frame.radiance) return &frame;
    const float noisy =
        finallyFiltered ? 0 : static_cast<float>(samples) / static_cast<float>(settings.path.samples);
    filtered_.covered = frame.covered;
    filtered_.radiance = smooth;
    for (std::size_t i = 0; i < smooth.pixels.size(); ++i) {
        rtcore::Colour& pixel = filtered_.radiance.pixels[i];
        pixel = pixel + (frame.radiance.pixels[i] - pixel) * noisy;
    }
    return &filtered_;
}

} // namespace renderer
