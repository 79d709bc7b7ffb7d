#include "rtcore/post/net_denoise.h"

#include "rtcore/platform/threads.h"
#include "rtcore/post/steady_mix.h"
#include "rtcore/render/guides.h"
#include "rtcore/render/sample_halves.h"

#include <cstdint>
#include <utility>

namespace rtcore {

namespace {

PixelPlane planeOf(const HdrImage& picture) { return {&picture.pixels[0].r, sizeof(Colour) / sizeof(float)}; }

PixelPlane planeOf(const std::vector<Vec3>& vectors) { return {&vectors[0].x, sizeof(Vec3) / sizeof(float)}; }

/// `byRays`, `bySamples`: as Frame::covered.
PixelCoverage coverageOf(std::uint8_t byRays, std::uint8_t bySamples) {
    constexpr std::uint8_t kFull = 255;
    if (byRays == 0 && bySamples == 0) return PixelCoverage::None;
    return byRays < kFull ? PixelCoverage::Part : PixelCoverage::Full;
}

bool sameSize(const HdrImage& a, const HdrImage& b) { return a.width == b.width && a.height == b.height; }

/// The steady image of the picture; null where it has none.
const HdrImage* steadyOf(const HdrImage& picture, const EffectRun& run) {
    const bool serves =
        run.steady != nullptr && mixesSteadyImage(run.settings) && sameSize(*run.steady, picture);
    return serves ? run.steady : nullptr;
}

/// Whether the halves are those of the picture, and of enough samples.
bool halvesServe(const HdrImage& picture, const EffectRun& run) {
    const int minimum = steadyOf(picture, run) != nullptr ? kSteadySamples : kEstimatedSamples;
    return run.halves != nullptr && run.settings.denoise.mix &&
           run.halves->samples >= static_cast<std::uint32_t>(minimum) && sameSize(run.halves->first, picture);
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

const HdrImage& NetDenoise::apply(const HdrImage& picture, const Aovs&, const EffectRun& run) {
    NetReport report;
    if (run.netReport != nullptr) *run.netReport = report;
    if (run.netErrors != nullptr) run.netErrors->clear();
    if (run.net == nullptr || run.guides == nullptr || picture.empty()) return picture;
    if (!sameSize(run.guides->albedo, picture)) return picture;
    if (!denoiser_ || &denoiser_->net() != run.net.get()) denoiser_.emplace(run.net);
    findCoverage(picture, run);
    const bool mixes = halvesServe(picture, run);
    if (!(mixes ? mix(picture, run, report) : runNet(Turn::Only, picture, run, image_))) return picture;
    if (!mixes) finishAlone(picture, run);
    report.ran = true;
    if (run.netReport != nullptr) *run.netReport = report;
    return image_;
}

bool NetDenoise::runNet(Turn turn, const HdrImage& picture, const EffectRun& run, HdrImage& result) {
    if (!sameSize(result, picture)) result = HdrImage(picture.width, picture.height);
    const NoisyImage noisy{.width = picture.width,
                           .height = picture.height,
                           .radiance = planeOf(picture),
                           .albedo = planeOf(run.guides->albedo),
                           .normal = planeOf(run.guides->normals)};
    constexpr float kThird = 1.0F / 3;
    NetProgress progress{run.netFraction};
    if (turn == Turn::FirstHalf) progress.end = kThird;
    if (turn == Turn::SecondHalf) progress.begin = kThird, progress.end = 2 * kThird;
    if (turn == Turn::Whole) progress.begin = 2 * kThird;
    return denoiser_->run(noisy, &result.pixels[0].r, run.threads, run.stop, progress);
}

/// Few samples may see a surface at an outline where the rays of the guides see none.
void NetDenoise::findCoverage(const HdrImage& picture, const EffectRun& run) {
    const std::vector<std::uint8_t>& byRays = run.guides->covered;
    const bool known = run.covered != nullptr && run.covered->size() == picture.pixels.size();
    coverage_.resize(picture.pixels.size());
    for (std::size_t i = 0; i < coverage_.size(); ++i)
        coverage_[i] = coverageOf(byRays[i], known ? (*run.covered)[i] : byRays[i]);
}

/// Of one run of the net.
void NetDenoise::finishAlone(const HdrImage& picture, const EffectRun& run) {
    const HdrImage* const steady = steadyOf(picture, run);
    if (steady != nullptr) mixEvenly(*steady, coverage_, image_, run.threads);
    keepBackground(picture, run);
}

void NetDenoise::keepBackground(const HdrImage& picture, [[maybe_unused]] const EffectRun& run) {
    const auto width = static_cast<std::size_t>(picture.width);
#pragma omp parallel for schedule(static) num_threads(threadsFor(run.threads))
    for (int y = 0; y < picture.height; ++y) {
        const std::size_t row = static_cast<std::size_t>(y) * width;
        for (std::size_t i = row; i < row + width; ++i)
            if (coverage_[i] == PixelCoverage::None) image_.pixels[i] = picture.pixels[i];
    }
}

/// Runs the net on a half without its bright dots, and takes their light from input_, the mean of all
/// samples.
bool NetDenoise::cleanHalf(Turn turn, const EffectRun& run, HdrImage& result, TakenDots& dots) {
    const bool isFirst = turn == Turn::FirstHalf;
    const SampleHalves& halves = *run.halves;
    const HdrImage& half = isFirst ? halves.first : halves.second;
    const HdrImage& other = isFirst ? halves.second : halves.first;
    const float fraction = isFirst ? halves.firstFraction : 1 - halves.firstFraction;
    const TakenDots taken = copyWithoutDots(half, other, image_, run.threads);
    dots.pixels += taken.pixels;
    dots.light += taken.light;
    for (std::size_t i = 0; i < half.pixels.size(); ++i)
        if (image_.pixels[i] != half.pixels[i])
            input_.pixels[i] = input_.pixels[i] - (half.pixels[i] - image_.pixels[i]) * fraction;
    return runNet(turn, image_, run, result);
}

bool NetDenoise::mix(const HdrImage& picture, const EffectRun& run, NetReport& report) {
    const SampleHalves& halves = *run.halves;
    TakenDots dots;
    input_ = picture;
    if (!cleanHalf(Turn::FirstHalf, run, first_, dots) || !cleanHalf(Turn::SecondHalf, run, second_, dots) ||
        !runNet(Turn::Whole, input_, run, image_))
        return false;
    const HdrImage* const steady = steadyOf(picture, run);
    if (steady != nullptr)
        mixWithSteady({picture, *steady, halves, coverage_}, {image_, first_, second_}, run.threads);
    if (halves.samples >= static_cast<std::uint32_t>(kEstimatedSamples)) {
        mixSampled(picture, run, report);
    } else {
        keepBackground(picture, run);
    }
    report.dots = dots.pixels;
    const double light = lightOf(halves.first) + lightOf(halves.second);
    report.lightOfDots = light > 0 ? static_cast<float>(dots.light / light) : 0;
    return true;
}

void NetDenoise::mixSampled(const HdrImage& picture, const EffectRun& run, NetReport& report) {
    const SampleHalves& halves = *run.halves;
    EstimatedError error =
        mixWithNet({picture, image_, halves, first_, second_, coverage_}, image_, run.threads);
    report.estimated = true;
    report.mixed = halves.samples >= static_cast<std::uint32_t>(kMixedSamples);
    if (run.netErrors != nullptr) *run.netErrors = std::move(error.pixels);
    report.error = error.all;
    report.largestError = error.largestBlock;
}

constinit const EffectRow kNetDenoiseEffect{.name = "denoise by a net",
                                            .stage = EffectStage::Radiance,
                                            .wanted = &denoisesByNet,
                                            .bytesPerPixel = NetDenoise::bytesPerPixel(),
                                            .needsAovs = false,
                                            .needsGuides = true,
                                            .make = &makeEffect<NetDenoise>};

} // namespace rtcore
