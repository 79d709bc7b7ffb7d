/// Which points of a frame get new light: those of which none is known, then those where old light shows.
#pragma once

#include "rtcore/live/live_points.h"
#include "rtcore/sampling/sample_id.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace rtcore {

/// Keeps its memory from frame to frame.
class PointChoice {
  public:
    /// Chooses about `share` (0..1) of all pixels. The choice is that of the image and `number` alone: not of
    /// threads, nor of time. `threads` work.
    void choose(const LiveImage& image, double share, std::uint32_t number, int threads);

    /// In an order in which neighbours follow each other.
    const std::vector<SampleId>& chosen() const { return chosen_; }
    /// Pixels of which no light was known, of all.
    double unknown() const { return unknown_; }

  private:
    /// How urgent a pixel is: 0 = not at all, kUrgencies - 1: nothing is known of it.
    static constexpr std::size_t kUrgencies = 128;
    using Histogram = std::array<std::uint32_t, kUrgencies>;

    void measureLuminance(const LiveImage& image, int threads);
    void measureUrgency(const LiveImage& image, int threads);
    std::uint8_t urgencyAt(const LiveImage& image, int x, int y) const;

    std::vector<float> luminance_; ///< by pixel; below 0: not known
    /// Of points whose light is known.
    struct LightSum {
        double luminance = 0;
        std::size_t points = 0;
    };
    std::vector<LightSum> sums_;                 ///< by row of tiles
    float dark_ = 1;                             ///< luminance that hardly shows
    std::vector<std::uint8_t> urgency_;          ///< by pixel
    std::vector<Histogram> histograms_;          ///< by row of tiles
    std::vector<std::vector<SampleId>> ofTiles_; ///< by row of tiles
    std::vector<SampleId> chosen_;
    double unknown_ = 0;
};

} // namespace rtcore
