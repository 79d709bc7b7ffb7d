#include "rtcore/post/false_colours.h"

#include "rtcore/post/quick_log.h"
#include "rtcore/post/value_colours.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

namespace rtcore {

namespace {

constexpr std::size_t kMaxIsovalues = 13; ///< four powers of ten by 1, 2 and 5
constexpr std::array<float, 4> kSmoothKernel{20 / 64.0F, 15 / 64.0F, 6 / 64.0F, 1 / 64.0F};
constexpr int kSmoothRadius = static_cast<int>(kSmoothKernel.size()) - 1;
constexpr float kLog10Of2 = 0.301029996F, kLog10Of5 = 0.698970004F;

float clampedRamp(float value, float zero, float one) {
    return std::clamp((value - zero) / (one - zero), 0.0F, 1.0F);
}

/// The part of a pixel that a line covers, and whether that lies where the scale is bright.
struct Isoline {
    float coverage = 0;
    bool bright = false;
};

/// Isolines over the logarithm to the base 10.
class IsolineSet {
  public:
    explicit IsolineSet(const ValueScale& scale)
        : low_(kLog10Of2 * quickLog2(scale.from)), high_(kLog10Of2 * quickLog2(scale.to)),
          decades_(isWide(scale)) {}

    /// Of a pixel; the square of the slope of the logarithm, for each pixel.
    Isoline at(float logarithm, float squaredSlope) const {
        constexpr float kNoLine = 1e-5F, kLine = 5e-5F; // slopes of what is even
        constexpr float kBright = 0.55F;                // of the scale: lines are black beyond, white below
        constexpr float kDense = 0.06F, kTooDense = 0.12F;
        constexpr int kPositive = 64; // added to a logarithm
        const float whole = static_cast<float>(static_cast<int>(logarithm + kPositive) - kPositive),
                    rest = logarithm - whole;
        const float nearest = decades_ ? (rest < 0.5F ? 0 : 1) : nearestOf(rest);
        const float line = whole + nearest, away = logarithm - line;
        if (away * away >= squaredSlope || squaredSlope < kNoLine * kNoLine) return {};
        const float slope = std::sqrt(squaredSlope), pixels = std::abs(away) / slope;
        constexpr float kRounding = 1e-5F;
        if (line < low_ - kRounding || line > high_ + kRounding) return {};
        const bool bright = line - low_ > kBright * (high_ - low_);
        return {.coverage =
                    (1 - pixels) * clampedRamp(slope, kNoLine, kLine) * clampedRamp(slope, kTooDense, kDense),
                .bright = bright};
    }

  private:
    static float nearestOf(float rest) {
        float nearest = 0;
        for (const float each : {kLog10Of2, kLog10Of5, 1.0F})
            if (std::abs(rest - each) < std::abs(rest - nearest)) nearest = each;
        return nearest;
    }

    float low_, high_;
    bool decades_;
};

bool measured(const FalseColours& how, float value) {
    return how.quantity == LightQuantity::Luminance || (how.marked ? value >= 0 : value > 0);
}

Rgba8 withLine(Rgba8 colour, const Isoline& isoline) {
    constexpr float kOpacity = 0.85F;
    const float line = isoline.bright ? 0 : 255, part = kOpacity * isoline.coverage;
    const auto mixed = [&](std::uint8_t channel) {
        return static_cast<std::uint8_t>(static_cast<float>(channel) * (1 - part) + line * part + 0.5F);
    };
    return {mixed(colour.r), mixed(colour.g), mixed(colour.b), 255};
}

} // namespace

/// Rows of a part with those around them that are smoothed into them. Columns count from the left of the
/// part.
struct FalseColourPainter::Band {
    const PixelArea& part;
    int first, last; ///< with the rows around them

