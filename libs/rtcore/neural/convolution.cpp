#include "rtcore/neural/convolution.h"

#include <algorithm>
#include <cstring>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "rtcore/neural/convolution.cpp"
#include "rtcore/simd/foreach_target.h"

#include "rtcore/neural/products-inl.h"
#include "rtcore/neural/winograd-inl.h"

#ifndef RTCORE_NEURAL_CONVOLUTION_TYPES
#define RTCORE_NEURAL_CONVOLUTION_TYPES
namespace rtcore {
namespace {

constexpr int kSide = 4;                      ///< pixels of a square
constexpr int kSquarePixels = kSide * kSide;  //
constexpr int kMaxRows = 24;                  ///< that products may write for kBlockSquares of them
constexpr int kMaxColumns = 4 * kChannelStep; ///< outputs at once
constexpr int kPointsOfSquare = 36, kPointsOfUpsampled = 25;
/// Planes of points are a little more than a power of two apart, or they would share sets of the cache.
constexpr std::size_t kApart = 16;
static_assert(kBlockSquares <= kMaxRows && kBlockSquares % 12 == 0);

std::size_t pointStride(int channels) {
    return static_cast<std::size_t>(kMaxRows * paddedChannels(channels)) + kApart;
}
constexpr std::size_t kSumStride = static_cast<std::size_t>(kMaxColumns);
constexpr std::size_t kSumPlane = kMaxRows * kSumStride + kApart;
/// A row of a patch whose pixels lie beyond the border, of the widest layer that an archive may have.
constexpr int kMaxChannels = 1024;
alignas(64) constexpr float kZeros[kMaxChannels] = {};

/// The channels of source `s`.
int channelsOf(const ConvolutionWeights& weights, int s) {
    return s == 0 ? weights.firstInputs : weights.inputs - weights.firstInputs;
}

} // namespace
} // namespace rtcore
#endif

HWY_BEFORE_NAMESPACE();
namespace rtcore {
namespace HWY_NAMESPACE {

/// The pixels of a patch whose upper left one is (left, top), with zeros beyond the border. `copy` has room
/// for them.
template <int kPixels>
class Patch {
  public:
    HWY_INLINE Patch(const FeaturePlane& plane, int left, int top, int channels, float* copy) {
        const bool inside = left >= 0 && left + kPixels <= plane.width;
        for (int i = 0; i < kPixels; ++i) {
            const int y = top + i;
            if (y < 0 || y >= plane.height) {
                rows_[i] = kZeros;
                steps_[i] = 0;
            } else if (inside) {
                rows_[i] =
                    plane.row(y) + static_cast<std::size_t>(left) * static_cast<std::size_t>(plane.stride);
                steps_[i] = static_cast<std::size_t>(plane.stride);
            } else {
                rows_[i] = copy;
                steps_[i] = static_cast<std::size_t>(channels);
                for (int j = 0; j < kPixels; ++j, copy += channels)
                    copyPixel(plane, left + j, y, channels, copy);
            }
        }
    }
    HWY_INLINE const float* at(int column, int row) const {
        return rows_[row] + static_cast<std::size_t>(column) * steps_[row];
    }

  private:
    static HWY_INLINE void copyPixel(const FeaturePlane& plane, int x, int y, int channels, float* to) {
        const std::size_t bytes = sizeof(float) * static_cast<std::size_t>(channels);
        if (x < 0 || x >= plane.width) {
            std::memset(to, 0, bytes);
        } else {
            std::memcpy(to,
                        plane.row(y) + static_cast<std::size_t>(x) * static_cast<std::size_t>(plane.stride),
                        bytes);
        }
    }

