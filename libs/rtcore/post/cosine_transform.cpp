#include "rtcore/post/cosine_transform.h"

#include "rtcore/simd/portable_math.h"

#include <algorithm>
#include <utility>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "rtcore/post/cosine_transform.cpp"
#include "rtcore/simd/foreach_target.h"

#include "rtcore/post/complex_floats-inl.h"

#ifndef RTCORE_POST_COSINE_TRANSFORM_TYPES
#define RTCORE_POST_COSINE_TRANSFORM_TYPES
namespace rtcore {

inline constexpr std::size_t kLargestFactor = 13;

struct ConstLines {
    const float *re, *im;
};
struct Lines {
    float *re, *im;
};

/// One step of Stockham's transform: `parts` = product of the factors before it.
struct FftStage {
    std::size_t length, factor, parts;
    const CosineTransform::Root* roots; ///< of `length`
};

} // namespace rtcore
#endif

HWY_BEFORE_NAMESPACE();
namespace rtcore {
namespace HWY_NAMESPACE {

HWY_INLINE ComplexFloats splat(CosineTransform::Root r) { return {r.re, r.im}; }
/// -i a
HWY_INLINE ComplexFloats turnedRight(ComplexFloats a) { return {a.im, -a.re}; }

HWY_INLINE ComplexFloats loadComplex(ConstLines from, std::size_t at) {
    return {load(from.re + at), load(from.im + at)};
}
HWY_INLINE void storeComplex(ComplexFloats a, Lines to, std::size_t at) {
    store(a.re, to.re + at);
    store(a.im, to.im + at);
}

/// The transform of `factor` values, from `in` to `out`.
HWY_INLINE void butterfly(const FftStage& stage, const ComplexFloats* in, ComplexFloats* out) {
    if (stage.factor == 2) {
        out[0] = in[0] + in[1];
        out[1] = in[0] - in[1];
        return;
    }
    if (stage.factor == 4) {
        const ComplexFloats even = in[0] + in[2], odd = in[1] + in[3];
        const ComplexFloats evenLess = in[0] - in[2], oddLess = turnedRight(in[1] - in[3]);
        out[0] = even + odd;
        out[1] = evenLess + oddLess;
        out[2] = even - odd;
        out[3] = evenLess - oddLess;
        return;
    }
    const std::size_t step = stage.length / stage.factor;
    for (std::size_t k = 0; k < stage.factor; ++k) {
        out[k] = in[0];
        for (std::size_t j = 1; j < stage.factor; ++j) {
            out[k] = out[k] + splat(stage.roots[j * k % stage.factor * step]) * in[j];
        }
    }
}

/// With l = parts, r = factor, m = length / (l r): out[j + (i + k l) m] from in[j + (i r + p) m], where i < l
/// runs over the transforms that are done and j < m over those that are left.
void runStage(const FftStage& stage, ConstLines from, Lines to) {
    const std::size_t r = stage.factor, left = stage.length / (stage.parts * r);
    ComplexFloats in[kLargestFactor], out[kLargestFactor];
    for (std::size_t i = 0; i < stage.parts; ++i) {
        for (std::size_t j = 0; j < left; ++j) {
            for (std::size_t line = 0; line < kTransformLines; line += lanes()) {
                for (std::size_t p = 0; p < r; ++p) {
                    in[p] = loadComplex(from, ((i * r + p) * left + j) * kTransformLines + line);
                    // twiddle: e^(-2 pi i (p i) / (l r))
                    if (p > 0 && i > 0) in[p] = splat(stage.roots[p * i * left]) * in[p];
                }
                butterfly(stage, in, out);
                for (std::size_t k = 0; k < r; ++k) {
                    storeComplex(out[k], to, ((i + k * stage.parts) * left + j) * kTransformLines + line);
                }
            }
        }
    }
}

/// a[i] *= roots[i], for each line.
void multiplyBy(const CosineTransform::Root* roots, std::size_t count, Lines a) {
    for (std::size_t i = 0; i < count; ++i) {
        const ComplexFloats root = splat(roots[i]);
        for (std::size_t line = 0; line < kTransformLines; line += lanes()) {
            const std::size_t at = i * kTransformLines + line;
            storeComplex(root * loadComplex({a.re, a.im}, at), a, at);
        }
    }
}

/// X[k] = (w V[k] + conj(w) V[N - k]) / 2, w = turns[k], V[N] = V[0].
void turnForward(const CosineTransform::Root* turns, std::size_t n, ConstLines from, Lines to) {
    for (std::size_t k = 0; k < n; ++k) {
        const ComplexFloats turn = splat(turns[k]), back = splat({turns[k].re, -turns[k].im});
        const std::size_t other = k == 0 ? 0 : n - k;
        for (std::size_t line = 0; line < kTransformLines; line += lanes()) {
            const ComplexFloats sum = turn * loadComplex(from, k * kTransformLines + line) +
                                      back * loadComplex(from, other * kTransformLines + line);
            storeComplex({0.5F * sum.re, 0.5F * sum.im}, to, k * kTransformLines + line);
        }
    }
}

/// The inverse of that, conjugated as the inverse transform wants it: conj(conj(w) (X[k] - i X[N - k])),
/// X[N] = 0, with the scale 1 / N.
void turnBackward(const CosineTransform::Root* turns, std::size_t n, ConstLines from, Lines to) {
    const Float scale = 1 / static_cast<float>(n);
    for (std::size_t k = 0; k < n; ++k) {
        const ComplexFloats back = splat({turns[k].re, -turns[k].im});
        for (std::size_t line = 0; line < kTransformLines; line += lanes()) {
            ComplexFloats x = loadComplex(from, k * kTransformLines + line);
            if (k > 0) x = x + turnedRight(loadComplex(from, (n - k) * kTransformLines + line));
            const ComplexFloats v = back * x;
            storeComplex({scale * v.re, -(scale * v.im)}, to, k * kTransformLines + line);
        }
    }
}

} // namespace HWY_NAMESPACE
} // namespace rtcore
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace rtcore {

HWY_EXPORT(runStage);
HWY_EXPORT(multiplyBy);
HWY_EXPORT(turnForward);
HWY_EXPORT(turnBackward);

namespace {

using Root = CosineTransform::Root;

/// e^(-2 pi i k / n), k < n, from angles of at most pi / 4.
Root rootOf(std::size_t k, std::size_t n) {
    constexpr double kTwoPi = 6.28318530717958647692;
    const std::size_t eighth = 8 * k / n; // which octant
    const std::size_t quarter = (eighth + 1) / 2;
    // k / n - quarter / 4, exact until the division
    const double rest = (4 * static_cast<double>(k) - static_cast<double>(quarter) * static_cast<double>(n)) /
                        (4 * static_cast<double>(n));
    const auto angle = static_cast<float>(kTwoPi * rest);
    const float c = portableCos(angle), s = portableSin(angle);
    switch (quarter % 4) {
    case 0:
        return {c, -s};
    case 1:
        return {-s, -c};
    case 2:
        return {-c, s};
    default:
        return {s, c};
    }
}

Lines linesOf(std::vector<float>& re, std::vector<float>& im) { return {re.data(), im.data()}; }

} // namespace

bool CosineTransform::isSmooth(std::size_t length) {
    for (std::size_t factor = 2; factor <= kLargestFactor; ++factor) {
        while (length % factor == 0) length /= factor;
    }
    return length == 1;
}

CosineTransform::Plan CosineTransform::planFor(std::size_t length) {
    Plan plan;
    plan.length = length;
    std::size_t left = length;
    for (const std::size_t factor : {4U, 2U, 3U, 5U, 7U, 11U, 13U}) {
        for (; left % factor == 0; left /= factor) plan.factors.push_back(factor);
    }
    for (std::size_t k = 0; k < length; ++k) plan.roots.push_back(rootOf(k, length));
    return plan;
}

CosineTransform::CosineTransform(std::size_t length) : length_(length) {
    for (std::size_t k = 0; k < length; ++k) turns_.push_back(rootOf(k, 4 * length));
    if (isSmooth(length)) {
        plan_ = planFor(length);
        return;
    }
    std::size_t longer = 2 * length - 1;
    const auto quick = [](std::size_t n) {
        for (const std::size_t factor : {2U, 3U, 5U}) {
            while (n % factor == 0) n /= factor;
        }
        return n == 1;
    };
    while (!quick(longer)) ++longer;
    plan_ = planFor(longer);
    for (std::size_t k = 0; k < length; ++k) chirp_.push_back(rootOf(k * k % (2 * length), 2 * length));
    TransformScratch scratch;
    for (std::vector<float>* const values : {&scratch.re, &scratch.im, &scratch.otherRe, &scratch.otherIm}) {
        values->assign(longer * kTransformLines, 0);
    }
    for (std::size_t k = 0; k < length; ++k) { // in the first line: conj(chirp), to both sides
        for (const std::size_t at : {k, (longer - k) % longer}) {
            scratch.re[at * kTransformLines] = chirp_[k].re;
            scratch.im[at * kTransformLines] = -chirp_[k].im;
        }
    }
    transform(plan_, scratch.re, scratch.im, scratch.otherRe, scratch.otherIm);
    const float scale = 1 / static_cast<float>(longer);
    for (std::size_t k = 0; k < longer; ++k) {
        chirpTransform_.push_back(
            {scratch.re[k * kTransformLines] * scale, scratch.im[k * kTransformLines] * scale});
    }
}

void CosineTransform::prepare(TransformScratch& scratch) const {
    const std::size_t count = length_ * kTransformLines, max = plan_.length * kTransformLines;
    scratch.re.resize(count);
    scratch.im.resize(count);
    scratch.otherRe.resize(max);
    scratch.otherIm.resize(max);
    if (chirp_.empty()) return;
    scratch.longRe.resize(max);
    scratch.longIm.resize(max);
}

void CosineTransform::transform(const Plan& plan, std::vector<float>& re, std::vector<float>& im,
                                std::vector<float>& otherRe, std::vector<float>& otherIm) {
    std::size_t parts = 1;
    for (const std::size_t factor : plan.factors) {
        HWY_DYNAMIC_DISPATCH(runStage)
        ({plan.length, factor, parts, plan.roots.data()}, {re.data(), im.data()}, linesOf(otherRe, otherIm));
        re.swap(otherRe);
        im.swap(otherIm);
        parts *= factor;
    }
}

/// In place of re and im.
void CosineTransform::transform(TransformScratch& s) const {
    if (chirp_.empty()) {
        transform(plan_, s.re, s.im, s.otherRe, s.otherIm);
    } else {
        convolve(s);
    }
}

void CosineTransform::convolve(TransformScratch& s) const {
    const std::size_t count = length_ * kTransformLines;
    HWY_DYNAMIC_DISPATCH(multiplyBy)(chirp_.data(), length_, linesOf(s.re, s.im));
    std::fill(std::copy_n(s.re.begin(), count, s.longRe.begin()), s.longRe.end(), 0.0F);
    std::fill(std::copy_n(s.im.begin(), count, s.longIm.begin()), s.longIm.end(), 0.0F);
    transform(plan_, s.longRe, s.longIm, s.otherRe, s.otherIm);
    HWY_DYNAMIC_DISPATCH(multiplyBy)(chirpTransform_.data(), plan_.length, linesOf(s.longRe, s.longIm));
    // The inverse is the transform of the conjugate, conjugated.
    for (float& x : s.longIm) x = -x;
    transform(plan_, s.longRe, s.longIm, s.otherRe, s.otherIm);
    std::copy_n(s.longRe.begin(), count, s.re.begin());
    for (std::size_t i = 0; i < count; ++i) s.im[i] = -s.longIm[i];
    HWY_DYNAMIC_DISPATCH(multiplyBy)(chirp_.data(), length_, linesOf(s.re, s.im));
}

void CosineTransform::forward(TransformScratch& s) const {
    // Even places forwards, then odd ones backwards.
    for (std::size_t i = 0; i < length_; ++i) {
        const std::size_t from = 2 * i < length_ ? 2 * i : 2 * (length_ - i) - 1;
        std::copy_n(&s.re[from * kTransformLines], kTransformLines, &s.otherRe[i * kTransformLines]);
        std::copy_n(&s.im[from * kTransformLines], kTransformLines, &s.otherIm[i * kTransformLines]);
    }
    std::copy_n(s.otherRe.begin(), length_ * kTransformLines, s.re.begin());
    std::copy_n(s.otherIm.begin(), length_ * kTransformLines, s.im.begin());
    transform(s);
    HWY_DYNAMIC_DISPATCH(turnForward)
    (turns_.data(), length_, {s.re.data(), s.im.data()}, linesOf(s.otherRe, s.otherIm));
    std::copy_n(s.otherRe.begin(), length_ * kTransformLines, s.re.begin());
    std::copy_n(s.otherIm.begin(), length_ * kTransformLines, s.im.begin());
}

void CosineTransform::inverse(TransformScratch& s) const {
    HWY_DYNAMIC_DISPATCH(turnBackward)
    (turns_.data(), length_, {s.re.data(), s.im.data()}, linesOf(s.otherRe, s.otherIm));
    std::copy_n(s.otherRe.begin(), length_ * kTransformLines, s.re.begin());
    std::copy_n(s.otherIm.begin(), length_ * kTransformLines, s.im.begin());
    transform(s);
    for (std::size_t i = 0; i < length_; ++i) {
        const std::size_t to = 2 * i < length_ ? 2 * i : 2 * (length_ - i) - 1;
        std::copy_n(&s.re[i * kTransformLines], kTransformLines, &s.otherRe[to * kTransformLines]);
        for (std::size_t line = 0; line < kTransformLines; ++line) {
            s.otherIm[to * kTransformLines + line] = -s.im[i * kTransformLines + line];
        }
    }
    std::copy_n(s.otherRe.begin(), length_ * kTransformLines, s.re.begin());
    std::copy_n(s.otherIm.begin(), length_ * kTransformLines, s.im.begin());
}

} // namespace rtcore
#endif
