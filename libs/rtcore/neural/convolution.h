/// Convolutions of 3 x 3 pixels with bias and ReLU, the layers of a U-Net. Vector code, with the same bits
/// for every instruction set: each output sums its inputs in one fixed order, multiplied and then added.
#pragma once

#include <cstddef>
#include <vector>

namespace rtcore {

/// Channels of pixels and of weights are padded to a multiple of this, the widest vector.
inline constexpr int kChannelStep = 16;
constexpr int paddedChannels(int channels) {
    return (channels + kChannelStep - 1) / kChannelStep * kChannelStep;
}

/// Rows of an image, channels last. Of a ring only the last rows are kept: row y is at y % rows.
struct FeaturePlane {
    float* values = nullptr;
    int width = 0, height = 0;
    int stride = 0; ///< floats from pixel to pixel, a multiple of kChannelStep
    int rows = 1;   ///< that are kept

    float* row(int y) const {
        return values + static_cast<std::size_t>(y % rows) * static_cast<std::size_t>(width) *
                            static_cast<std::size_t>(stride);
    }
};

/// Weights of a layer in the order in which they are used.
struct ConvolutionWeights {
    int inputs = 0, outputs = 0;
    int firstInputs = 0;     ///< of the first source; the others are of the second one
    bool upsampled = false;  ///< each pixel of the first source stands for 2 x 2
    bool direct = false;     ///< not by Winograd's algorithm
    std::vector<float> bias; ///< padded
    /// By Winograd, for each source: [point][input][padded output], points of 6 x 6, or 5 x 5 where it is
    /// upsampled.
    std::vector<float> points[2];
    std::vector<float> taps; ///< direct: [row][column][input][padded output]
};
/// `oihw`: outputs x inputs x 3 x 3. `weights` has all but the numbers.
void arrangeWeights(ConvolutionWeights& weights, const std::vector<float>& oihw,
                    const std::vector<float>& bias);

/// One layer of a net on one image. Pixels beyond the border are zero.
struct Convolution {
    const ConvolutionWeights* weights = nullptr;
    FeaturePlane sources[2];
    FeaturePlane result;
    int width = 0, height = 0; ///< before pooling
    bool pool = false;         ///< the result has the maxima of 2 x 2 pixels

    int sourceCount() const { return weights->inputs > weights->firstInputs ? 2 : 1; }
    int squareRows() const { return (height + 3) / 4; }
    int squareColumns() const { return (width + 3) / 4; }
};

/// The result is computed by blocks of so many squares of 4 x 4 pixels beside each other.
inline constexpr int kBlockSquares = 24;

/// Floats of scratch memory that convolve() needs; finite numbers, such as zeros, at first.
std::size_t convolutionScratch(const ConvolutionWeights& weights);

/// The squares from `column` on of that row of squares; safe from many threads with a `scratch` each. Rows of
/// the sources one pixel above and below have to be there.
void convolve(const Convolution& layer, int row, int column, int squares, float* scratch);

} // namespace rtcore
