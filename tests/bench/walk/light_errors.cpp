#include "bench/walk/light_errors.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

namespace bench {

namespace {

using Channels = std::array<double, 3>;

Channels channels(rtcore::Colour c) { return {c.r, c.g, c.b}; }

double meanOf(const rtcore::HdrImage& image, const std::vector<bool>& pixels) {
    double sum = 0, count = 0;
    for (std::size_t i = 0; i < image.pixels.size(); ++i) {
        if (!pixels[i]) continue;
        for (const double channel : channels(image.pixels[i])) sum += channel;
        ++count;
    }
    return count > 0 ? sum / (3 * count) : 0;
}

std::vector<bool> allOf(const rtcore::HdrImage& image) {
    return std::vector<bool>(image.pixels.size(), true);
}

bool areAll(const std::vector<bool>& pixels, int width, int x, int y, int side) {
    for (int v = y; v < y + side; ++v) {
        for (int u = x; u < x + side; ++u) {
            if (!pixels[static_cast<std::size_t>(v) * static_cast<std::size_t>(width) +
                        static_cast<std::size_t>(u)])
                return false;
        }
    }
    return true;
}

/// The product of what x differs from a and from b, over the square of r: mean of the channels.
double relativeError(const Channels& x, const Channels& a, const Channels& b, double floor) {
    double sum = 0;
    for (std::size_t c = 0; c < x.size(); ++c) {
        const double r = (a[c] + b[c]) / 2;
        sum += (x[c] - a[c]) * (x[c] - b[c]) / (r * r + floor);
    }
    return sum / static_cast<double>(x.size());
}

/// Of all but a thousandth of them, one at least: those of the largest `order`.
double meanWithoutWorst(const std::vector<double>& errors, const std::vector<double>& order) {
    const std::size_t left = errors.size() - std::max<std::size_t>(1, errors.size() / 1000);
    if (left == 0) return 0;
    std::vector<std::size_t> pixels(errors.size());
    std::iota(pixels.begin(), pixels.end(), std::size_t{0});
    std::ranges::nth_element(pixels, pixels.begin() + static_cast<std::ptrdiff_t>(left), {},
                             [&](std::size_t i) { return std::pair(order[i], i); });
    double sum = 0;
    for (std::size_t i = 0; i < left; ++i) sum += errors[pixels[i]];
    return sum / static_cast<double>(left);
}

/// The sum over a square of pixels from (x, y).
double lightOf(const rtcore::HdrImage& image, int x, int y, int side) {
    double sum = 0;
    for (int v = y; v < y + side; ++v)
        for (int u = x; u < x + side; ++u) sum += rtcore::luminance(image.at(u, v));
    return sum;
}

double errorOfBlocks(const std::vector<bool>& pixels, const rtcore::HdrImage& image,
                     const rtcore::HdrImage& one, const rtcore::HdrImage& other) {
    constexpr int kSide = 8;
    const auto wanted = [&](int x, int y, int side) {
        return (lightOf(one, x, y, side) + lightOf(other, x, y, side)) / 2;
    };
    double mean = 0, count = 0;
    const auto forEachBlock = [&](const auto& use) {
        for (int y = 0; y + kSide <= image.height; y += kSide)
            for (int x = 0; x + kSide <= image.width; x += kSide)
                if (areAll(pixels, image.width, x, y, kSide)) use(x, y);
    };
    forEachBlock([&](int x, int y) {
        mean += wanted(x, y, kSide);
        ++count;
    });
    if (mean <= 0) return 0;
    const double floor = 0.1 * mean / count;
    double sum = 0;
    forEachBlock([&](int x, int y) {
        const double r = wanted(x, y, kSide);
        sum += std::fabs(lightOf(image, x, y, kSide) - r) / (r + floor);
    });
    return sum / count;
}

} // namespace

LightErrors lightErrors(const rtcore::HdrImage& image, const rtcore::HdrImage& one,
                        const rtcore::HdrImage& other) {
    const std::vector<bool> all = allOf(image);
    const double mean = (meanOf(one, all) + meanOf(other, all)) / 2, floor = 0.01 * mean * mean;
    std::vector<double> errors, noise;
    for (std::size_t i = 0; i < image.pixels.size(); ++i) {
        const Channels a = channels(one.pixels[i]), b = channels(other.pixels[i]);
        errors.push_back(relativeError(channels(image.pixels[i]), a, b, floor));
        noise.push_back(-relativeError(channels(0.5F * (one.pixels[i] + other.pixels[i])), a, b, floor));
    }
    LightErrors result = lightErrorsOf(all, image, one, other);
    result.relMse = meanWithoutWorst(errors, noise);
    return result;
}

LightErrors lightErrorsOf(const std::vector<bool>& pixels, const rtcore::HdrImage& image,
                          const rtcore::HdrImage& one, const rtcore::HdrImage& other) {
    const double mean = (meanOf(one, pixels) + meanOf(other, pixels)) / 2;
    return {.blocks = errorOfBlocks(pixels, image, one, other),
            .bias = mean > 0 ? meanOf(image, pixels) / mean - 1 : 0};
}

double changeOfLight(const rtcore::HdrImage& before, const rtcore::HdrImage& now) {
    double difference = 0, sum = 0;
    for (std::size_t i = 0; i < now.pixels.size(); ++i) {
        const double was = rtcore::luminance(before.pixels[i]);
        difference += std::fabs(rtcore::luminance(now.pixels[i]) - was);
        sum += was;
    }
    return sum > 0 ? difference / sum : 0;
}

} // namespace bench