    const float* rows_[kPixels];
    std::size_t steps_[kPixels];
};

/// B^T d B of one patch, a vector of channels: planes of points, `stride` apart.
template <typename Transform>
HWY_INLINE void transformPatch(const Patch<Transform::kPixels>& patch, int channel, std::size_t stride,
                               float* to) {
    constexpr int kPixels = Transform::kPixels, kPoints = Transform::kPoints;
    Float columns[kPixels][kPoints];
    for (int x = 0; x < kPixels; ++x) {
        Float pixels[kPixels];
        for (int y = 0; y < kPixels; ++y) pixels[y] = load(patch.at(x, y) + channel);
        Transform::apply(pixels, columns[x]);
    }
    for (int p = 0; p < kPoints; ++p) {
        Float row[kPixels], points[kPoints];
        for (int x = 0; x < kPixels; ++x) row[x] = columns[x][p];
        Transform::apply(row, points);
        for (int q = 0; q < kPoints; ++q)
            store(points[q], to + static_cast<std::size_t>(p * kPoints + q) * stride);
    }
}

/// The points of the patches of some squares: [point][square][channel].
template <typename Transform>
HWY_NOINLINE void transformInput(const FeaturePlane& plane, int channels, int row, int column, int squares,
                                 float* points, float* copy) {
    const int padded = paddedChannels(channels);
    const std::size_t stride = pointStride(channels);
    constexpr int kStep = Transform::kPixels - 2; // of patches, which overlap by two pixels
    for (int s = 0; s < squares; ++s, points += padded) {
        const Patch<Transform::kPixels> patch(plane, (column + s) * kStep - 1, row * kStep - 1, padded, copy);
        for (int c = 0; c < channels; c += static_cast<int>(kLanes))
            transformPatch<Transform>(patch, c, stride, points + c);
    }
}

/// Bias and ReLU of the pixels of a square, then the pixels or their maxima of 2 x 2: a vector of channels.
HWY_INLINE void writeSquare(const Convolution& layer, int row, int column, int channel, Float* pixels) {
    const Float bias = load(layer.weights->bias.data() + channel);
    for (int i = 0; i < kSquarePixels; ++i) pixels[i] = max(pixels[i] + bias, Float(0));
    int side = kSide;
    if (layer.pool) {
        side = kSide / 2;
        for (int y = 0; y < side; ++y) {
            for (int x = 0; x < side; ++x) {
                const Float* const four = pixels + 2 * y * kSide + 2 * x;
                pixels[y * side + x] = max(max(four[0], four[1]), max(four[kSide], four[kSide + 1]));
            }
        }
    }
    const FeaturePlane& result = layer.result;
    const int rows = std::min(side, result.height - row * side);
    const int columns = std::min(side, result.width - column * side);
    for (int y = 0; y < rows; ++y) {
        float* to = result.row(row * side + y) +
                    static_cast<std::size_t>(column * side) * static_cast<std::size_t>(result.stride) +
                    channel;
        for (int x = 0; x < columns; ++x, to += result.stride) store(pixels[y * side + x], to);
    }
}

/// A^T m A of the sums of some squares, `vectors` of channels, and their end.
HWY_NOINLINE void transformOutput(const Convolution& layer, int row, int column, int squares, int channel,
                                  int vectors, const float* sums) {
    constexpr int kPoints = 6;
    for (int s = 0; s < squares; ++s, sums += kSumStride) {
        for (int v = 0; v < vectors; ++v) {
            const float* const from = sums + static_cast<std::size_t>(v) * kLanes;
            Float half[kSide][kPoints], pixels[kSquarePixels];
            for (int q = 0; q < kPoints; ++q) {
                Float points[kPoints], four[kSide];
                for (int p = 0; p < kPoints; ++p)
                    points[p] = load(from + static_cast<std::size_t>(p * kPoints + q) * kSumPlane);
                outputTransform(points, four);
                for (int y = 0; y < kSide; ++y) half[y][q] = four[y];
            }
            for (int y = 0; y < kSide; ++y) outputTransform(half[y], pixels + kSide * y);
            writeSquare(layer, row, column + s, channel + v * static_cast<int>(kLanes), pixels);
        }
    }
}

/// The index of each point of an upsampled source among the 25 that are not zero; -1 of a zero.
HWY_INLINE int upsampledPoint(int point) {
    const int row = point / 6, column = point % 6;
    if (row == 2 || column == 2) return -1;
    return (row > 2 ? row - 1 : row) * 5 + (column > 2 ? column - 1 : column);
}

void convolveByPoints(const Convolution& layer, int row, int column, int squares, float* scratch) {
    const ConvolutionWeights& weights = *layer.weights;
    const int sources = layer.sourceCount();
    float* points[2] = {scratch, nullptr};
    const std::size_t firstPoints = weights.upsampled ? kPointsOfUpsampled : kPointsOfSquare;
    points[1] = points[0] + firstPoints * pointStride(weights.firstInputs);
    float* const sums = points[1] + (sources > 1 ? kPointsOfSquare * pointStride(channelsOf(weights, 1)) : 0);
    float* const copy = sums + kPointsOfSquare * kSumPlane;
    for (int s = 0; s < sources; ++s) {
        const auto transform = s == 0 && weights.upsampled ? transformInput<UpsampledInputTransform>
                                                           : transformInput<InputTransform>;
        transform(layer.sources[s], channelsOf(weights, s), row, column, squares, points[s], copy);
    }
    const auto outputs = static_cast<std::size_t>(paddedChannels(weights.outputs));
    const int all = (weights.outputs + static_cast<int>(kLanes) - 1) / static_cast<int>(kLanes);
    for (int first = 0; first < all;) {
        const int vectors = vectorsAtOnce(all - first);
        const int channel = first * static_cast<int>(kLanes);
        for (int point = 0; point < kPointsOfSquare; ++point) {
            Terms terms[2];
            std::size_t count = 0;
            for (int s = 0; s < sources; ++s) {
                const int at = s == 0 && weights.upsampled ? upsampledPoint(point) : point;
                if (at < 0) continue;
                const int channels = channelsOf(weights, s);
                const auto index = static_cast<std::size_t>(at);
                terms[count++] = {points[s] + index * pointStride(channels),
                                  weights.points[s].data() +
                                      index * static_cast<std::size_t>(channels) * outputs +
                                      static_cast<std::size_t>(channel),
                                  channels, static_cast<std::size_t>(paddedChannels(channels))};
            }
            sumProducts({terms, count}, squares, vectors, outputs,
                        sums + static_cast<std::size_t>(point) * kSumPlane, kSumStride);
        }
        transformOutput(layer, row, column, squares, channel, vectors, sums);
        first += vectors;
    }
}

/// The pixels around some squares, the channels of both sources joined: six rows.
HWY_INLINE void joinRows(const Convolution& layer, int row, int column, int squares, float* rows) {
    const ConvolutionWeights& weights = *layer.weights;
    for (int i = 0; i < kSide + 2; ++i) {
        const int y = row * kSide - 1 + i;
        for (int j = 0; j < squares * kSide + 2; ++j) {
            const int x = column * kSide - 1 + j;
            const bool inside = y >= 0 && y < layer.height && x >= 0 && x < layer.width;
            for (int s = 0; s < layer.sourceCount(); ++s) {
                const FeaturePlane& plane = layer.sources[s];
                const auto channels = static_cast<std::size_t>(channelsOf(weights, s));
                const int shift = s == 0 && weights.upsampled ? 1 : 0;
                if (inside) {
                    std::memcpy(rows,
                                plane.row(y >> shift) + static_cast<std::size_t>(x >> shift) *
                                                            static_cast<std::size_t>(plane.stride),
                                channels * sizeof(float));
                } else {
                    std::memset(rows, 0, channels * sizeof(float));
                }
                rows += channels;
            }
        }
    }
}

void convolveDirectly(const Convolution& layer, int row, int column, int squares, float* scratch) {
    const ConvolutionWeights& weights = *layer.weights;
    const auto inputs = static_cast<std::size_t>(weights.inputs);
    const auto outputs = static_cast<std::size_t>(paddedChannels(weights.outputs));
    const int pixels = squares * kSide;
    const std::size_t rowFloats = static_cast<std::size_t>(pixels + 2) * inputs;
    float* const sums = scratch + (kSide + 2) * static_cast<std::size_t>(kBlockSquares * kSide + 2) * inputs +
                        kMaxRows * inputs;
    joinRows(layer, row, column, squares, scratch);
    const int all = (weights.outputs + static_cast<int>(kLanes) - 1) / static_cast<int>(kLanes);
    for (int first = 0; first < all;) {
        const int vectors = vectorsAtOnce(all - first);
        const int channel = first * static_cast<int>(kLanes);
        const std::size_t sumRow = static_cast<std::size_t>(writtenRows(pixels, vectors)) * kSumStride;
        for (int y = 0; y < kSide; ++y) {
            // Three pixels beside each other are one row of 3 x inputs.
            Terms terms[3];
            for (std::size_t tap = 0; tap < 3; ++tap)
                terms[tap] = {scratch + (static_cast<std::size_t>(y) + tap) * rowFloats,
                              weights.taps.data() + tap * 3 * inputs * outputs +
                                  static_cast<std::size_t>(channel),
                              3 * weights.inputs, inputs};
            sumProducts(terms, pixels, vectors, outputs, sums + static_cast<std::size_t>(y) * sumRow,
                        kSumStride);
        }
        for (int s = 0; s < squares; ++s) {
            for (int v = 0; v < vectors; ++v) {
                Float square[kSquarePixels];
                for (int i = 0; i < kSquarePixels; ++i)
                    square[i] = load(sums + static_cast<std::size_t>(i / kSide) * sumRow +
                                     static_cast<std::size_t>(s * kSide + i % kSide) * kSumStride +
                                     static_cast<std::size_t>(v) * kLanes);
                writeSquare(layer, row, column + s, channel + v * static_cast<int>(kLanes), square);
            }
        }
        first += vectors;
    }
}

void convolveBlock(const Convolution& layer, int row, int column, int squares, float* scratch) {
    if (layer.weights->direct) return convolveDirectly(layer, row, column, squares, scratch);
    convolveByPoints(layer, row, column, squares, scratch);
}

} // namespace HWY_NAMESPACE
} // namespace rtcore
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace rtcore {

HWY_EXPORT(convolveBlock);

void convolve(const Convolution& layer, int row, int column, int squares, float* scratch) {
    HWY_DYNAMIC_DISPATCH(convolveBlock)(layer, row, column, squares, scratch);
}

std::size_t convolutionScratch(const ConvolutionWeights& weights) {
    const auto inputs = static_cast<std::size_t>(weights.inputs);
    if (weights.direct) {
        constexpr std::size_t kPixels = kBlockSquares * kSide;
        return (kSide + 2) * (kPixels + 2) * inputs + kMaxRows * inputs +
               kSide * (kPixels + kMaxRows) * kSumStride;
    }
    return kPointsOfSquare * (pointStride(weights.firstInputs) + pointStride(channelsOf(weights, 1))) +
           kPointsOfSquare * kSumPlane + 36 * static_cast<std::size_t>(kMaxChannels);
}

} // namespace rtcore
#endif
