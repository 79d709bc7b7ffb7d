#include "rtcore/post/exposure.h"

#include <algorithm>
#include <bit>
#include <cmath>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "rtcore/post/exposure.cpp"
#include "rtcore/simd/foreach_target.h"

#include "rtcore/math/float3-inl.h"

#ifndef RTCORE_POST_EXPOSURE_BINS
#define RTCORE_POST_EXPOSURE_BINS
namespace rtcore {

/// Bins of a histogram over the bits of a positive float: 256 in each power of two.
inline constexpr int kBinShift = 15;
inline constexpr std::size_t kBins = std::size_t{0x7F800000U} >> kBinShift;
/// Pixels whose bins are found at once.
inline constexpr std::size_t kBinBlock = 64;

} // namespace rtcore
#endif

HWY_BEFORE_NAMESPACE();
namespace rtcore {
namespace HWY_NAMESPACE {

/// The bin of each luminance, kBins where it does not count.
HWY_INLINE Uint binOf(Float y) {
    const Float infinity = std::numeric_limits<float>::infinity();
    return shiftRight<kBinShift>(bitsOf(select((y > 0.0F) & (y < infinity), y, infinity)));
}
void binsOfColours(const float* HWY_RESTRICT rgb, std::uint32_t* HWY_RESTRICT bins) {
    for (std::size_t i = 0; i < kBinBlock; i += lanes())
        store(binOf(luminance<Float>(loadInterleaved(rgb + 3 * i))), bins + i);
}
void binsOfLuminances(const float* HWY_RESTRICT luminances, std::uint32_t* HWY_RESTRICT bins) {
    for (std::size_t i = 0; i < kBinBlock; i += lanes()) store(binOf(load(luminances + i)), bins + i);
}

} // namespace HWY_NAMESPACE
} // namespace rtcore
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace rtcore {

HWY_EXPORT(binsOfColours);
HWY_EXPORT(binsOfLuminances);

namespace {

constexpr double kDropped = 0.1; ///< fraction of the weight at each end

float middleOfBin(std::size_t bin) {
    return std::bit_cast<float>(
        static_cast<std::uint32_t>(bin << kBinShift | std::size_t{1} << (kBinShift - 1)));
}

void binsOf(const Colour* pixels, std::uint32_t* bins) {
    HWY_DYNAMIC_DISPATCH(binsOfColours)(&pixels->r, bins);
}
void binsOf(const float* luminances, std::uint32_t* bins) {
    HWY_DYNAMIC_DISPATCH(binsOfLuminances)(luminances, bins);
}

/// `weightOf` gives the weight of a pixel by its index.
template <typename Pixel, typename Weight>
void countAll(std::span<const Pixel> pixels, std::int64_t* histogram, Weight&& weightOf) {
    std::uint32_t bins[kBinBlock];
    Pixel last[kBinBlock] = {};
    for (std::size_t first = 0; first < pixels.size(); first += kBinBlock) {
        const std::size_t n = std::min(kBinBlock, pixels.size() - first);
        const Pixel* block = &pixels[first];
        if (n < kBinBlock) block = std::copy_n(block, n, last) - n;
        binsOf(block, bins);
        for (std::size_t i = 0; i < n; ++i) histogram[bins[i]] += weightOf(first + i);
    }
}

} // namespace

void LuminanceHistogram::clear() {
    bins_.assign(kBins + 1, 0);
    possible_ = 0;
}

void LuminanceHistogram::count(std::span<const Colour> pixels, std::span<const std::uint8_t> weights) {
    if (bins_.empty()) clear();
    possible_ += 255 * static_cast<std::int64_t>(pixels.size());
    countAll(pixels, bins_.data(), [&](std::size_t i) { return std::int64_t{weights[i]}; });
}

void LuminanceHistogram::count(std::span<const Colour> pixels) {
    if (bins_.empty()) clear();
    possible_ += 255 * static_cast<std::int64_t>(pixels.size());
    countAll(pixels, bins_.data(), [](std::size_t) { return std::int64_t{255}; });
}

void LuminanceHistogram::count(std::span<const float> luminances, std::span<const std::uint8_t> weights) {
    if (bins_.empty()) clear();
    possible_ += 255 * static_cast<std::int64_t>(luminances.size());
    countAll(luminances, bins_.data(), [&](std::size_t i) { return std::int64_t{weights[i]}; });
}

void LuminanceHistogram::add(const LuminanceHistogram& other) {
    if (bins_.empty()) clear();
    for (std::size_t i = 0; i < other.bins_.size(); ++i) bins_[i] += other.bins_[i];
    possible_ += other.possible_;
}

void LuminanceHistogram::correct(std::span<const CheckedPixel> checked, std::int64_t times) {
    if (bins_.empty()) clear();
    const auto countOne = [&](float luminance, std::int64_t weight) {
        countAll(std::span<const float>(&luminance, 1), bins_.data(), [&](std::size_t) { return weight; });
    };
    for (const CheckedPixel& pixel : checked) {
        countOne(pixel.kept, -times * pixel.keptCovered);
        countOne(pixel.traced, times * pixel.tracedCovered);
    }
}

std::optional<float> LuminanceHistogram::logAverage() const {
    std::int64_t valid = 0;
    const std::size_t bins = bins_.empty() ? 0 : kBins;
    for (std::size_t bin = 0; bin < bins; ++bin) valid += bins_[bin];
    if (valid <= 0 || valid * 100 < possible_) return std::nullopt;

    const double from = kDropped * static_cast<double>(valid);
    const double to = (1 - kDropped) * static_cast<double>(valid);
    double below = 0;
    double sum = 0;
    for (std::size_t bin = 0; bin < bins; ++bin) {
        if (bins_[bin] == 0) continue;
        const double above = below + static_cast<double>(bins_[bin]);
        const double kept = std::clamp(above, from, to) - std::clamp(below, from, to);
        if (kept != 0) sum += kept * static_cast<double>(portableLog2(middleOfBin(bin)));
        below = above;
    }
    return portableExp2(static_cast<float>(sum / (to - from)));
}

} // namespace rtcore
#endif
