#include "bench/walk/resample.h"

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <vector>

namespace bench {

namespace {

/// Pixels of which one of the result is made, with weights whose sum is 1.
struct Cover {
    int first = 0;
    std::vector<float> weights;
};

/// Those that an interval covers.
Cover coverOf(double begin, double end, int pixels) {
    const double from = std::max(begin, 0.0), to = std::min(end, static_cast<double>(pixels));
    assert(from < to);
    Cover cover{static_cast<int>(from), {}};
    for (int i = cover.first; i < pixels && i < to; ++i) {
        const double part = std::min(to, i + 1.0) - std::max(from, static_cast<double>(i));
        cover.weights.push_back(static_cast<float>(part / (to - from)));
    }
    return cover;
}

/// The same of `count` intervals of that length, whose middle is that of the pixels.
std::vector<Cover> coversOf(int count, double length, int pixels) {
    const double begin = (pixels - count * length) / 2;
    std::vector<Cover> covers;
    for (int i = 0; i < count; ++i)
        covers.push_back(coverOf(begin + i * length, begin + (i + 1) * length, pixels));
    return covers;
}

/// The two pixels around the middle of each of `count` intervals that have the length of all pixels.
std::vector<Cover> neighboursOf(int count, int pixels) {
    std::vector<Cover> neighbours;
    for (int i = 0; i < count; ++i) {
        const double at = std::clamp((i + 0.5) * pixels / count - 0.5, 0.0, pixels - 1.0);
        const int first = std::min(static_cast<int>(at), std::max(pixels - 2, 0));
        const auto part = static_cast<float>(at - first);
        neighbours.push_back(pixels > 1 ? Cover{first, {1 - part, part}} : Cover{0, {1}});
    }
    return neighbours;
}

rtcore::Colour meanOf(const rtcore::HdrImage& image, const Cover& columns, const Cover& rows) {
    rtcore::Colour sum;
    for (std::size_t j = 0; j < rows.weights.size(); ++j) {
        const rtcore::Colour* const row = &image.at(columns.first, rows.first + static_cast<int>(j));
        for (std::size_t i = 0; i < columns.weights.size(); ++i)
            sum += row[i] * (columns.weights[i] * rows.weights[j]);
    }
    return sum;
}

rtcore::HdrImage resampled(const rtcore::HdrImage& image, const std::vector<Cover>& columns,
                           const std::vector<Cover>& rows) {
    rtcore::HdrImage result(static_cast<int>(columns.size()), static_cast<int>(rows.size()));
    auto to = result.pixels.begin();
    for (const Cover& row : rows) {
        for (const Cover& column : columns) *to++ = meanOf(image, column, row);
    }
    return result;
}

} // namespace

rtcore::HdrImage averagedDown(const rtcore::HdrImage& image, int width, int height) {
    const double side = static_cast<double>(image.width) / width;
    return resampled(image, coversOf(width, side, image.width), coversOf(height, side, image.height));
}

rtcore::HdrImage interpolated(const rtcore::HdrImage& image, int width, int height) {
    return resampled(image, neighboursOf(width, image.width), neighboursOf(height, image.height));
}

} // namespace bench
