#include "bench/walk/walk_errors.h"

#include "rtcore/upsample/upsample.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

namespace bench {

namespace {

double light(std::uint8_t code) {
    static const auto kTable = [] {
        std::array<double, 256> table{};
        for (std::size_t i = 0; i < table.size(); ++i) {
            const double x = static_cast<double>(i) / 255;
            table[i] = x <= 0.04045 ? x / 12.92 : std::pow((x + 0.055) / 1.055, 2.4);
        }
        return table;
    }();
    return kTable[code];
}

std::array<std::uint8_t, 3> codes(rtcore::Rgba8 p) { return {p.r, p.g, p.b}; }

double meanLight(const rtcore::LdrImage& image) {
    double sum = 0;
    for (const rtcore::Rgba8 p : image.pixels) {
        for (const std::uint8_t code : codes(p)) sum += light(code);
    }
    return sum / (3 * static_cast<double>(image.pixels.size()));
}

} // namespace

rtcore::LdrImage upsampled(const rtcore::LdrImage& image, int width, int height) {
    if (image.width == width && image.height == height) return image;
    rtcore::LdrImage result(width, height);
    rtcore::upsample(image, 0, result);
    return result;
}

PictureErrors errorsOf(const rtcore::LdrImage& image, const rtcore::LdrImage& reference,
                       const test::Flip& flip) {
    const double mean = meanLight(reference);
    const double floor = 0.01 * mean * mean;
    double square = 0, relative = 0, difference = 0;
    for (std::size_t i = 0; i < image.pixels.size(); ++i) {
        const auto seen = codes(image.pixels[i]), wanted = codes(reference.pixels[i]);
        for (std::size_t c = 0; c < 3; ++c) {
            const double step = static_cast<double>(seen[c]) - static_cast<double>(wanted[c]);
            const double r = light(wanted[c]), d = light(seen[c]) - r;
            square += step * step;
            relative += d * d / (r * r + floor);
            difference += d;
        }
    }
    const double count = 3 * static_cast<double>(image.pixels.size());
    PictureErrors errors;
    errors.psnr = 10 * std::log10(255.0 * 255 / std::max(square / count, 1e-6));
    errors.flip = flip.mean(image);
    errors.relMse = relative / count;
    errors.bias = difference / count / std::max(mean, 1e-9);
    return errors;
}

} // namespace bench
