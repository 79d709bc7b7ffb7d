#include "rtcore/post/gaussian_blur.h"

#include "rtcore/platform/threads.h"
#include "rtcore/post/sanitize.h"
#include "rtcore/simd/portable_math.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "rtcore/post/gaussian_blur.cpp"
#include "rtcore/simd/foreach_target.h"

#include "rtcore/post/complex_floats-inl.h"

#ifndef RTCORE_POST_GAUSSIAN_BLUR_TYPES
#define RTCORE_POST_GAUSSIAN_BLUR_TYPES
namespace rtcore {

/// Lines that are filtered side by side.
inline constexpr std::size_t kLines = 16;

struct ComplexFloat {
    float re = 0, im = 0;
};

/// Half of the filter is the real part of the sum over both terms of factor * pole^i, i pixels away.
struct RecursiveTerm {
    ComplexFloat pole, factor;
    ComplexFloat toEnd;      ///< pole^length, 0 where it does not matter
    ComplexFloat mirrorGain; ///< 1 / (1 - pole^(2 length)): the mirrored image repeats
};

struct RecursiveFilter {
    RecursiveTerm terms[2];
    float gain = 1;          ///< makes the sum of the whole filter 1
    std::size_t length = 0;  ///< of the lines
    std::size_t reach = 0;   ///< pixels from an end that matter beyond it; at most `length`
    bool shortLines = false; ///< they end within the filter's reach
};

} // namespace rtcore
#endif

