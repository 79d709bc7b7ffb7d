#include "rtcore/post/airy_blur.h"

#include "rtcore/math/constants.h"
#include "rtcore/platform/threads.h"
#include "rtcore/post/sanitize.h"
#include "rtcore/simd/portable_math.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace rtcore {

namespace {

constexpr int kRowsOfPart = static_cast<int>(kTransformLines) / 3; ///< in the real, or imaginary, parts
constexpr std::size_t kFloatsAcross = 2 * kTransformLines;

/// The wavelengths of red, green and blue by that of green.
constexpr float kWavelengths[3] = {650.0F / 532.0F, 1, 450.0F / 532.0F};

/// The overlap of two unit circles by the distance of their middles, 1 where they touch, by that at 0.
class Overlap {
  public:
    Overlap() {
        for (std::size_t i = 0; i < values_.size(); ++i) {
            const float v = static_cast<float>(i) / kSteps;
            values_[i] = 2 / kPi * (portableAcos(v) - v * std::sqrt(1 - v * v));
        }
        values_.back() = 0;
    }
    float operator()(float v) const {
        if (!(v < 1)) return 0;
        const float position = v * kSteps;
        const auto i = static_cast<std::size_t>(position);
        return values_[i] + (values_[i + 1] - values_[i]) * (position - static_cast<float>(i));
    }

  private:
    static constexpr int kSteps = 4096;
    std::array<float, kSteps + 1> values_{};
};

const Overlap& overlap() {
    static const Overlap table;
    return table;
}

/// sin(pi f) / (pi f): the average over a pixel.
float pixelAverage(float f) {
    const float x = kPi * std::fabs(f);
    return x < 1e-4F ? 1 : portableSin(x) / x;
}

void loadRow(const Colour* pixels, int width, std::vector<float>& lines, std::size_t line) {
    float* to = &lines[line];
    for (int x = 0; x < width; ++x, to += kTransformLines) {
        to[0] = sanitizeRadiance(pixels[x].r);
        to[1] = sanitizeRadiance(pixels[x].g);
        to[2] = sanitizeRadiance(pixels[x].b);
    }
}

void mixRow(const std::vector<float>& lines, std::size_t line, float fraction, const Colour* source,
            int width, Colour* pixels) {
    const float* from = &lines[line];
    for (int x = 0; x < width; ++x, from += kTransformLines) {
        pixels[x] = {mixedWith(source[x].r, from[0], fraction), mixedWith(source[x].g, from[1], fraction),
                     mixedWith(source[x].b, from[2], fraction)};
    }
}

/// Calls `work` with the row, its part's numbers and its first line, for each row of a batch from `first` on.
template <typename Work>
void forRows(TransformScratch& scratch, int first, int height, Work&& work) {
    const int end = std::min(height, first + 2 * kRowsOfPart);
    for (int y = first; y < end; ++y) {
        const int row = (y - first) % kRowsOfPart;
        work(y, y - first < kRowsOfPart ? scratch.re : scratch.im, static_cast<std::size_t>(3 * row));
    }
}

/// The response to each frequency of one column of coefficients.
class ColumnFilter {
  public:
    /// `pixelY` is memory that it uses.
    ColumnFilter(const CosineTransform& across, const CosineTransform& down, float greenCutoff,
                 std::vector<float>& pixelY)
        : stepX_(0.5F / static_cast<float>(across.length())),
          stepY_(0.5F / static_cast<float>(down.length())), pixelY_(pixelY) {
        pixelY_.resize(down.length());
        for (std::size_t i = 0; i < 3; ++i) cutoff_[i] = greenCutoff / kWavelengths[i];
        for (std::size_t k = 0; k < pixelY_.size(); ++k) {
            pixelY_[k] = pixelAverage(stepY_ * static_cast<float>(k));
        }
    }

    /// Whether nothing is left of what is at float `column` of the rows and behind it.
    bool isEmptyFrom(std::size_t column) const {
        return cutoff_[2] <= 0.5F && stepX_ * static_cast<float>(column / 3) >= cutoff_[2];
    }

    void apply(std::size_t column, float* line) const {
        const float x = stepX_ * static_cast<float>(column / 3), cutoff = cutoff_[column % 3];
        const bool folded = cutoff > 0.5F;
        const float pixel = pixelAverage(x), scale = 1 / cutoff;
        const Overlap& table = overlap();
        for (std::size_t k = 0; k < pixelY_.size(); ++k, line += kTransformLines) {
            const float y = stepY_ * static_cast<float>(k);
            *line *= folded ? airyResponse(x, y, cutoff)
                            : table(std::sqrt(x * x + y * y) * scale) * pixel * pixelY_[k];
        }
    }

  private:
    float stepX_, stepY_; ///< cycles a pixel
    float cutoff_[3];
    std::vector<float>& pixelY_; ///< pixelAverage() of each frequency down
};

} // namespace

