// Products of small matrices in registers, each sum in the order of its terms. Included once for each
// instruction set, inside the loop of foreach_target.h.
#include "rtcore/simd/wide-inl.h"

#include <cstddef>
#include <span>

#if defined(RTCORE_NEURAL_PRODUCTS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef RTCORE_NEURAL_PRODUCTS_INL_H_
#undef RTCORE_NEURAL_PRODUCTS_INL_H_
#else
#define RTCORE_NEURAL_PRODUCTS_INL_H_
#endif

HWY_BEFORE_NAMESPACE();
namespace rtcore {
namespace HWY_NAMESPACE {

/// Terms of sums: sum over k of values[row * rowStride + k] * weights[k * weightStride + column].
struct Terms {
    const float* values;
    const float* weights;
    int count;
    std::size_t rowStride;
};

/// Sums of so many rows and vectors of columns at once. AVX-512 and NEON have 32 registers.
inline constexpr bool kManyRegisters = kLanes == 16 || HWY_ARCH_ARM != 0;
inline constexpr int kMaxColumnVectors = kManyRegisters ? 4 : 2;
constexpr int rowsAtOnce(int columnVectors) {
    if (!kManyRegisters) return 6;
    return columnVectors == 4 ? 6 : columnVectors == 3 ? 8 : 12;
}
/// The rows that are written for `rows`.
constexpr int writtenRows(int rows, int columnVectors) {
    const int step = rowsAtOnce(columnVectors);
    return (rows + step - 1) / step * step;
}

/// kRows x kVectors vectors of sums into `sums`, over the terms in their order.
template <int kRows, int kVectors>
HWY_NOINLINE void sumTerms(std::span<const Terms> all, std::size_t firstRow, std::size_t weightStride,
                           float* sums, std::size_t sumStride) {
    Float sum[kRows][kVectors];
#pragma GCC unroll 16
    for (int r = 0; r < kRows; ++r)
#pragma GCC unroll 4
        for (int c = 0; c < kVectors; ++c) sum[r][c] = Float(0);
    for (const Terms& terms : all) {
        const float* values = terms.values + firstRow * terms.rowStride;
        const float* weights = terms.weights;
        for (int k = 0; k < terms.count; ++k, ++values, weights += weightStride) {
            Float w[kVectors];
#pragma GCC unroll 4
            for (int c = 0; c < kVectors; ++c) w[c] = load(weights + static_cast<std::size_t>(c) * kLanes);
#pragma GCC unroll 16
            for (int r = 0; r < kRows; ++r) {
                const Float value = values[static_cast<std::size_t>(r) * terms.rowStride];
#pragma GCC unroll 4
                for (int c = 0; c < kVectors; ++c) sum[r][c] = sum[r][c] + value * w[c];
            }
        }
    }
#pragma GCC unroll 16
    for (int r = 0; r < kRows; ++r)
#pragma GCC unroll 4
        for (int c = 0; c < kVectors; ++c)
            store(sum[r][c],
                  sums + static_cast<std::size_t>(r) * sumStride + static_cast<std::size_t>(c) * kLanes);
}

template <int kVectors>
HWY_INLINE void sumRows(std::span<const Terms> all, int rows, std::size_t weightStride, float* sums,
                        std::size_t sumStride) {
    constexpr int kRows = rowsAtOnce(kVectors);
    for (int r = 0; r < rows; r += kRows) {
        const auto first = static_cast<std::size_t>(r);
        sumTerms<kRows, kVectors>(all, first, weightStride, sums + first * sumStride, sumStride);
    }
}

/// The sums of all terms for `rows` rows, or writtenRows() of them: there has to be room, and values to be
/// read. `vectors`: of columns, at most kMaxColumnVectors.
HWY_INLINE void sumProducts(std::span<const Terms> all, int rows, int vectors, std::size_t weightStride,
                            float* sums, std::size_t sumStride) {
    if constexpr (kManyRegisters) {
        if (vectors == 4) return sumRows<4>(all, rows, weightStride, sums, sumStride);
        if (vectors == 3) return sumRows<3>(all, rows, weightStride, sums, sumStride);
    }
    if (vectors == 2) return sumRows<2>(all, rows, weightStride, sums, sumStride);
    sumRows<1>(all, rows, weightStride, sums, sumStride);
}

/// The vectors of columns that come next, of those that are left.
constexpr int vectorsAtOnce(int left) {
    if (!kManyRegisters) return left >= 2 ? 2 : 1;
    if (left <= 4) return left;
    return left == 5 || left == 6 ? 3 : 4;
}

} // namespace HWY_NAMESPACE
} // namespace rtcore
HWY_AFTER_NAMESPACE();

#endif
