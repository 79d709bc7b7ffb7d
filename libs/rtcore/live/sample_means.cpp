#include "rtcore/live/sample_means.h"

#include <algorithm>
#include <cmath>

namespace rtcore {

namespace {

int up(int pixels, int shift) { return (pixels + (1 << shift) - 1) >> shift; }

} // namespace

void SampleMeans::begin(int width, int height) {
    width_ = width;
    int shift = 0;
    for (Level& level : levels_) {
        level.shift = shift += kStep;
        level.columns = up(width, shift);
        level.rows = up(height, shift);
        level.sums.resize(static_cast<std::size_t>(level.columns) * static_cast<std::size_t>(level.rows));
    }
}

void SampleMeans::addUp(const Level& fine, Level& coarse, int first, int last) const {
    for (int row = first >> coarse.shift; row < up(last, coarse.shift); ++row) {
        for (int column = 0; column < coarse.columns; ++column) {
            Weighed sum;
            for (int v = row << kStep; v < std::min((row + 1) << kStep, fine.rows); ++v) {
                for (int u = column << kStep; u < std::min((column + 1) << kStep, fine.columns); ++u)
                    add(sum, fine.at(u, v));
            }
            coarse.at(column, row) = sum;
        }
    }
}

/// Mean of the four squares whose middles are around that of the pixel, weighted by distance.
SampleMeans::Weighed SampleMeans::Level::around(int x, int y) const {
    const auto side = static_cast<float>(1 << shift);
    const float across = (static_cast<float>(x) + 0.5F) / side - 0.5F,
                down = (static_cast<float>(y) + 0.5F) / side - 0.5F;
    const int left = static_cast<int>(std::floor(across)), top = static_cast<int>(std::floor(down));
    const float u = across - static_cast<float>(left), v = down - static_cast<float>(top);
    Weighed sum;
    for (int j = 0; j < 2; ++j) {
        for (int i = 0; i < 2; ++i) {
            const Weighed& square =
                at(std::clamp(left + i, 0, columns - 1), std::clamp(top + j, 0, rows - 1));
            const float weight = (i == 0 ? 1 - u : u) * (j == 0 ? 1 - v : v);
            add(sum, {square.light * weight, square.weight * weight});
        }
    }
    return sum;
}

Colour SampleMeans::around(int x, int y) const {
    constexpr float kEnough = 0.5F; // samples in a square
    constexpr float kLittle = 0.01F;
    Colour light{};
    float left = 1;
    for (const Level& level : levels_) {
        const Weighed there = level.around(x, y);
        if (!(there.weight > 0)) continue;
        const float part = left * std::min(there.weight / kEnough, 1.0F);
        light += there.light * (part / there.weight);
        left -= part;
        if (left < kLittle) break;
    }
    return left < 1 ? light / (1 - left) : Colour{};
}

} // namespace rtcore
