#include "rtcore/post/develop.h"

#include "rtcore/platform/threads.h"
#include "rtcore/post/tone_map_block.h"

#include <algorithm>

namespace rtcore {

namespace {

/// The exposure of a picture that is black all over.
constexpr float kDarkness = 1;
/// What a fixed exposure may be (settings_table.cpp), so that any automatic one can be written down and
/// replayed.
constexpr float kLeast = 1e-30F;
constexpr float kMost = 1e30F;

/// The pixels from column `left` to before `right` of a row, of which the last block may be short.
void developRow(const Development& how, const Colour* radiance, int left, int right, int y, Rgba8* pixels) {
    constexpr int kBlock = static_cast<int>(kToneBlock);
    int x = left;
    for (; x + kBlock <= right; x += kBlock) developBlock(how, radiance + x, x, y, pixels + x);
    if (x == right) return;
    Colour last[kToneBlock];
    Rgba8 developed[kToneBlock];
    std::copy(radiance + x, radiance + right, last);
    developBlock(how, last, x, y, developed);
    std::copy(developed, developed + (right - x), pixels + x);
}

} // namespace

std::optional<float> PictureDeveloper::average(const Frame& frame, bool background, int threads) {
    const int team = threadsFor(threads);
    if (histograms_.size() < static_cast<std::size_t>(team))
        histograms_.resize(static_cast<std::size_t>(team));
    for (LuminanceHistogram& histogram : histograms_) histogram.clear();
    const HdrImage& radiance = frame.radiance;
    const auto width = static_cast<std::size_t>(radiance.width);
#pragma omp parallel for schedule(static) num_threads(team)
    for (int y = 0; y < radiance.height; ++y) {
        const std::size_t first = static_cast<std::size_t>(y) * width;
        const std::span<const Colour> row(&radiance.pixels[first], width);
        LuminanceHistogram& histogram = histograms_[static_cast<std::size_t>(threadNumber())];
        if (background) {
            histogram.count(row);
        } else {
            histogram.count(row, {&frame.covered[first], width});
        }
    }
    for (std::size_t i = 1; i < histograms_.size(); ++i) histograms_[0].add(histograms_[i]);
    return histograms_[0].logAverage();
}

float PictureDeveloper::exposure(const Frame& frame, const ExposureSettings& settings, int threads) {
    if (settings.mode == ExposureMode::Fixed) return settings.value;
    auto found = average(frame, false, threads);
    // Nothing but background: then that is what the eye adapts to.
    if (!found) found = average(frame, true, threads);
    return std::clamp(found.value_or(kDarkness) / settings.key, kLeast, kMost);
}

const HdrImage& PictureDeveloper::finish(const Frame& frame, const RenderSettings& settings, int threads,
                                         const std::atomic<bool>* stop) {
    const HdrImage& denoised = denoiser_.apply(frame, settings, threads, stop);
    return stop != nullptr && *stop ? frame.radiance : bloom_.apply(denoised, settings, threads);
}

void PictureDeveloper::develop(const Frame& frame, const RenderSettings& settings, float exposure,
                               int threads, LdrImage& image) {
    develop(finish(frame, settings, threads), settings, exposure, threads, image);
}

void PictureDeveloper::develop(const HdrImage& radiance, const RenderSettings& settings, float exposure,
                               [[maybe_unused]] int threads, LdrImage& image) {
    if (image.width != radiance.width || image.height != radiance.height) {
        image = LdrImage(radiance.width, radiance.height);
    }
    const Development how{settings.toneMapping, settings.dithering, exposure};
    const int team = threadsFor(threads);
    const float strength = settings.exposure.local;
    if (strength > 0) {
        local_.measure(radiance, exposure * settings.exposure.key, threads);
        rows_.resize(std::max(rows_.size(), static_cast<std::size_t>(team)));
        for (std::vector<Colour>& row : rows_) row.resize(static_cast<std::size_t>(radiance.width));
    }
#pragma omp parallel for schedule(static) num_threads(team)
    for (int y = 0; y < radiance.height; ++y) {
        const Colour* row = &radiance.at(0, y);
        if (strength > 0) {
            Colour* const adjusted = rows_[static_cast<std::size_t>(threadNumber())].data();
            local_.adjust(row, 0, radiance.width, y, radiance.width, radiance.height, strength, adjusted);
            row = adjusted;
        }
        developRow(how, row, 0, radiance.width, y, &image.at(0, y));
    }
}

void PictureDeveloper::roughEffects(const Frame& coarse, int block, const RenderSettings& settings,
                                    float exposure, int threads, RoughEffects& effects) {
    effects.block = block;
    effects.glow = {};
    if (bloomSigma(settings, coarse.radiance.width) > 0) {
        bloom_.spread(coarse.radiance, settings, threads, effects.glow);
    }
    if (settings.exposure.local > 0) {
        effects.local.measure(coarse.radiance, exposure * settings.exposure.key, threads);
    }
}

void developPart(const Frame& frame, const RenderSettings& settings, float exposure,
                 const RoughEffects& effects, const PixelArea& part, LdrImage& image) {
    const Development how{settings.toneMapping, settings.dithering, exposure};
    const HdrImage& radiance = frame.radiance;
    const int right = part.left + part.columns;
    const bool glows = !effects.glow.empty();
    const bool local = settings.exposure.local > 0 && effects.local.measured();
    std::vector<Colour> changed(glows || local ? static_cast<std::size_t>(right) : 0);
    for (int y = part.top; y < part.top + part.rows; ++y) {
        const Colour* row = &radiance.at(0, y);
        if (glows) {
            for (int x = part.left; x < right; ++x) {
                changed[static_cast<std::size_t>(x)] =
                    withGlow(row[x], glowAt(effects.glow, effects.block, x, y), settings.bloomShare);
            }
            row = changed.data();
        }
        if (local) {
            effects.local.adjust(row, part.left, right, y, radiance.width, radiance.height,
                                 settings.exposure.local, changed.data());
            row = changed.data();
        }
        developRow(how, row, part.left, right, y, &image.at(0, y));
    }
}

float exposureFor(const Frame& frame, const ExposureSettings& settings) {
    return PictureDeveloper().exposure(frame, settings, 0);
}

LdrImage develop(const Frame& frame, const RenderSettings& settings, float exposure) {
    LdrImage image;
    PictureDeveloper().develop(frame, settings, exposure, 0, image);
    return image;
}

} // namespace rtcore
