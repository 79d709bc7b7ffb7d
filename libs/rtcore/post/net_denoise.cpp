#include "rtcore/post/net_denoise.h"

#include "rtcore/platform/threads.h"
#include "rtcore/render/aovs.h"
#include "rtcore/render/sample_halves.h"

#include <algorithm>
#include <cstdint>

namespace rtcore {

namespace {

PixelPlane planeOf(const HdrImage& picture) { return {&picture.pixels[0].r, sizeof(Colour) / sizeof(float)}; }

PixelPlane planeOf(const float& first) { return {&first, sizeof(AovPixel) / sizeof(float)}; }

PixelCoverage coverageOf(const AovPixel& pixel) {
    if (pixel.covered == 0) return PixelCoverage::None;
    return pixel.covered < 1 ? PixelCoverage::Part : PixelCoverage::Full;
}

/// Whether the halves are those of the picture, and of enough samples.
bool halvesServe(const HdrImage& picture, const EffectRun& run) {
    return run.halves != nullptr && run.settings.denoise.mix &&
           run.halves->samples >= static_cast<std::uint32_t>(kMixedSamples) &&
           run.halves->first.width == picture.width && run.halves->first.height == picture.height;
}

double lightOf(const HdrImage& picture) {
    double sum = 0;
    for (const Colour pixel : picture.pixels) sum += static_cast<double>(luminance(pixel));
    return sum;
}

} // namespace

std::optional<Net> netOf(const RenderSettings& settings) {
    if (!denoisesByNet(settings)) return std::nullopt;
    switch (settings.denoise.net) {
    case DenoiseNet::Small:
        return Net::Small;
    case DenoiseNet::Large:
        return Net::Large;
    default:
        return Net::Base;
    }
}

const HdrImage& NetDenoise::apply(const HdrImage& picture, const Aovs& aovs, const EffectRun& run) {
    NetReport report;
    if (run.netReport != nullptr) *run.netReport = report;
    const bool whole = aovs.width() == picture.width && aovs.height() == picture.height;
    if (run.net == nullptr || aovs.empty() || !whole || picture.empty()) return picture;
    if (!denoiser_ || &denoiser_->net() != run.net.get()) denoiser_.emplace(run.net);
    const bool mixes = halvesServe(picture, run);
    if (!(mixes ? mix(picture, aovs, run, report) : runNet(picture, aovs, run, image_))) return picture;
    if (!mixes) keepBackground(picture, aovs, run.threads);
    report.ran = true;
    if (run.netReport != nullptr) *run.netReport = report;
    return image_;
}

bool NetDenoise::runNet(const HdrImage& picture, const Aovs& aovs, const EffectRun& run, HdrImage& result) {
    if (result.width != picture.width || result.height != picture.height)
        result = HdrImage(picture.width, picture.height);
    const AovPixel& first = aovs.pixels()[0];
    const NoisyImage noisy{.width = picture.width,
                           .height = picture.height,
                           .radiance = planeOf(picture),
                           .albedo = planeOf(first.albedo.r),
                           .normal = planeOf(first.normal.x)};
    return denoiser_->run(noisy, &result.pixels[0].r, run.threads, run.stop);
}

void NetDenoise::keepBackground(const HdrImage& picture, const Aovs& aovs, int threads) {
    const auto width = static_cast<std::size_t>(picture.width);
#pragma omp parallel for schedule(static) num_threads(threadsFor(threads))
    for (int y = 0; y < picture.height; ++y) {
        const std::size_t row = static_cast<std::size_t>(y) * width;
        for (std::size_t i = row; i < row + width; ++i)
            if (aovs.pixels()[i].covered == 0) image_.pixels[i] = picture.pixels[i];
    }
}

/// Runs the net on a half without its bright dots, and takes their light from input_, the mean of all
/// samples.
bool NetDenoise::cleanHalf(const HdrImage& half, const HdrImage& other, float fraction, const Aovs& aovs,
                           const EffectRun& run, HdrImage& result, TakenDots& dots) {
    const TakenDots taken = copyWithoutDots(half, other, image_, run.threads);
    dots.pixels += taken.pixels;
    dots.light += taken.light;
    for (std::size_t i = 0; i < half.pixels.size(); ++i)
        if (image_.pixels[i] != half.pixels[i])
            input_.pixels[i] = input_.pixels[i] - (half.pixels[i] - image_.pixels[i]) * fraction;
    return runNet(image_, aovs, run, result);
}

bool NetDenoise::mix(const HdrImage& picture, const Aovs& aovs, const EffectRun& run, NetReport& report) {
    const SampleHalves& halves = *run.halves;
    const float fraction = halves.firstFraction;
    TakenDots dots;
    input_ = picture;
    if (!cleanHalf(halves.first, halves.second, fraction, aovs, run, first_, dots) ||
        !cleanHalf(halves.second, halves.first, 1 - fraction, aovs, run, second_, dots) ||
        !runNet(input_, aovs, run, image_))
        return false;
    coverage_.resize(picture.pixels.size());
    std::ranges::transform(aovs.pixels(), coverage_.begin(), coverageOf);
    const EstimatedError error =
        mixWithNet({picture, image_, halves, first_, second_, coverage_}, image_, run.threads);
    report.mixed = true;
    report.error = error.all;
    report.largestError = error.largestBlock;
    report.dots = dots.pixels;
    const double light = lightOf(halves.first) + lightOf(halves.second);
    report.lightOfDots = light > 0 ? static_cast<float>(dots.light / light) : 0;
    return true;
}

constinit const EffectRow kNetDenoiseEffect{.name = "denoise by a net",
                                            .stage = EffectStage::Radiance,
                                            .wanted = &denoisesByNet,
                                            .bytesPerPixel = NetDenoise::bytesPerPixel(),
                                            .needsAovs = true,
                                            .make = &makeEffect<NetDenoise>};

} // namespace rtcore