    std::size_t columns() const { return static_cast<std::size_t>(part.columns); }
    std::size_t row(int y) const { return static_cast<std::size_t>(y - first) * columns(); }
};

std::size_t falseColourBytes(int columns, int threads) {
    constexpr std::size_t kRows = kFalseColourRows + 2 * (kSmoothRadius + 1), kArrays = 3;
    return kArrays * kRows * sizeof(float) * static_cast<std::size_t>(columns) *
           static_cast<std::size_t>(threads);
}

/// logs_ -> smooth_.
void FalseColourPainter::smooth(const Band& band) {
    const int columns = band.part.columns;
    for (int y = band.first; y < band.last; ++y) {
        const float* const from = &logs_[band.row(y)];
        float* const to = &across_[band.row(y)];
        const auto smoothed = [&](int x, auto&& at) {
            float sum = kSmoothKernel[0] * from[x];
            for (int k = 1; k <= kSmoothRadius; ++k)
                sum += kSmoothKernel[static_cast<std::size_t>(k)] * (from[at(x - k)] + from[at(x + k)]);
            to[x] = sum;
        };
        const auto bounded = [&](int x) { return std::clamp(x, 0, columns - 1); };
        const int inner = std::min(kSmoothRadius, columns), end = std::max(inner, columns - kSmoothRadius);
        for (int x = 0; x < inner; ++x) smoothed(x, bounded);
        for (int x = inner; x < end; ++x) smoothed(x, [](int same) { return same; });
        for (int x = end; x < columns; ++x) smoothed(x, bounded);
    }
    for (int y = band.first; y < band.last; ++y) {
        float* const to = &smooth_[band.row(y)];
        const float* const middle = &across_[band.row(y)];
        for (std::size_t x = 0; x < band.columns(); ++x) to[x] = kSmoothKernel[0] * middle[x];
        for (int k = 1; k <= kSmoothRadius; ++k) {
            const float weight = kSmoothKernel[static_cast<std::size_t>(k)];
            const float* const above = &across_[band.row(std::max(y - k, band.first))];
            const float* const below = &across_[band.row(std::min(y + k, band.last - 1))];
            for (std::size_t x = 0; x < band.columns(); ++x) to[x] += weight * (above[x] + below[x]);
        }
    }
}

void FalseColourPainter::paint(const HdrImage& radiance, const FalseColours& how, const PixelArea& part,
                               int first, int last, LdrImage& image) {
    const int top = part.top, bottom = part.top + part.rows;
    const Band band{part, std::max(first - kSmoothRadius - 1, top),
                    std::min(last + kSmoothRadius + 1, bottom)};
    const std::size_t pixels = static_cast<std::size_t>(band.last - band.first) * band.columns();
    for (std::vector<float>* each : {&logs_, &across_, &smooth_})
        each->resize(std::max(each->size(), pixels));

    // Logarithms, a little beyond the scale.
    const float min = how.scale.from / 2, max = how.scale.to * 2;
    for (int y = band.first; y < band.last; ++y) {
        const Colour* const from = &radiance.at(part.left, y);
        float* const to = &logs_[band.row(y)];
        for (std::size_t x = 0; x < band.columns(); ++x) {
            const float value = luminance(from[x]) * how.unit.ofOne;
            if (!measured(how, value)) {
                to[x] = std::numeric_limits<float>::quiet_NaN(); // as all becomes that is smoothed with it
                continue;
            }
            to[x] = quickLog2(value > min ? std::min(value, max) : min);
        }
    }
    if (how.isolines) smooth(band);

    const float low = quickLog2(how.scale.from), times = 1 / (quickLog2(how.scale.to) - low);
    const IsolineSet lines(how.scale);
    for (int y = first; y < last; ++y) {
        const float* const logs = &logs_[band.row(y)];
        const int before = std::max(y - 1, band.first), after = std::min(y + 1, band.last - 1);
        const float *const above = &smooth_[band.row(before)], *const below = &smooth_[band.row(after)],
                           *const here = &smooth_[band.row(y)];
        const float down = kLog10Of2 / static_cast<float>(std::max(after - before, 1));
        Rgba8* const to = &image.at(part.left, y);
        for (int x = 0; x < part.columns; ++x) {
            const float value = (logs[x] - low) * times;
            to[x] = std::isnan(value) ? kNoValue : valueColour(value);
            if (!how.isolines || std::isnan(here[x])) continue;
            const int left = std::max(x - 1, 0), right = std::min(x + 1, part.columns - 1);
            const float dx =
                kLog10Of2 * (here[right] - here[left]) / static_cast<float>(std::max(right - left, 1));
            const float dy = down * (below[x] - above[x]);
            if (std::isnan(dx + dy)) continue;
            const Isoline line = lines.at(kLog10Of2 * here[x], dx * dx + dy * dy);
            if (line.coverage > 0) to[x] = withLine(to[x], line);
        }
    }
}

void paintFalseColours(const HdrImage& radiance, const FalseColours& how, const PixelArea& part,
                       LdrImage& image) {
    FalseColourPainter painter;
    for (int y = part.top; y < part.top + part.rows; y += kFalseColourRows)
        painter.paint(radiance, how, part, y, std::min(y + kFalseColourRows, part.top + part.rows), image);
}

std::vector<float> isovalues(const ValueScale& scale) { return roundValues(scale, kMaxIsovalues); }

} // namespace rtcore
