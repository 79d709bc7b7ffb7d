/// Selects the pixels of a frame that are traced anew: those without a sample, then those whose stale sample
/// is visible as such.
#pragma once

#include "rtcore/live/live_samples.h"
#include "rtcore/sampling/sample_id.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace rtcore {

/// Keeps its memory from frame to frame.
class PixelSelector {
  public:
    /// Begins a frame of that plane.
    void begin(const ImagePlane& plane);
    /// Measures the samples of the rows from `first` to before `last`. Each row once before choose();
    /// different rows may be measured by several threads at once.
    void look(const LiveLayers& samples, int first, int last);
    /// Selects at most `fraction` (0..1) of all pixels, and a few more for checks. `staleness`:
    /// Reprojection::staleness(). The selection depends on these values and on `number` alone: not on
    /// threads, nor on time. Runs on `threads` threads.
    void choose(const LiveLayers& samples, const PixelArray<float>& staleness, double fraction,
                std::uint32_t number, int threads);

    /// The luminance of each pixel's sample, below 0 where it has none; traced() sets that of a new one.
    std::span<const float> luminances(const ImagePlane& plane, int y) const;
    void traced(const ImagePlane& plane, int x, int y, float luminance);
    /// In an order in which neighbours follow each other.
    const std::vector<SampleId>& chosen() const { return chosen_; }
    /// A selected pixel that is compared with its sample; evenly spread over the image, whatever is known.
    struct Check {
        std::size_t chosen; ///< index in chosen()
        bool blind;         ///< selected for the check alone, not by its priority
    };
    const std::vector<Check>& checked() const { return checked_; }
    /// Pixels that had no sample, of all.
    double unknown() const { return unknown_; }

  private:
    /// Priorities of pixels: 0 = needs no new sample, kPriorities - 1: has none.
    static constexpr std::size_t kPriorities = 128;
    using Histogram = std::array<std::uint32_t, kPriorities>;
    /// A row of squares of pixels, whose work is done together.
    struct Part {
        Histogram histogram;
        std::vector<std::uint32_t> priority; ///< of a row of pixels
        std::vector<SampleId> chosen;
        std::vector<Check> checked; ///< with indices in `chosen` above
    };
    struct Bound {
        std::size_t priority;
        std::uint32_t turns;      ///< of kTurns, of the pixels with just this priority
        std::uint32_t checks = 0; ///< of kTurns, of all
    };

    static std::size_t luminanceAt(const ImagePlane& plane, int y);
    float darkness(const ImagePlane& plane) const;
    void measurePriority(const LiveSamples& samples, const PixelArray<float>& staleness, int threads);
    Bound boundOf(const LiveSamples& samples, double fraction);
    void collect(const ImagePlane& plane, const Bound& bound, std::uint32_t number, Part& part, int first,
                 int last) const;

    std::vector<float> luminance_;       ///< by pixel, rows from luminanceAt() on; below 0: no sample
    std::vector<std::uint8_t> priority_; ///< by pixel
    std::vector<Part> parts_;
    std::vector<SampleId> chosen_;
    std::vector<Check> checked_;
    double unknown_ = 0;
};

} // namespace rtcore
