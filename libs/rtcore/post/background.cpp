#include "rtcore/post/background.h"

#include "rtcore/post/denoise.h"
#include "rtcore/post/net_denoise.h"
#include "rtcore/render/transmitted_sums.h"

namespace rtcore {

void addBackground(const HdrImage& transmitted, Colour behind, HdrImage& image) {
    for (std::size_t i = 0; i < image.pixels.size() && i < transmitted.pixels.size(); ++i)
        image.pixels[i] += transmitted.pixels[i] * behind;
}

bool rendersApart(const RenderSettings& settings) {
    return settings.integrator == Integrator::Path && (denoisesByNet(settings) || filterPasses(settings) > 0);
}

const HdrImage& BackgroundEffect::apply(const HdrImage& picture, const Aovs&, const EffectRun& run) {
    if (run.transmitted == nullptr || !run.behind) return picture;
    result_ = picture;
    addBackground(*run.transmitted, *run.behind, result_);
    return result_;
}

constinit const EffectRow kBackgroundEffect{.name = "background",
                                            .stage = EffectStage::Radiance,
                                            .wanted = rendersApart,
                                            .bytesPerPixel =
                                                2 * sizeof(Colour) + TransmittedSums::kBytesPerPixel,
                                            .needsAovs = false,
                                            .needsGuides = false,
                                            .make = &makeEffect<BackgroundEffect>};

} // namespace rtcore
