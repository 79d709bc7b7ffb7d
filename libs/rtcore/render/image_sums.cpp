#include "rtcore/render/image_sums.h"

#include "rtcore/platform/large_vector.h"

#include <fmt/core.h>

#include <algorithm>
#include <atomic>
#include <cassert>
#include <cmath>
#include <stdexcept>

namespace rtcore {

namespace {

constexpr int kBitsOfMean = 25;
constexpr std::int64_t kMaxUnits = (std::int64_t{1} << (kBitsOfMean + 18)) - 1;
static_assert(kMaxUnits <= INT64_MAX / ImageSums::kMaxSamples);

/// The least e with 2^e >= value.
int ceilLog2(float value) {
    int exponent = 0;
    const float fraction = std::frexp(value, &exponent); // 0.5 <= fraction < 1
    return fraction == 0.5F ? exponent - 1 : exponent;
}

/// Rounds to the nearest unit, halves away from 0. Exact: a double holds halves up to 2^52.
std::int64_t toUnits(double units) {
    constexpr auto kLimit = static_cast<double>(kMaxUnits);
    return static_cast<std::int64_t>(std::clamp(units, -kLimit, kLimit) + (units < 0 ? -0.5 : 0.5));
}

void increase(std::uint64_t& counter, std::uint64_t more) {
    if (more != 0) std::atomic_ref(counter).fetch_add(more, std::memory_order_relaxed);
}

} // namespace

ImageSums::ImageSums(int width, int height, float meanLuminance, bool halves)
    : width_(width), height_(height),
      unitExponent_(ceilLog2(std::isfinite(meanLuminance) && meanLuminance > 0 ? meanLuminance : 1) -
                    kBitsOfMean),
      unit_(std::ldexp(1.0, unitExponent_)), unitsPerOne_(std::ldexp(1.0, -unitExponent_)) {
    assert(width >= 0 && height >= 0);
    const std::size_t pixels = index(0, height);
    resizeLarge(sums_, 3 * pixels);
    resizeLarge(samples_, pixels);
    if (!halves) return;
    resizeLarge(halfSums_, 3 * pixels);
    resizeLarge(halfSamples_, pixels);
}

double ImageSums::largest() const { return static_cast<double>(kMaxUnits) * unit_; }

void ImageSums::addRow(int x, int y, std::span<const Colour> samples, std::uint32_t index) {
    assert(x >= 0 && y >= 0 && y < height_ && samples.size() <= static_cast<std::size_t>(width_ - x));
    std::uint64_t dropped = 0, clipped = 0;
    const bool half = hasHalves() && inFirstHalf(index);
    std::size_t i = this->index(x, y);
    for (const Colour& sample : samples) {
        const std::size_t pixel = i++;
        if (!isFinite(sample)) {
            ++dropped;
            continue;
        }
        assert(samples_[pixel] < kMaxSamples);
        const std::array<double, 3> units{sample.r * unitsPerOne_, sample.g * unitsPerOne_,
                                          sample.b * unitsPerOne_};
        bool beyond = false;
        for (std::size_t channel = 0; channel < 3; ++channel) {
            const std::int64_t rounded = toUnits(units[channel]);
            sums_[3 * pixel + channel] += rounded;
            if (half) halfSums_[3 * pixel + channel] += rounded;
            beyond |= std::fabs(units[channel]) > static_cast<double>(kMaxUnits);
        }
        ++samples_[pixel];
        if (half) ++halfSamples_[pixel];
        clipped += beyond ? 1 : 0;
    }
    increase(dropped_, dropped);
    increase(clipped_, clipped);
}

void ImageSums::checkMerge(const ImageSums& other) const {
    if (other.width_ != width_ || other.height_ != height_) {
        throw std::invalid_argument(fmt::format("the parts are of images of {} x {} and {} x {} pixels",
                                                width_, height_, other.width_, other.height_));
    }
    if (other.unitExponent_ != unitExponent_) {
        throw std::invalid_argument(
            fmt::format("the parts count in units of 2^{} and 2^{}; they are of other "
                        "scenes, views or settings",
                        unitExponent_, other.unitExponent_));
    }
    if (other.hasHalves() != hasHalves())
        throw std::invalid_argument("only some of the parts have halves of their samples");
    for (std::size_t i = 0; i < samples_.size(); ++i) {
        if (other.samples_[i] > kMaxSamples - samples_[i]) {
            throw std::invalid_argument(
                fmt::format("the parts have more than {} samples of a pixel", kMaxSamples));
        }
    }
}

void ImageSums::merge(const ImageSums& other) {
    checkMerge(other);
    for (std::size_t i = 0; i < sums_.size(); ++i) sums_[i] += other.sums_[i];
    for (std::size_t i = 0; i < samples_.size(); ++i) samples_[i] += other.samples_[i];
    for (std::size_t i = 0; i < halfSums_.size(); ++i) halfSums_[i] += other.halfSums_[i];
    for (std::size_t i = 0; i < halfSamples_.size(); ++i) halfSamples_[i] += other.halfSamples_[i];
    dropped_ += other.dropped_;
    clipped_ += other.clipped_;
}

ImageSums::Pixel ImageSums::at(const std::vector<std::int64_t>& sums,
                               const std::vector<std::uint32_t>& samples, std::size_t pixel) const {
    return {{sums[3 * pixel], sums[3 * pixel + 1], sums[3 * pixel + 2]}, samples[pixel]};
}

Colour ImageSums::mean(const Pixel& pixel) const {
    const double samples = std::max(pixel.samples, 1U);
    const auto meanOf = [&](std::size_t channel) {
        return static_cast<float>(static_cast<double>(pixel.sum[channel]) / samples * unit_);
    };
    return {meanOf(0), meanOf(1), meanOf(2)};
}

void ImageSums::mean(HdrImage& image) const {
    if (image.width != width_ || image.height != height_) image = HdrImage(width_, height_);
    for (std::size_t i = 0; i < samples_.size(); ++i) image.pixels[i] = mean(at(sums_, samples_, i));
}

void ImageSums::halfMeans(SampleHalves& halves) const {
    if (!hasHalves()) {
        halves = {};
        return;
    }
    for (HdrImage* image : {&halves.first, &halves.second})
        if (image->width != width_ || image->height != height_) *image = HdrImage(width_, height_);
    std::uint64_t all = 0, first = 0;
    for (std::size_t i = 0; i < samples_.size(); ++i) {
        const Pixel whole = at(sums_, samples_, i), half = at(halfSums_, halfSamples_, i);
        Pixel rest{{}, whole.samples - half.samples};
        for (std::size_t channel = 0; channel < 3; ++channel)
            rest.sum[channel] = whole.sum[channel] - half.sum[channel];
        halves.first.pixels[i] = mean(half);
        halves.second.pixels[i] = mean(rest);
        all += whole.samples;
        first += half.samples;
    }
    halves.firstFraction =
        all > 0 ? static_cast<float>(static_cast<double>(first) / static_cast<double>(all)) : 0.5F;
    halves.samples =
        static_cast<std::uint32_t>((all + samples_.size() / 2) / std::max<std::size_t>(samples_.size(), 1));
}

ImageSums::Pixel ImageSums::pixel(int x, int y) const { return at(sums_, samples_, index(x, y)); }

ImageSums::Pixel ImageSums::firstHalf(int x, int y) const {
    assert(hasHalves());
    return at(halfSums_, halfSamples_, index(x, y));
}

} // namespace rtcore
