/// Sums of the samples of each pixel in whole numbers: the same bits in whatever order samples and parts are
/// added, by any number of threads or machines. Sums of floats differ with their order in most pixels.
///
/// The unit is u = 2^e with u * 2^25 the smallest power of two, M, that is not below the mean luminance of
/// the image, so a sample is rounded by at most M / 2^26, and a mean keeps that. A channel is clipped to
/// +- (2^18 M - u), which is 2^43 - 1 units. The most samples of a pixel, 2^20, all clipped: 2^20 (2^43 - 1)
/// < 2^63, so no sum overflows. At the mean, there would be room for 2^63 / 2^25 = 2^38 samples.
#pragma once

#include "rtcore/render/sample_halves.h"
#include "rtcore/scene/image.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace rtcore {

/// Different pixels may be added to by different threads at once; nothing else may happen meanwhile.
class ImageSums {
  public:
    static constexpr std::uint32_t kMaxSamples = std::uint32_t{1} << 20; ///< of a pixel

    /// Sums of one pixel.
    struct Pixel {
        std::array<std::int64_t, 3> sum{}; ///< red, green, blue; in units
        std::uint32_t samples = 0;         ///< that were added
        friend bool operator==(const Pixel&, const Pixel&) = default;
    };

    /// No image.
    ImageSums() = default;
    /// Without samples. `meanLuminance`, of a small pass that every part of the image's work repeats to the
    /// bit, chooses the unit; a value that is not finite or not above 0 counts as 1.
    /// `halves`: the sums of SampleHalves::first are kept beside those of all samples.
    ImageSums(int width, int height, float meanLuminance, bool halves = false);

    /// Memory for each pixel, and what halves add to it.
    static constexpr std::size_t kBytesPerPixel = 3 * sizeof(std::int64_t) + sizeof(std::uint32_t);
    static constexpr std::size_t kHalfBytesPerPixel = kBytesPerPixel;

    int width() const { return width_; }
    int height() const { return height_; }
    double largest() const; ///< that a channel of a sample is clipped to

    /// Adds a sample of the pixel (x, y), which has fewer than kMaxSamples. A sample that is not finite is
    /// only counted, in dropped(). Values may be negative. `index` among the pixel's samples, which decides
    /// its half.
    void add(int x, int y, Colour sample, std::uint32_t index = 0) { addRow(x, y, {&sample, 1}, index); }
    /// Adds one sample, of that index, to each of the pixels from (x, y) to the right.
    void addRow(int x, int y, std::span<const Colour> samples, std::uint32_t index = 0);

    /// Adds the samples of `other`, which may be this. Throws std::invalid_argument and leaves this as it was
    /// when size or unit differ, only one has halves, or a pixel would get more than kMaxSamples.
    void merge(const ImageSums& other);

    /// Means of the pixels' samples, black where there are none: an image such as Frame::radiance, whose
    /// memory is reused when the size fits. Off by half a step of float and 2^-52 beside the rounding of the
    /// samples.
    void mean(HdrImage& image) const;

    bool hasHalves() const { return !halfSamples_.empty(); }
    /// Means of the halves: the second is the whole without the first. Empty where none are kept; memory is
    /// reused as by mean().
    void halfMeans(SampleHalves& halves) const;

    Pixel pixel(int x, int y) const;
    Pixel firstHalf(int x, int y) const;               ///< needs hasHalves()
    std::uint64_t dropped() const { return dropped_; } ///< samples that were not finite
    std::uint64_t clipped() const { return clipped_; } ///< samples that were added with a channel clipped

    friend bool operator==(const ImageSums&, const ImageSums&) = default;

  private:
    std::size_t index(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x);
    }
    void checkMerge(const ImageSums& other) const;
    Pixel at(const std::vector<std::int64_t>& sums, const std::vector<std::uint32_t>& samples,
             std::size_t pixel) const;
    Colour mean(const Pixel& pixel) const;

    int width_ = 0, height_ = 0;
    int unitExponent_ = 0;
    double unit_ = 1, unitsPerOne_ = 1; ///< powers of two: products with them are exact
    std::vector<std::int64_t> sums_;    ///< three for each pixel
    std::vector<std::uint32_t> samples_;
    std::vector<std::int64_t> halfSums_; ///< of the first half, as sums_; empty without halves
    std::vector<std::uint32_t> halfSamples_;
    std::uint64_t dropped_ = 0, clipped_ = 0; ///< changed through std::atomic_ref while samples are added
};

} // namespace rtcore
