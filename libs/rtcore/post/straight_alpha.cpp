#include "rtcore/post/straight_alpha.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace rtcore {

float alphaOf(Colour transmitted) {
    const float mean = (transmitted.r + transmitted.g + transmitted.b) / 3;
    return std::clamp(1 - mean, 0.0F, 1.0F);
}

std::vector<float> alphasOf(const HdrImage& transmitted) {
    std::vector<float> alphas(transmitted.pixels.size());
    std::ranges::transform(transmitted.pixels, alphas.begin(), alphaOf);
    return alphas;
}

void straighten(const HdrImage& radiance, const HdrImage& transmitted, HdrImage& straight) {
    straight = radiance;
    for (std::size_t i = 0; i < straight.pixels.size(); ++i) {
        const float alpha = alphaOf(transmitted.pixels[i]);
        if (alpha > 0 && alpha < 1) straight.pixels[i] = straight.pixels[i] / alpha;
    }
}

void setAlpha(const HdrImage& transmitted, LdrImage& image) {
    for (std::size_t i = 0; i < image.pixels.size(); ++i) {
        Rgba8& pixel = image.pixels[i];
        pixel.a = static_cast<std::uint8_t>(std::lround(255 * alphaOf(transmitted.pixels[i])));
        if (pixel.a == 0) pixel = {0, 0, 0, 0};
    }
}

} // namespace rtcore
