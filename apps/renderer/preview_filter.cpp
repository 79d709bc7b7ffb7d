#include "renderer/preview_filter.h"

namespace renderer {

namespace {

constexpr int kPasses = 5; ///< of the denoiser: one sample of each pixel needs wide ones

} // namespace

const rtcore::HdrImage& PreviewFilter::smooth(const rtcore::ImagePass& pass, const rtcore::EffectRun& run) {
    const rtcore::HdrImage& radiance = pass.frame.radiance;
    report_ = {};
    errors_.clear();
    if (!rtcore::denoisesByNet(run.settings))
        return pass.surfaces == nullptr ? radiance : denoiser_.apply(radiance, *pass.surfaces, run);
    const NetPace::Clock::time_point begun = NetPace::Clock::now();
    const rtcore::HdrImage& image = netDenoiser_.apply(radiance, {}, run);
    pace_.ran(begun, NetPace::Clock::now());
    return image;
}

const rtcore::Frame* PreviewFilter::apply(const rtcore::ImagePass& pass,
                                          const rtcore::RenderSettings& settings, int threads,
                                          const std::atomic<bool>& stop) {
    const rtcore::Frame& frame = pass.frame;
    const bool byNet = rtcore::denoisesByNet(settings);
    if (byNet && pass.samples > 1 && !pace_.due(NetPace::Clock::now())) return nullptr;
    rtcore::RenderSettings filter = settings;
    const bool finallyFiltered = byNet || rtcore::filterPasses(settings) > 0;
    if (!finallyFiltered) filter.denoise.passes = kPasses;
    const rtcore::HdrImage& smooth =
        this->smooth(pass, {.settings = filter,
                            .threads = threads,
                            .net = net_,
                            .guides = pass.guides,
                            .stop = &stop,
                            .halves = frame.halves.empty() ? nullptr : &frame.halves,
                            .steady = frame.steady.empty() ? nullptr : &frame.steady,
                            .covered = &frame.covered,
                            .netReport = &report_,
                            .netErrors = &errors_});
    if (&smooth == &frame.radiance) return &frame;
    const float noisy =
        finallyFiltered ? 0 : static_cast<float>(pass.samples) / static_cast<float>(settings.path.samples);
    filtered_.covered = frame.covered;
    filtered_.transmitted = frame.transmitted;
    filtered_.behind = frame.behind;
    filtered_.radiance = smooth;
    for (std::size_t i = 0; i < smooth.pixels.size(); ++i) {
        rtcore::Colour& pixel = filtered_.radiance.pixels[i];
        pixel = pixel + (frame.radiance.pixels[i] - pixel) * noisy;
    }
    return &filtered_;
}

} // namespace renderer
