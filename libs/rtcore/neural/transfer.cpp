#include "rtcore/neural/transfer.h"

#include "rtcore/platform/threads.h"
#include "rtcore/simd/portable_math.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <vector>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "rtcore/neural/transfer.cpp"
#include "rtcore/simd/foreach_target.h"

#include "rtcore/simd/functions-inl.h"

#ifndef RTCORE_NEURAL_TRANSFER_TYPES
#define RTCORE_NEURAL_TRANSFER_TYPES
namespace rtcore {
namespace {

constexpr float kMaxCoded = 65504; ///< the largest half
// The curve: a y up to kLinearEnd, b y^c + d up to kPowerEnd, then e ln(y + f) + g.
constexpr float kA = 1.41283765e+03F, kB = 1.64593172e+00F, kC = 4.31384981e-01F, kD = -2.94139609e-03F,
                kE = 1.92653254e-01F, kF = 6.26026094e-03F, kG = 9.98620152e-01F;
constexpr float kLinearEnd = 1.57945760e-06F, kPowerEnd = 3.22087631e-02F;
constexpr float kLinearEndCoded = 2.23151711e-03F, kPowerEndCoded = 3.70974749e-01F;
constexpr float kCodedOfMax = 3.13511904F; ///< of kMaxCoded
constexpr float kTiny = 1e-30F;            ///< for logarithms of what is not used

} // namespace
} // namespace rtcore
#endif

HWY_BEFORE_NAMESPACE();
namespace rtcore {
namespace HWY_NAMESPACE {

HWY_INLINE Float power(Float x, float exponent) { return fastExp(fastLog(max(x, kTiny)) * exponent); }

HWY_INLINE Float coded(Float y) {
    const Float low = kA * y, middle = kB * power(y, kC) + kD, high = kE * fastLog(y + kF) + kG;
    return select(y <= kLinearEnd, low, select(y <= kPowerEnd, middle, high));
}
HWY_INLINE Float decoded(Float x) {
    const Float low = x / kA, middle = power((x - kD) / kB, 1 / kC), high = fastExp((x - kG) / kE) - kF;
    return select(x <= kLinearEndCoded, low, select(x <= kPowerEndCoded, middle, high));
}
/// 0 of what is no number.
HWY_INLINE Float within(Float x, float max) { return min(selectOrZero(x > 0.0F, x), max); }

void encodeValues(const float* radiance, std::size_t count, float scale, float* to) {
    for (std::size_t i = 0; i < count; i += lanes())
        store(coded(within(load(radiance + i) * scale, kMaxCoded)) / kCodedOfMax, to + i);
}
void decodeValues(const float* from, std::size_t count, float scale, float* radiance) {
    for (std::size_t i = 0; i < count; i += lanes())
        store(decoded(within(load(from + i), 1) * kCodedOfMax) / scale, radiance + i);
}

} // namespace HWY_NAMESPACE
} // namespace rtcore
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace rtcore {

HWY_EXPORT(encodeValues);
HWY_EXPORT(decodeValues);

void encodeRadiance(const float* radiance, std::size_t count, float scale, float* coded) {
    HWY_DYNAMIC_DISPATCH(encodeValues)(radiance, count, scale, coded);
}
void decodeRadiance(const float* coded, std::size_t count, float scale, float* radiance) {
    HWY_DYNAMIC_DISPATCH(decodeValues)(coded, count, scale, radiance);
}

namespace {

double usable(float value) {
    if (!(value > 0)) return 0;
    return static_cast<double>(std::min(value, std::numeric_limits<float>::max()));
}

/// The mean luminance of the pixels of a block.
double meanLuminance(const PixelPlane& radiance, int width, int left, int right, int top, int bottom) {
    double sum = 0;
    for (int y = top; y < bottom; ++y) {
        const float* pixel = radiance.first + (static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                                               static_cast<std::size_t>(left)) *
                                                  radiance.step;
        for (int x = left; x < right; ++x, pixel += radiance.step)
            sum += 0.212671 * usable(pixel[0]) + 0.715160 * usable(pixel[1]) + 0.072169 * usable(pixel[2]);
    }
    return sum / (static_cast<double>(right - left) * static_cast<double>(bottom - top));
}

/// The index of the first pixel of block `i` of `count` over `size` pixels.
int blockBegin(int i, int count, int size) {
    return static_cast<int>(static_cast<std::int64_t>(i) * size / count);
}

} // namespace

float exposureForNet(const PixelPlane& radiance, int width, int height, [[maybe_unused]] int threads) {
    constexpr int kBlock = 16;
    constexpr double kNoLight = 1e-8;
    const int rows = (height + kBlock - 1) / kBlock, columns = (width + kBlock - 1) / kBlock;
    std::vector<double> means(static_cast<std::size_t>(rows) * static_cast<std::size_t>(columns));
#pragma omp parallel for schedule(static) num_threads(threadsFor(threads))
    for (int row = 0; row < rows; ++row) {
        for (int column = 0; column < columns; ++column)
            means[static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) +
                  static_cast<std::size_t>(column)] =
                meanLuminance(radiance, width, blockBegin(column, columns, width),
                              blockBegin(column + 1, columns, width), blockBegin(row, rows, height),
                              blockBegin(row + 1, rows, height));
    }
    double sum = 0, lit = 0;
    for (const double mean : means) {
        if (mean <= kNoLight) continue;
        sum += static_cast<double>(portableLog2(static_cast<float>(mean)));
        ++lit;
    }
    return lit > 0 ? 0.18F * portableExp2(static_cast<float>(-sum / lit)) : 1.0F;
}

} // namespace rtcore
#endif