HWY_BEFORE_NAMESPACE();
namespace rtcore {
namespace HWY_NAMESPACE {

HWY_INLINE ComplexFloats splat(ComplexFloat c) { return {c.re, c.im}; }
HWY_INLINE Float realOfProduct(ComplexFloats a, ComplexFloats b) { return a.re * b.re - a.im * b.im; }
/// pole * state + x
HWY_INLINE ComplexFloats advanced(ComplexFloats pole, ComplexFloats state, Float x) {
    const ComplexFloats next = pole * state;
    return {next.re + x, next.im};
}

/// values[line + kLines * i] -> filtered[...], for as many lines as a vector has lanes.
HWY_INLINE void filterVector(const RecursiveFilter& filter, const float* HWY_RESTRICT values,
                             float* HWY_RESTRICT filtered) {
    const std::size_t n = filter.length;
    const ComplexFloats pole0 = splat(filter.terms[0].pole), pole1 = splat(filter.terms[1].pole);
    const ComplexFloats factor0 = splat(filter.terms[0].factor), factor1 = splat(filter.terms[1].factor);
    const ComplexFloats toEnd0 = splat(filter.terms[0].toEnd), toEnd1 = splat(filter.terms[1].toEnd);
    const ComplexFloats gain0 = splat(filter.terms[0].mirrorGain);
    const ComplexFloats gain1 = splat(filter.terms[1].mirrorGain);
    const ComplexFloats none{0.0F, 0.0F};

    // The state that the mirrored image before the first pixel leaves.
    ComplexFloats state0 = none, state1 = none;
    for (std::size_t i = filter.reach; i-- > 0;) {
        const Float x = load(values + i * kLines);
        state0 = advanced(pole0, state0, x);
        state1 = advanced(pole1, state1, x);
    }
    if (filter.shortLines) {
        ComplexFloats end0 = none, end1 = none;
        for (std::size_t i = 0; i < n; ++i) {
            const Float x = load(values + i * kLines);
            end0 = advanced(pole0, end0, x);
            end1 = advanced(pole1, end1, x);
        }
        state0 = (state0 + toEnd0 * end0) * gain0;
        state1 = (state1 + toEnd1 * end1) * gain1;
    }

    for (std::size_t i = 0; i < n; ++i) {
        const Float x = load(values + i * kLines);
        state0 = advanced(pole0, state0, x);
        state1 = advanced(pole1, state1, x);
        store(realOfProduct(factor0, state0) + realOfProduct(factor1, state1), filtered + i * kLines);
    }

    // The mirrored image behind the last pixel begins with that pixel: it leaves what all before it left.
    const Float gain = filter.gain;
    for (std::size_t i = n; i-- > 0;) {
        const Float x = load(values + i * kLines);
        state0 = pole0 * state0;
        state1 = pole1 * state1;
        const Float behind = realOfProduct(factor0, state0) + realOfProduct(factor1, state1);
        const Float before = load(filtered + i * kLines);
        store(gain * (before + behind), filtered + i * kLines);
        state0 = {state0.re + x, state0.im};
        state1 = {state1.re + x, state1.im};
    }
}

void filterLines(const RecursiveFilter& filter, const float* HWY_RESTRICT values,
                 float* HWY_RESTRICT filtered) {
    for (std::size_t line = 0; line < kLines; line += lanes()) {
        filterVector(filter, values + line, filtered + line);
    }
}

} // namespace HWY_NAMESPACE
} // namespace rtcore
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace rtcore {

HWY_EXPORT(filterLines);

namespace {

using Complex = std::complex<double>;

constexpr std::size_t kPixelsAcross = kLines / 3; ///< rows that are filtered side by side

/// Spelled out: the operator of std::complex asks for infinities.
Complex times(Complex a, Complex b) {
    return {a.real() * b.real() - a.imag() * b.imag(), a.real() * b.imag() + a.imag() * b.real()};
}
Complex inverse(Complex a) {
    const double square = a.real() * a.real() + a.imag() * a.imag();
    return {a.real() / square, -a.imag() / square};
}
Complex power(Complex base, std::size_t exponent) {
    Complex result = 1;
    for (; exponent > 0; exponent >>= 1) {
        if ((exponent & 1) != 0) result = times(result, base);
        base = times(base, base);
    }
    return result;
}
ComplexFloat rounded(Complex a) { return {static_cast<float>(a.real()), static_cast<float>(a.imag())}; }
Complex exact(ComplexFloat a) { return {a.re, a.im}; }

RecursiveFilter filterFor(float sigma, std::size_t length) {
    constexpr double kNothing = 1e-8; // of the light
    constexpr struct {
        float decay, frequency, cosine, sine;
    } kTerms[2] = {{1.783F, 0.6318F, 1.68F, 3.735F}, {1.723F, 1.997F, -0.6803F, -0.2598F}};
    RecursiveFilter filter;
    filter.length = length;
    filter.reach = std::min(length, static_cast<std::size_t>(11 * sigma) + 1); // e^(-1.723 * 11) < kNothing
    double sum = 0;
    for (int i = 0; i < 2; ++i) {
        RecursiveTerm& term = filter.terms[i];
        const float size = portableExp(-kTerms[i].decay / sigma), angle = kTerms[i].frequency / sigma;
        term.pole = {size * portableCos(angle), size * portableSin(angle)};
        term.factor = {kTerms[i].cosine, -kTerms[i].sine};
        const Complex pole = exact(term.pole);
        const Complex both = times(1.0 + pole, inverse(1.0 - pole));
        sum += times(exact(term.factor), both).real();
        const Complex toEnd = power(pole, length);
        filter.shortLines = filter.shortLines || std::norm(toEnd) > kNothing * kNothing;
        term.toEnd = rounded(toEnd);
        term.mirrorGain = rounded(inverse(1.0 - times(toEnd, toEnd)));
    }
    filter.gain = static_cast<float>(1 / sum);
    return filter;
}

/// Rows of pixels as lines of floats, each channel one.
void loadRows(const HdrImage& image, int first, int rows, float* lines) {
    for (int row = 0; row < rows; ++row) {
        const Colour* const pixels = &image.at(0, first + row);
        float* to = lines + 3 * row;
        for (int x = 0; x < image.width; ++x, to += kLines) {
            to[0] = sanitizeRadiance(pixels[x].r);
            to[1] = sanitizeRadiance(pixels[x].g);
            to[2] = sanitizeRadiance(pixels[x].b);
        }
    }
}

void storeRows(const float* lines, int first, int rows, HdrImage& image) {
    for (int row = 0; row < rows; ++row) {
        Colour* const pixels = &image.at(0, first + row);
        const float* from = lines + 3 * row;
        for (int x = 0; x < image.width; ++x, from += kLines) pixels[x] = {from[0], from[1], from[2]};
    }
}

} // namespace

void GaussianBlur::blur(const HdrImage& image, float sigma, float fraction, int threads, HdrImage& result) {
    const auto width = static_cast<std::size_t>(image.width), height = static_cast<std::size_t>(image.height);
    if (result.width != image.width || result.height != image.height) {
        result = HdrImage(image.width, image.height);
    }
    if (image.empty()) return;
    const int team = threadsFor(threads);
    if (lines_.size() < static_cast<std::size_t>(team)) lines_.resize(static_cast<std::size_t>(team));
    for (Lines& lines : lines_) {
        lines.values.resize(kLines * std::max(width, height));
        lines.filtered.resize(lines.values.size());
    }

    const RecursiveFilter across = filterFor(sigma, width);
    constexpr int kRows = static_cast<int>(kPixelsAcross);
#pragma omp parallel for schedule(static) num_threads(team)
    for (int first = 0; first < image.height; first += kRows) {
        Lines& lines = lines_[static_cast<std::size_t>(threadNumber())];
        const int rows = std::min(kRows, image.height - first);
        loadRows(image, first, rows, lines.values.data());
        HWY_DYNAMIC_DISPATCH(filterLines)(across, lines.values.data(), lines.filtered.data());
        storeRows(lines.filtered.data(), first, rows, result);
    }

    const RecursiveFilter down = filterFor(sigma, height);
    float* const floats = &result.pixels[0].r;
    const float* const sources = &image.pixels[0].r;
    const std::size_t stride = 3 * width;
    const auto blocks = static_cast<int>((stride + kLines - 1) / kLines);
#pragma omp parallel for schedule(static) num_threads(team)
    for (int block = 0; block < blocks; ++block) {
        Lines& lines = lines_[static_cast<std::size_t>(threadNumber())];
        const std::size_t first = static_cast<std::size_t>(block) * kLines;
        const std::size_t count = std::min(kLines, stride - first);
        for (std::size_t y = 0; y < height; ++y) {
            std::copy_n(floats + y * stride + first, count, &lines.values[y * kLines]);
        }
        HWY_DYNAMIC_DISPATCH(filterLines)(down, lines.values.data(), lines.filtered.data());
        for (std::size_t y = 0; y < height; ++y) {
            const float* const from = &lines.filtered[y * kLines];
            const float* const source = sources + y * stride + first;
            float* const to = floats + y * stride + first;
            for (std::size_t i = 0; i < count; ++i) to[i] = mixedWith(source[i], from[i], fraction);
        }
    }
}

} // namespace rtcore
#endif