float airyResponse(float x, float y, float cutoff) {
    const auto reach = static_cast<int>(std::ceil(cutoff - 0.5F));
    float sum = 0;
    for (int j = -reach; j <= reach; ++j) {
        const float fy = y + static_cast<float>(j);
        if (std::fabs(fy) >= cutoff) continue;
        for (int i = -reach; i <= reach; ++i) {
            const float fx = x + static_cast<float>(i);
            const float kept = overlap()(std::sqrt(fx * fx + fy * fy) / cutoff);
            if (kept > 0) sum += kept * pixelAverage(fx) * pixelAverage(fy);
        }
    }
    return sum;
}

void AiryBlur::blur(const HdrImage& image, float sigma, float fraction, int threads, HdrImage& result) {
    const int width = image.width, height = image.height;
    if (result.width != width || result.height != height) result = HdrImage(width, height);
    if (image.empty()) return;
    const auto w = static_cast<std::size_t>(width), h = static_cast<std::size_t>(height);
    if (!across_ || across_->length() != w) across_.emplace(w);
    if (!down_ || down_->length() != h) down_.emplace(h);
    const int team = threadsFor(threads);
    if (scratch_.size() < static_cast<std::size_t>(team)) scratch_.resize(static_cast<std::size_t>(team));
    const auto scratchOfThread = [this]() -> TransformScratch& {
        return scratch_[static_cast<std::size_t>(threadNumber())];
    };
    constexpr int kRows = 2 * kRowsOfPart;

#pragma omp parallel for schedule(static) num_threads(team)
    for (int first = 0; first < height; first += kRows) {
        TransformScratch& scratch = scratchOfThread();
        across_->prepare(scratch);
        forRows(scratch, first, height, [&](int y, std::vector<float>& lines, std::size_t line) {
            loadRow(&image.at(0, y), width, lines, line);
        });
        across_->forward(scratch);
        forRows(scratch, first, height, [&](int y, std::vector<float>& lines, std::size_t line) {
            const float* from = &lines[line];
            Colour* const to = &result.at(0, y);
            for (int x = 0; x < width; ++x, from += kTransformLines) to[x] = {from[0], from[1], from[2]};
        });
    }

    // The Gaussian of the same peak has sigma = sqrt(2) / (pi cutoff).
    const ColumnFilter filter(*across_, *down_, std::sqrt(2.0F) / (kPi * sigma), pixelY_);
    const std::size_t stride = 3 * w;
    const auto batches = static_cast<int>((stride + kFloatsAcross - 1) / kFloatsAcross);
    float* const floats = &result.pixels[0].r;
#pragma omp parallel for schedule(dynamic, 1) num_threads(team)
    for (int batch = 0; batch < batches; ++batch) {
        const std::size_t first = static_cast<std::size_t>(batch) * kFloatsAcross;
        const std::size_t count = std::min(kFloatsAcross, stride - first);
        if (filter.isEmptyFrom(first)) {
            for (std::size_t y = 0; y < h; ++y) std::fill_n(floats + y * stride + first, count, 0.0F);
            continue;
        }
        TransformScratch& scratch = scratchOfThread();
        down_->prepare(scratch);
        const std::size_t real = std::min(count, kTransformLines), imaginary = count - real;
        for (std::size_t y = 0; y < h; ++y) {
            const float* const from = floats + y * stride + first;
            std::copy_n(from, real, &scratch.re[y * kTransformLines]);
            std::copy_n(from + real, imaginary, &scratch.im[y * kTransformLines]);
        }
        down_->forward(scratch);
        for (std::size_t i = 0; i < real; ++i) filter.apply(first + i, &scratch.re[i]);
        for (std::size_t i = 0; i < imaginary; ++i) filter.apply(first + real + i, &scratch.im[i]);
        down_->inverse(scratch);
        for (std::size_t y = 0; y < h; ++y) {
            float* const to = floats + y * stride + first;
            std::copy_n(&scratch.re[y * kTransformLines], real, to);
            std::copy_n(&scratch.im[y * kTransformLines], imaginary, to + real);
        }
    }

#pragma omp parallel for schedule(static) num_threads(team)
    for (int first = 0; first < height; first += kRows) {
        TransformScratch& scratch = scratchOfThread();
        across_->prepare(scratch);
        forRows(scratch, first, height, [&](int y, std::vector<float>& lines, std::size_t line) {
            const Colour* const from = &result.at(0, y);
            float* to = &lines[line];
            for (int x = 0; x < width; ++x, to += kTransformLines) {
                to[0] = from[x].r;
                to[1] = from[x].g;
                to[2] = from[x].b;
            }
        });
        across_->inverse(scratch);
        forRows(scratch, first, height, [&](int y, std::vector<float>& lines, std::size_t line) {
            mixRow(lines, line, fraction, &image.at(0, y), width, &result.at(0, y));
        });
    }
}

} // namespace rtcore
