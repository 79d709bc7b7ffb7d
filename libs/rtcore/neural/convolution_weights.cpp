#include "rtcore/neural/convolution.h"

#include <algorithm>
#include <utility>

namespace rtcore {

namespace {

constexpr int kPoints = 6;
/// G of Winograd's F(4 x 4, 3 x 3) with the points 0, 1, -1, 2, -2 and infinity (Lavin and Gray 2016).
constexpr double kFilterPoints[kPoints][3] = {{1.0 / 4, 0, 0},
                                              {-1.0 / 6, -1.0 / 6, -1.0 / 6},
                                              {-1.0 / 6, 1.0 / 6, -1.0 / 6},
                                              {1.0 / 24, 1.0 / 12, 1.0 / 6},
                                              {1.0 / 24, -1.0 / 12, 1.0 / 6},
                                              {0, 0, 1}};
/// In each axis of an upsampled source this point is zero.
constexpr int kZeroPoint = 2;

/// G g G^T of the 3 x 3 weights from one input to one output.
double filterAt(const float* taps, int row, int column) {
    double sum = 0;
    for (int y = 0; y < 3; ++y) {
        double ofRow = 0;
        for (int x = 0; x < 3; ++x) ofRow += kFilterPoints[column][x] * static_cast<double>(taps[3 * y + x]);
        sum += kFilterPoints[row][y] * ofRow;
    }
    return sum;
}

/// The points of a source whose channels are the inputs from `first` to before `last`.
std::vector<float> pointsOf(const ConvolutionWeights& weights, const std::vector<float>& oihw,
                            std::pair<int, int> range, bool upsampled) {
    const int outputs = paddedChannels(weights.outputs);
    std::vector<float> points;
    for (int row = 0; row < kPoints; ++row) {
        for (int column = 0; column < kPoints; ++column) {
            if (upsampled && (row == kZeroPoint || column == kZeroPoint)) continue;
            for (int input = range.first; input < range.second; ++input) {
                for (int output = 0; output < outputs; ++output) {
                    const auto at = static_cast<std::size_t>((output * weights.inputs + input) * 9);
                    const bool there = output < weights.outputs;
                    points.push_back(there ? static_cast<float>(filterAt(&oihw[at], row, column)) : 0.0F);
                }
            }
        }
    }
    return points;
}

std::vector<float> tapsOf(const ConvolutionWeights& weights, const std::vector<float>& oihw) {
    const int outputs = paddedChannels(weights.outputs);
    std::vector<float> taps;
    for (int tap = 0; tap < 9; ++tap) {
        for (int input = 0; input < weights.inputs; ++input) {
            for (int output = 0; output < outputs; ++output) {
                const auto at = static_cast<std::size_t>((output * weights.inputs + input) * 9 + tap);
                taps.push_back(output < weights.outputs ? oihw[at] : 0.0F);
            }
        }
    }
    return taps;
}

} // namespace

void arrangeWeights(ConvolutionWeights& weights, const std::vector<float>& oihw,
                    const std::vector<float>& bias) {
    weights.bias = bias;
    weights.bias.resize(static_cast<std::size_t>(paddedChannels(weights.outputs)), 0.0F);
    if (weights.direct) {
        weights.taps = tapsOf(weights, oihw);
        return;
    }
    weights.points[0] = pointsOf(weights, oihw, {0, weights.firstInputs}, weights.upsampled);
    weights.points[1] = pointsOf(weights, oihw, {weights.firstInputs, weights.inputs}, false);
}

} // namespace rtcore
