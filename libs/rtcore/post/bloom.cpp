#include "rtcore/post/bloom.h"

#include <algorithm>

namespace rtcore {

namespace {
constexpr float kMinSigma = 0.25F; ///< pixels; less is not seen
}

float bloomSigma(const RenderSettings& settings, int width) {
    if (!(settings.bloom.share > 0) || settings.width < 1) return 0;
    const float sigma = static_cast<float>(settings.bloom.radius) * static_cast<float>(width) /
                        static_cast<float>(settings.width);
    return sigma >= kMinSigma ? sigma : 0;
}

void Bloom::mix(const HdrImage& picture, float fraction, const EffectRun& run, HdrImage& result) {
    const float sigma = bloomSigma(run.settings, picture.width);
    if (run.settings.bloom.kernel == BloomKernel::Airy) {
        airy_.blur(picture, sigma, fraction, run.threads, result);
    } else {
        gaussian_.blur(picture, sigma, fraction, run.threads, result);
    }
}

const HdrImage& Bloom::apply(const HdrImage& picture, const Aovs& /*aovs*/, const EffectRun& run) {
    if (picture.empty() || bloomSigma(run.settings, picture.width) == 0) return picture;
    mix(picture, run.settings.bloom.share, run, result_);
    return result_;
}

bool Bloom::beginRows(const HdrImage& coarse, int block, const EffectRun& run) {
    if (coarse.empty() || bloomSigma(run.settings, coarse.width) == 0) return false;
    mix(coarse, 1, run, spread_);
    block_ = block;
    fraction_ = run.settings.bloom.share;
    return true;
}

void Bloom::changeRow(const RowPart& part, const Colour* radiance, Colour* changed) const {
    for (int x = part.left; x < part.right; ++x) {
        const Colour spread = spreadAt(spread_, block_, x, part.y);
        changed[x] = fraction_ >= 1 ? spread : radiance[x] * (1 - fraction_) + spread * fraction_;
    }
}

Colour spreadAt(const HdrImage& spread, int block, int x, int y) {
    struct Between {
        int before, after;
        float fraction;
    };
    const auto between = [block](int pixel, int size) -> Between {
        const float position = (static_cast<float>(pixel) + 0.5F) / static_cast<float>(block) - 0.5F;
        const auto before = static_cast<int>(position + 1) - 1; // place > -1
        return {std::clamp(before, 0, size - 1), std::clamp(before + 1, 0, size - 1),
                position - static_cast<float>(before)};
    };
    const Between column = between(x, spread.width), row = between(y, spread.height);
    const auto mixed = [&](int line) {
        return spread.at(column.before, line) * (1 - column.fraction) +
               spread.at(column.after, line) * column.fraction;
    };
    return mixed(row.before) * (1 - row.fraction) + mixed(row.after) * row.fraction;
}

constinit const EffectRow kBloomEffect{.name = "bloom",
                                       .stage = EffectStage::Radiance,
                                       .wanted =
                                           [](const RenderSettings& settings) {
                                               return settings.bloom.radius > 0 && settings.bloom.share > 0 &&
                                                      !settings.falseColours.on;
                                           },
                                       .bytesPerPixel = sizeof(Colour),
                                       .needsAovs = false,
                                       .needsGuides = false,
                                       .make = &makeEffect<Bloom>};

} // namespace rtcore
