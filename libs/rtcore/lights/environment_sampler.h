/// Directions sampled in proportion to the light that comes from them: of an image, of the map of a sky, or
/// of an even background.
#pragma once

#include "rtcore/lights/background_light.h"

#include <cstdint>
#include <vector>

namespace rtcore {

/// Arrays for vector code (environment_sampler-inl.h). Images are cut into cells at the middles of their
/// texels, so that a bilinear lookup is one bilinear function in each of them; those at edges are half as
/// wide. Rows count through all images.
struct EnvironmentRows {
    static constexpr int kBits = 30; ///< of random numbers and intervals

    bool cube = false;              ///< of six images, else one of the whole sphere
    int columns = 0, rows = 0;      ///< cells each way of an image; one more than texels
    int allRows = 0;                ///< of all images
    const float* axes = nullptr;    ///< of each image's x, y and z; of a face: its middle, right, down
    const float* depths = nullptr;  ///< of a sphere: 1 - cosine of the angle from the pole, where rows begin
    const float* corners = nullptr; ///< brightness at the cells' corners, image by image, row by row
    /// Intervals whose lengths, over 2^kBits, are the probabilities of rows, and of columns within each row.
    const std::uint32_t *rowStarts = nullptr, *columnStarts = nullptr;
};

/// Samples by the luminance of the bilinear image itself: a row of cells by its integral, a cell of the row
/// by the cell's integral, a position in the cell by the bilinear function between its corners. So all light
/// of an image has the same weight, whether it comes from a sky or from one texel, and nothing is lost: where
/// the image is not black, neither are the corners of its cell. What is looked up unfiltered is up to 4 times
/// as bright as between the corners. Negative light counts by its size.
///
/// Immutable once prepared; safe from many threads. 8 bytes for each texel.
class EnvironmentSampler {
  public:
    /// Takes some 10^-8 s for each texel, on one thread; the same on every machine. Black light makes it
    /// empty, and so do texels that are not finite.
    void prepare(const BackgroundLight& light);

    /// Nothing shines.
    bool empty() const { return rowStarts_.empty(); }

    /// Luminance of the light from all directions: the integral of the radiance over the sphere.
    double scalarIrradiance() const { return scalarIrradiance_; }
    EnvironmentRows rows() const;

  private:
    void takeImages(const Environment& environment, double mean);
    float heightOf(int row) const;
    void setProbabilities();

    bool cube_ = false;
    int columns_ = 0, rows_ = 0;
    std::vector<float> axes_, depths_, corners_;
    std::vector<std::uint32_t> rowStarts_, columnStarts_;
    double scalarIrradiance_ = 0;
};

} // namespace rtcore
