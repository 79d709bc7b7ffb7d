#include "rtcore/post/local_exposure.h"

#include "rtcore/platform/threads.h"
#include "rtcore/post/quick_log.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>

namespace rtcore {

namespace {

constexpr int kColumns = 200;     ///< of the small image, about
constexpr int kWindows = 16;      ///< windows of the average, in its width
constexpr float kContrast = 0.5F; ///< variance of log2 luminance above which there is an edge
constexpr float kFarthest = 8;    ///< from the average, in powers of two, that is told apart

/// 2^x of |x| <= 100, within 4e-6 of it.
float quickExp2(float x) {
    constexpr float kRounder = 12582912; // adding it leaves no bits for fractions
    const float whole = (x + kRounder) - kRounder;
    const float f = (x - whole) * 0.693147181F;
    const float series =
        1 + f * (1 + f * (0.5F + f * (0.166666667F + f * (0.0416666667F + f * 0.00833333333F))));
    return series * std::bit_cast<float>(static_cast<std::uint32_t>(static_cast<int>(whole) + 127) << 23);
}

/// Powers of two above the average.
float brightness(Colour c, float scale) {
    const float y = luminance(c) * scale;
    constexpr float kDarkest = 1.0F / 256, kBrightest = 256; // kFarthest
    static_assert(kFarthest == 8);
    return quickLog2(y > kDarkest ? std::min(y, kBrightest) : kDarkest);
}

/// Means over 2 radius + 1 values, or as many as there are: from `count` of them, `step` apart, to `sums`.
void slide(const float* values, int count, std::size_t step, int radius, float* means) {
    const auto at = [&](int i) { return static_cast<double>(values[static_cast<std::size_t>(i) * step]); };
    double sum = 0;
    for (int i = 0; i < std::min(radius, count); ++i) sum += at(i);
    for (int i = 0; i < count; ++i) {
        if (i + radius < count) sum += at(i + radius);
        if (i > radius) sum -= at(i - radius - 1);
        const int first = std::max(i - radius, 0), last = std::min(i + radius, count - 1);
        means[static_cast<std::size_t>(i) * step] = static_cast<float>(sum / (last - first + 1));
    }
}

/// Where the middle of pixel `i` of `size` lies between those of a small image.
struct Place {
    int before, after;
    float fraction;
};
Place placeOf(int i, int size, int smallSize) {
    const float position =
        (static_cast<float>(i) + 0.5F) * static_cast<float>(smallSize) / static_cast<float>(size) - 0.5F;
    const auto before = static_cast<int>(position + 1) - 1; // place > -1
    return {std::clamp(before, 0, smallSize - 1), std::clamp(before + 1, 0, smallSize - 1),
            position - static_cast<float>(before)};
}

} // namespace

void LocalExposure::average(std::vector<float>& values) {
    const int radius = std::max(1, columns_ / (2 * kWindows));
    sums_.resize(values.size());
    for (int y = 0; y < rows_; ++y) slide(&values[at(0, y)], columns_, 1, radius, &sums_[at(0, y)]);
    const auto stride = static_cast<std::size_t>(columns_);
    for (int x = 0; x < columns_; ++x) slide(&sums_[at(x, 0)], rows_, stride, radius, &values[at(x, 0)]);
}

bool LocalExposure::beginRows(const HdrImage& coarse, int /*block*/, const EffectRun& run) {
    const ExposureSettings& exposure = run.settings.exposure;
    scale_ = 1 / std::max(run.exposure * exposure.key, 1e-30F);
    strength_ = exposure.local;
    measure(coarse, run.threads);
    return columns_ > 0;
}

void LocalExposure::measure(const HdrImage& picture, [[maybe_unused]] int threads) {
    const int block = std::max(1, picture.width / kColumns);
    columns_ = (picture.width + block - 1) / block;
    rows_ = (picture.height + block - 1) / block;
    const auto count = static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_);
    slope_.resize(count);
    offset_.resize(count);
    squares_.resize(count);
#pragma omp parallel for schedule(static) num_threads(threadsFor(threads))
    for (int row = 0; row < rows_; ++row) {
        float* const sums = &offset_[at(0, row)];
        std::fill_n(sums, columns_, 0.0F);
        const int bottom = std::min((row + 1) * block, picture.height);
        for (int y = row * block; y < bottom; ++y) {
            for (int x = 0; x < picture.width; ++x) sums[x / block] += brightness(picture.at(x, y), scale_);
        }
        for (int x = 0; x < columns_; ++x) {
            const int across = std::min(block, picture.width - x * block);
            sums[x] /= static_cast<float>(across * (bottom - row * block));
        }
    }
    for (std::size_t i = 0; i < count; ++i) squares_[i] = offset_[i] * offset_[i];
    average(offset_);
    average(squares_);
    for (std::size_t i = 0; i < count; ++i) {
        const float variance = std::max(squares_[i] - offset_[i] * offset_[i], 0.0F);
        slope_[i] = variance / (variance + kContrast);
        offset_[i] *= 1 - slope_[i];
    }
    average(slope_);
    average(offset_);
}

void LocalExposure::changeRow(const RowPart& part, const Colour* radiance, Colour* changed) const {
    const Place row = placeOf(part.y, part.height, rows_);
    const auto mixed = [&](const std::vector<float>& values, const Place& column) {
        const float upper = values[at(column.before, row.before)] * (1 - column.fraction) +
                            values[at(column.after, row.before)] * column.fraction;
        const float lower = values[at(column.before, row.after)] * (1 - column.fraction) +
                            values[at(column.after, row.after)] * column.fraction;
        return upper * (1 - row.fraction) + lower * row.fraction;
    };
    for (int x = part.left; x < part.right; ++x) {
        const Place column = placeOf(x, part.width, columns_);
        const float around = mixed(slope_, column) * brightness(radiance[x], scale_) + mixed(offset_, column);
        changed[x] = radiance[x] * quickExp2(-strength_ * around);
    }
}

constinit const EffectRow kLocalExposureEffect{.name = "local exposure",
                                               .stage = EffectStage::Display,
                                               .wanted =
                                                   [](const RenderSettings& settings) {
                                                       return settings.exposure.local > 0 &&
                                                              !settings.falseColours.on;
                                                   },
                                               .bytesPerPixel = 0, // a row for each thread, and a small image
                                               .needsAovs = false,
                                               .needsGuides = false,
                                               .make = &makeEffect<LocalExposure>};

} // namespace rtcore
