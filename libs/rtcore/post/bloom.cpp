#include "rtcore/post/bloom.h"

#include <algorithm>

namespace rtcore {

namespace {
constexpr float kLeastSigma = 0.25F; ///< pixels; less is not seen
}

float bloomSigma(const RenderSettings& settings, int width) {
    if (!(settings.bloomShare > 0) || settings.width < 1) return 0;
    const float sigma =
        static_cast<float>(settings.bloom) * static_cast<float>(width) / static_cast<float>(settings.width);
    return sigma >= kLeastSigma ? sigma : 0;
}

void Bloom::mix(const HdrImage& radiance, const RenderSettings& settings, float share, int threads,
                HdrImage& result) {
    const float sigma = bloomSigma(settings, radiance.width);
    if (settings.bloomKernel == BloomKernel::Airy) {
        airy_.blur(radiance, sigma, share, threads, result);
    } else {
        gaussian_.blur(radiance, sigma, share, threads, result);
    }
}

void Bloom::spread(const HdrImage& radiance, const RenderSettings& settings, int threads, HdrImage& glow) {
    mix(radiance, settings, 1, threads, glow);
}

const HdrImage& Bloom::apply(const HdrImage& radiance, const RenderSettings& settings, int threads) {
    if (radiance.empty() || bloomSigma(settings, radiance.width) == 0) return radiance;
    mix(radiance, settings, settings.bloomShare, threads, result_);
    return result_;
}

Colour glowAt(const HdrImage& glow, int block, int x, int y) {
    struct Between {
        int before, after;
        float share;
    };
    const auto between = [block](int pixel, int size) -> Between {
        const float place = (static_cast<float>(pixel) + 0.5F) / static_cast<float>(block) - 0.5F;
        const auto before = static_cast<int>(place + 1) - 1; // place > -1
        return {std::clamp(before, 0, size - 1), std::clamp(before + 1, 0, size - 1),
                place - static_cast<float>(before)};
    };
    const Between column = between(x, glow.width), row = between(y, glow.height);
    const auto mixed = [&](int line) {
        return glow.at(column.before, line) * (1 - column.share) + glow.at(column.after, line) * column.share;
    };
    return mixed(row.before) * (1 - row.share) + mixed(row.after) * row.share;
}

} // namespace rtcore
