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
    /// Writes frame.radiance, whose size is that of the samples: each pixel shows the light of the samples
    /// around its middle, the nearer the more, within one pixel, and where these mirror, in the same way the
    /// light that is mirrored there; or, where there are few or none of either, a mean over more that is
    /// known around. Where all samples are in the middles of their pixels, each shows its own.
    void show(const LiveLayers& samples, int threads, Frame& frame);

  private:
    /// A pixel that shows mirrored light which is not known, and what it would be tinted by.
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
