#include "rtcore/post/bright_dots.h"

#include "rtcore/platform/threads.h"

#include <algorithm>
#include <vector>

namespace rtcore {

namespace {

constexpr float kTimes = 16; ///< a dot beside its neighbours, and the other half

float brightestAround(const HdrImage& image, int x, int y) {
    float brightest = 0;
    for (int v = std::max(y - 1, 0); v <= std::min(y + 1, image.height - 1); ++v) {
        for (int u = std::max(x - 1, 0); u <= std::min(x + 1, image.width - 1); ++u)
            if (u != x || v != y) brightest = std::max(brightest, luminance(image.at(u, v)));
    }
    return brightest;
}

/// Of the pixels around, and of what the other half shows.
float brightestBeside(const HdrImage& half, const HdrImage& other, int x, int y) {
    return std::max(brightestAround(half, x, y), luminance(other.at(x, y)));
}

} // namespace

TakenDots copyWithoutDots(const HdrImage& half, const HdrImage& other, HdrImage& input,
                          [[maybe_unused]] int threads) {
    if (input.width != half.width || input.height != half.height) input = HdrImage(half.width, half.height);
    std::vector<TakenDots> rows(static_cast<std::size_t>(half.height));
#pragma omp parallel for schedule(static) num_threads(threadsFor(threads))
    for (int y = 0; y < half.height; ++y) {
        TakenDots& taken = rows[static_cast<std::size_t>(y)];
        for (int x = 0; x < half.width; ++x) {
            const Colour colour = half.at(x, y);
            const float light = luminance(colour);
            input.at(x, y) = colour;
            if (!(light > kTimes * luminance(other.at(x, y)))) continue;
            const float limit = kTimes * brightestBeside(half, other, x, y);
            if (!(light > limit) || !(limit > 0)) continue;
            input.at(x, y) = colour * (limit / light);
            ++taken.pixels;
            taken.light += static_cast<double>(light - limit);
        }
    }
    TakenDots all;
    for (const TakenDots& row : rows) {
        all.pixels += row.pixels;
        all.light += row.light;
    }
    return all;
}

} // namespace rtcore
