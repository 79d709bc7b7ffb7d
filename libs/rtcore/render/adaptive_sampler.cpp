#include "rtcore/render/adaptive_sampler.h"

#include "rtcore/settings/integrator_traits.h"
#include "rtcore/simd/portable_math.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace rtcore {

namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();

float shownPart(float radiance, float exposure) { return std::sqrt(1 - exposure / (radiance + exposure)); }
float largestDifference(Colour a, Colour b) {
    return std::max({std::fabs(a.r - b.r), std::fabs(a.g - b.g), std::fabs(a.b - b.b)});
}

} // namespace

bool isFirstSample(std::uint32_t sub, int n) {
    const int column = static_cast<int>(sub) % n, row = static_cast<int>(sub) / n;
    const int firstColumn = column / 2 * 2 + (row / 2 & 1), firstRow = row / 2 * 2 + (~(column / 2) & 1);
    return column == std::min(firstColumn, n - 1) && row == std::min(firstRow, n - 1);
}

int firstSamples(int n) { return ((n + 1) / 2) * ((n + 1) / 2); }

bool samplesAdaptively(const RenderSettings& settings) {
    return !traitsOf(settings.integrator).samplesAllLight && settings.adaptive > 0 &&
           settings.antialiasing > 1;
}

void AdaptiveSampler::begin(const RenderSettings& settings) {
    width_ = settings.width;
    height_ = settings.height;
    threshold_ = settings.adaptive;
    key_ = settings.exposure.key;
    fraction_ = 1 / static_cast<float>(firstSamples(settings.antialiasing));
    extents_.assign(at(0, height_), {{kInfinity, kInfinity, kInfinity}, {}});
    refined_.resize(extents_.size());
}

void AdaptiveSampler::add(int x, int y, Colour c) {
    Extent& e = extents_[at(x, y)];
    e.lowest = {std::min(e.lowest.r, c.r), std::min(e.lowest.g, c.g), std::min(e.lowest.b, c.b)};
    e.highest = {std::max(e.highest.r, c.r), std::max(e.highest.g, c.g), std::max(e.highest.b, c.b)};
}

void AdaptiveSampler::measure(const HdrImage& sums) {
    constexpr int kStep = 3; // a part of the pixels is enough
    double sum = 0;
    int count = 0;
    for (int y = 0; y < height_; y += kStep) {
        for (int x = 0; x < width_; x += kStep) {
            const float y1 = luminance(sums.at(x, y)) * fraction_;
            if (!(y1 > 0) || !std::isfinite(y1)) continue;
            sum += static_cast<double>(portableLog2(y1));
            ++count;
        }
    }
    exposure_ = count == 0 ? 1 : portableExp2(static_cast<float>(sum / count)) / key_;
}

Colour AdaptiveSampler::shown(Colour c) const {
    return {shownPart(c.r, exposure_), shownPart(c.g, exposure_), shownPart(c.b, exposure_)};
}

float AdaptiveSampler::error(int x, int y, const HdrImage& sums) const {
    const Extent& e = extents_[at(x, y)];
    float error = largestDifference(shown(e.lowest), shown(e.highest));
    const Colour mean = shown(sums.at(x, y) * fraction_);
    const auto compare = [&](int beside, int below) {
        error = std::max(error, largestDifference(mean, shown(sums.at(beside, below) * fraction_)));
    };
    if (x > 0) compare(x - 1, y);
    if (y > 0) compare(x, y - 1);
    if (x + 1 < width_) compare(x + 1, y);
    if (y + 1 < height_) compare(x, y + 1);
    return error;
}

void AdaptiveSampler::choose(const PixelArea& area, const HdrImage& sums) {
    for (int y = area.top; y < area.top + area.rows; ++y) {
        for (int x = area.left; x < area.left + area.columns; ++x) {
            refined_[at(x, y)] = error(x, y, sums) > threshold_ ? 1 : 0;
        }
    }
}

} // namespace rtcore
