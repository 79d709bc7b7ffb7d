/// The samples of the frame before, where they are seen in this one. (Walter, Drettakis and Parker 1999,
/// "Interactive Rendering using the Render Cache")
#pragma once

#include "rtcore/live/live_samples.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

namespace rtcore {

/// Keeps its memory from frame to frame.
class Reprojection {
  public:
    static constexpr double kMaxPixels = 1 << 27; ///< of an image

    /// Gives each pixel of `present`, whose plane says of which view, that sample of the past that is seen
    /// there, in each layer: of several the nearest to the viewer, and of those about as near the least
    /// stale. A sample that loses its pixel moves to the empty neighbour nearest to it. A pixel without a
    /// sample borrows one of its neighbours', if they have any. So does one, where the eye has moved, in
    /// which something far is seen through a gap of up to two pixels between near samples: surfaces that come
    /// nearer have such gaps, and in parallel views those that turn or are magnified. The same for any number
    /// of `threads`; both images may differ in size. Both are perspective, or both parallel.
    ///
    /// `done` is called by them with each part of the rows that is done, from the first row to before the
    /// last: all layers of these pixels are there then.
    using RowsDone = std::function<void(int first, int last)>;
    void reproject(
        const LiveLayers& past, LiveLayers& present, int threads, const RowsDone& done = [](int, int) {});
    static constexpr int kRowsOfBand = 32; ///< in all parts but the last

    /// Staleness of each pixel's sample of the present, in square pixels, with room for whole vectors: the
    /// square of its distance from the pixel's middle, and some for its age; the greater of two layers.
    /// Undefined without a sample.
    const PixelArray<float>& staleness() const { return staleness_; }

  private:
    /// Samples of the past that follow each other, and the first and the last pixel that shows one of them.
    struct Part {
        std::size_t first = 0, last = 0;
        std::size_t min = 1, max = 0;
    };
    void show(const LiveSamples& past, const ImagePlane& plane, int threads);
    void project(const LiveSamples& past, const ImagePlane& plane, int threads);
    template <typename Work>
    void forEachPartIn(std::size_t first, std::size_t last, Work&& work) const;
    /// Rows of the image that follow each other. Samples that found their pixel taken: in the first and the
    /// last row, beside which are those of other bands, and in those between.
    struct Band {
        std::vector<std::uint32_t> inside, atEdge;
    };
    void compete(const ImagePlane& plane, int firstRow, int lastRow);
    void spread(const ImagePlane& plane, const std::vector<std::uint32_t>& losers);
    const std::uint64_t* shownIn(const ImagePlane& plane, int y);
    void take(const LiveLayers& past, const std::uint64_t* nearest, LiveLayers& present, std::size_t first,
              std::size_t last);
    void takeSpecular(const LiveSamples& past, const std::uint64_t* entries, LiveLayers& layers,
                      std::size_t first, std::size_t last);

    bool gaps_ = false; ///< something far may be seen through surfaces that are spread
    std::vector<Part> parts_;
    // By sample of the past.
    PixelArray<std::int32_t> pixels_{6}; ///< the pixel that shows it, the direction to the next; -1: none
    PixelArray<std::uint32_t> keys_{7};
    // By pixel of the present, and by those beyond the image's edges.
    PixelArray<std::uint64_t> nearest_{8}; ///< depth, staleness, index of the sample
    PixelArray<float> staleness_{9};
    std::vector<Band> bands_;
    std::vector<std::vector<std::uint64_t>> rows_; ///< by thread: the entries of one
};

} // namespace rtcore
