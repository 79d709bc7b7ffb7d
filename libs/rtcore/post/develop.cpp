#include "rtcore/post/develop.h"

#include "rtcore/platform/task_errors.h"
#include "rtcore/platform/threads.h"
#include "rtcore/post/background.h"
#include "rtcore/post/straight_alpha.h"

#include <algorithm>
#include <cstdint>

namespace rtcore {

namespace {

/// The exposure of an image that is black all over.
constexpr float kDarkness = 1;
/// The range of a fixed exposure (settings_table.cpp), so that any automatic one can be written down and
/// replayed.
constexpr float kMin = 1e-30F;
constexpr float kMax = 1e30F;
/// The albedo that the incident light shows as white, and the key at which it does.
constexpr float kWhiteAlbedo = 0.9F, kUsualKey = 0.18F;

/// The part of a row, of which the last block may be short. `radiance` and `pixels` begin at column 0.
void developRow(const Development& how, const RowPart& part, const Colour* radiance, Rgba8* pixels) {
    constexpr int kBlock = static_cast<int>(kToneBlock);
    int x = part.left;
    for (; x + kBlock <= part.right; x += kBlock) developBlock(how, radiance + x, x, part.y, pixels + x);
    if (x == part.right) return;
    Colour last[kToneBlock];
    Rgba8 developed[kToneBlock];
    std::copy(radiance + x, radiance + part.right, last);
    developBlock(how, last, x, part.y, developed);
    std::copy(developed, developed + (part.right - x), pixels + x);
}

/// `usual` as the thesis' curve takes it. Others show the mean as that one does.
float adapted(float usual, const RenderSettings& settings) {
    const bool thesis =
        settings.toneMapping == ToneMapping::Luminance || settings.toneMapping == ToneMapping::Channels;
    if (thesis || settings.exposure.mode == ExposureMode::Fixed) return usual;
    const float key = settings.exposure.key;
    const float found = exposureShowing(developmentOf(settings, 1), usual * key, key / (1 + key));
    return std::clamp(found, kMin, kMax);
}

} // namespace

/// frame.radiance, and what effects put behind it.
const HdrImage& PictureDeveloper::withBackground(const Frame& frame) {
    if (!frame.behind) return frame.radiance;
    withBackground_ = frame.radiance;
    addBackground(frame.transmitted, *frame.behind, withBackground_);
    return withBackground_;
}

std::optional<float> PictureDeveloper::average(const Frame& frame, bool background, int threads) {
    const int team = threadsFor(threads);
    if (histograms_.size() < static_cast<std::size_t>(team))
        histograms_.resize(static_cast<std::size_t>(team));
    for (LuminanceHistogram& histogram : histograms_) histogram.clear();
    const HdrImage& radiance = background ? withBackground(frame) : frame.radiance;
    const auto width = static_cast<std::size_t>(radiance.width);
#pragma omp parallel for schedule(static) num_threads(team)
    for (int y = 0; y < radiance.height; ++y) {
        const std::size_t first = static_cast<std::size_t>(y) * width;
        const std::span<const Colour> row(&radiance.pixels[first], width);
        LuminanceHistogram& histogram = histograms_[static_cast<std::size_t>(threadNumber())];
        const std::span<const std::uint8_t> covered(&frame.covered[first], width);
        if (background) {
            histogram.count(row);
        } else if (frame.metered.empty()) {
            histogram.count(row, covered);
        } else {
            histogram.count({&frame.metered[first], width}, covered);
        }
    }
    for (std::size_t i = 1; i < histograms_.size(); ++i) histograms_[0].add(histograms_[i]);
    if (!background && !frame.checked.empty()) {
        const std::size_t checked = frame.checked.size(),
                          times = (radiance.pixels.size() + checked / 2) / checked;
        histograms_[0].correct(frame.checked, static_cast<std::int64_t>(times));
    }
    return histograms_[0].logAverage();
}

float PictureDeveloper::exposure(const Frame& frame, const ExposureSettings& settings, int threads) {
    if (settings.mode == ExposureMode::Fixed) return settings.value;
    auto found = average(frame, false, threads);
    // Only background is visible: adapt to it.
    if (!found) found = average(frame, true, threads);
    return std::clamp(found.value_or(kDarkness) / settings.key, kMin, kMax);
}

float PictureDeveloper::exposure(const Frame& frame, const RenderSettings& settings,
                                 std::optional<float> white, int threads) {
    if (settings.exposure.mode != ExposureMode::Incident || !white)
        return adapted(exposure(frame, settings.exposure, threads), settings);
    const float usual = exposureOfWhite(developmentOf(settings, 1), kWhiteAlbedo * *white);
    return std::clamp(usual * (kUsualKey / settings.exposure.key), kMin, kMax);
}

const HdrImage& PictureDeveloper::finish(const Frame& frame, const RenderSettings& settings, int threads,
                                         const std::atomic<bool>* stop, std::atomic<float>* netFraction) {
    netReport_ = {};
    netErrors_.clear();
    const HdrImage& finished = effects_.apply(frame, {.settings = settings,
                                                      .threads = threads,
                                                      .net = net_,
                                                      .stop = stop,
                                                      .netReport = &netReport_,
                                                      .netErrors = &netErrors_,
                                                      .netFraction = netFraction});
    return settings.falseColours.seesWhite() ? onSurfaces(frame, finished) : finished;
}

/// Below 0 beside all surfaces, whatever effects have spread there; means of what surfaces cover alone.
const HdrImage& PictureDeveloper::onSurfaces(const Frame& frame, const HdrImage& finished) {
    onSurfaces_ = finished;
    for (std::size_t i = 0; i < onSurfaces_.pixels.size() && i < frame.covered.size(); ++i) {
        Colour& pixel = onSurfaces_.pixels[i];
        const float covered = static_cast<float>(frame.covered[i]);
        pixel = covered > 0 ? pixel * (255 / covered) : kWhite * -1.0F;
    }
    return onSurfaces_;
}

void PictureDeveloper::develop(const Frame& frame, const RenderSettings& settings, float exposure,
                               int threads, LdrImage& image) {
    developFinished(finish(frame, settings, threads), frame, settings, exposure, threads, image);
}

void PictureDeveloper::developFinished(const HdrImage& finished, const Frame& frame,
                                       const RenderSettings& settings, float exposure, int threads,
                                       LdrImage& image) {
    if (!frame.hidesBackground()) return develop(finished, settings, exposure, threads, image);
    straighten(finished, frame.transmitted, straight_);
    develop(straight_, settings, exposure, threads, image);
    setAlpha(frame.transmitted, image);
}

void PictureDeveloper::develop(const HdrImage& radiance, const RenderSettings& settings, float exposure,
                               [[maybe_unused]] int threads, LdrImage& image) {
    if (image.width != radiance.width || image.height != radiance.height) {
        image = LdrImage(radiance.width, radiance.height);
    }
    if (settings.falseColours.on) return paintFalseColours(radiance, settings, threads, image);
    falseColours_.reset();
    const Development how = developmentOf(settings, exposure);
    const auto team = static_cast<std::size_t>(threadsFor(threads));
    const auto width = static_cast<std::size_t>(radiance.width);
    effects_.beginRows(EffectStage::Display, radiance, 1,
                       {.settings = settings, .threads = threads, .exposure = exposure});
    if (effects_.changesRows()) {
        rows_.resize(std::max(rows_.size(), team));
        for (std::vector<Colour>& row : rows_) row.resize(width);
    }
#pragma omp parallel for schedule(static) num_threads(threadsFor(threads))
    for (int y = 0; y < radiance.height; ++y) {
        Colour* const changed =
            effects_.changesRows() ? rows_[static_cast<std::size_t>(threadNumber())].data() : nullptr;
        const RowPart part{y, 0, radiance.width, radiance.width, radiance.height};
        developRow(how, part, effects_.changeRow(part, &radiance.at(0, y), changed), &image.at(0, y));
    }
}

void PictureDeveloper::paintFalseColours(const HdrImage& radiance, const RenderSettings& settings,
                                         [[maybe_unused]] int threads, LdrImage& image) {
    const FalseColourSettings& wanted = settings.falseColours;
    falseColours_ = {.scale = scale_.choose(radiance, wanted, unit_, holdsScale_),
                     .quantity = wanted.quantity,
                     .unit = shownUnit(unit_, wanted.quantity),
                     .isolines = wanted.isolines,
                     .legend = wanted.legend};
    FalseColours marked = *falseColours_; // parts of images that are under way are not
    marked.marked = true;
    const int team = threadsFor(threads);
    painters_.resize(std::max(painters_.size(), static_cast<std::size_t>(team)));
    const PixelArea all{0, 0, radiance.width, radiance.height};
    const int bands = (radiance.height + kFalseColourRows - 1) / kFalseColourRows;
    TaskErrors errors; // painters need memory
#pragma omp parallel for schedule(static) num_threads(team)
    for (int i = 0; i < bands; ++i) {
        const int first = i * kFalseColourRows, last = std::min(first + kFalseColourRows, radiance.height);
        errors.guard([&] {
            painters_[static_cast<std::size_t>(threadNumber())].paint(radiance, marked, all, first, last,
                                                                      image);
        });
    }
    errors.rethrow();
}

void developPart(const HdrImage& radiance, const Development& how, const EffectChain& effects,
                 const PixelArea& part, LdrImage& image) {
    if (how.falseColours != nullptr) return paintFalseColours(radiance, *how.falseColours, part, image);
    const int right = part.left + part.columns;
    std::vector<Colour> changed(effects.changesRows() ? static_cast<std::size_t>(right) : 0);
    for (int y = part.top; y < part.top + part.rows; ++y) {
        const RowPart row{y, part.left, right, radiance.width, radiance.height};
        developRow(how, row, effects.changeRow(row, &radiance.at(0, y), changed.data()), &image.at(0, y));
    }
}

} // namespace rtcore
