/// Reconstructs an image from samples at sub-pixel positions; fills pixels without one.
#pragma once

#include "rtcore/live/live_samples.h"
#include "rtcore/live/sample_means.h"
#include "rtcore/render/frame.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace rtcore {

struct Columns;

/// Keeps its memory from frame to frame.
class Reconstruction {
  public:
    /// Writes frame.radiance, whose size is that of the samples. Each pixel is the weighted mean of the
    /// samples within one pixel of its middle, the nearer the more, of both layers; where few or none are
    /// known, a mean over a wider area. Where all samples are in the middles of their pixels, each pixel
    /// shows its own.
    void show(const LiveLayers& samples, int threads, Frame& frame);

  private:
    /// A pixel whose specular light is not known, and the tint of it.
    struct MissingLight {
        std::size_t pixel;
        Colour tint;
    };
    /// Memory of one thread.
    struct Rows {
        std::vector<float> values; ///< a few rows of samples, with what each weighs in the pixels beside
        std::vector<std::uint32_t> lacking;
        std::vector<float> known; ///< of a part of a row
        std::vector<MissingLight> missing;
    };
    bool showColumns(const LiveLayers& samples, int first, int last, const Columns& columns, Rows& rows,
                     Frame& frame);
    void addMissing(const LiveLayers& samples, int threads, Frame& frame);
    void fill(int threads, Frame& frame);

    std::vector<Rows> rows_;   ///< by thread
    std::vector<float> known_; ///< by pixel: how well its light is known
    SampleMeans means_;
};

} // namespace rtcore
