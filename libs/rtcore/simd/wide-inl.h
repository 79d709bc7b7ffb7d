// Numbers as wide as the processor's registers, with the operators of plain ones: what is written for float
// may be written for Float in the same words, and gives the same bits in each lane. Included once for each
// instruction set, inside the loop of foreach_target.h, or alone, for the instruction set that every
// processor has.
//
// NaN as in plain code: comparisons are false; min and max are those of std, the first where neither is
// smaller or greater. The same functions take float and bool, so that a template over its number works for
// both.
#include "rtcore/simd/compaction-inl.h"
#include "rtcore/simd/targets.h"

#include <hwy/highway.h>

#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <type_traits>

#if defined(RTCORE_SIMD_WIDE_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef RTCORE_SIMD_WIDE_INL_H_
#undef RTCORE_SIMD_WIDE_INL_H_
#else
#define RTCORE_SIMD_WIDE_INL_H_
#endif

HWY_BEFORE_NAMESPACE();
namespace rtcore {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// For which lanes something holds; `F`: float or double, whichever is as wide as the lanes.
template <typename F>
struct MaskT {
    hn::Mask<hn::ScalableTag<F>> raw;

    friend HWY_INLINE MaskT operator&(MaskT a, MaskT b) { return {hn::And(a.raw, b.raw)}; }
    friend HWY_INLINE MaskT operator|(MaskT a, MaskT b) { return {hn::Or(a.raw, b.raw)}; }
    friend HWY_INLINE MaskT operator^(MaskT a, MaskT b) { return {hn::Xor(a.raw, b.raw)}; }
    friend HWY_INLINE MaskT operator!(MaskT a) { return {hn::Not(a.raw)}; }
    /// a & !b, in one instruction.
    friend HWY_INLINE MaskT without(MaskT a, MaskT b) { return {hn::AndNot(b.raw, a.raw)}; }
    friend HWY_INLINE bool all(MaskT a) { return hn::AllTrue(hn::ScalableTag<F>(), a.raw); }
    friend HWY_INLINE bool none(MaskT a) { return hn::AllFalse(hn::ScalableTag<F>(), a.raw); }
    friend HWY_INLINE bool any(MaskT a) { return !none(a); }
    HWY_INLINE std::size_t count() const { return hn::CountTrue(hn::ScalableTag<F>(), raw); }
    /// The index of the first lane; there is one.
    HWY_INLINE std::size_t first() const {
        return static_cast<std::size_t>(hn::FindFirstTrue(hn::ScalableTag<F>(), raw));
    }
};

/// A vector of T: float, double, std::uint32_t or std::int32_t.
template <typename T>
struct Wide {
    using Tag = hn::ScalableTag<T>;
    using Mask = MaskT<std::conditional_t<sizeof(T) == 8, double, float>>;
    hn::Vec<Tag> raw;

#if HWY_ARCH_ARM
    /// Highway's vectors of NEON have a constructor that leaves them as they are, with empty braces too.
    HWY_INLINE Wide() : raw(hn::Zero(Tag())) {}
#else
    Wide() = default; ///< zero with empty braces
#endif
    HWY_INLINE Wide(hn::Vec<Tag> value) : raw(value) {}
    HWY_INLINE Wide(T value) : raw(hn::Set(Tag(), value)) {} ///< the same in all lanes

    friend HWY_INLINE Wide operator+(Wide a, Wide b) { return hn::Add(a.raw, b.raw); }
    friend HWY_INLINE Wide operator-(Wide a, Wide b) { return hn::Sub(a.raw, b.raw); }
    friend HWY_INLINE Wide operator*(Wide a, Wide b) { return hn::Mul(a.raw, b.raw); }
    friend HWY_INLINE Wide operator/(Wide a, Wide b) { return hn::Div(a.raw, b.raw); }
    friend HWY_INLINE Wide operator-(Wide a) { return hn::Neg(a.raw); }
    friend HWY_INLINE Wide operator&(Wide a, Wide b) { return hn::And(a.raw, b.raw); }
    friend HWY_INLINE Wide operator|(Wide a, Wide b) { return hn::Or(a.raw, b.raw); }
    friend HWY_INLINE Wide operator^(Wide a, Wide b) { return hn::Xor(a.raw, b.raw); }
    HWY_INLINE Wide& operator+=(Wide b) { return *this = *this + b; }
    HWY_INLINE Wide& operator*=(Wide b) { return *this = *this * b; }

    friend HWY_INLINE Mask operator<(Wide a, Wide b) { return maskOf(hn::Lt(a.raw, b.raw)); }
    friend HWY_INLINE Mask operator>(Wide a, Wide b) { return maskOf(hn::Gt(a.raw, b.raw)); }
    friend HWY_INLINE Mask operator<=(Wide a, Wide b) { return maskOf(hn::Le(a.raw, b.raw)); }
    friend HWY_INLINE Mask operator>=(Wide a, Wide b) { return maskOf(hn::Ge(a.raw, b.raw)); }
    friend HWY_INLINE Mask operator==(Wide a, Wide b) { return maskOf(hn::Eq(a.raw, b.raw)); }
    friend HWY_INLINE Mask operator!=(Wide a, Wide b) { return maskOf(hn::Ne(a.raw, b.raw)); }

    friend HWY_INLINE Wide select(Mask where, Wide a, Wide b) {
        return hn::IfThenElse(rawOf(where), a.raw, b.raw);
    }
    friend HWY_INLINE Wide selectOrZero(Mask where, Wide a) {
        return hn::IfThenElseZero(rawOf(where), a.raw);
    }

  private:
    using MaskTag = hn::ScalableTag<std::conditional_t<sizeof(T) == 8, double, float>>;
    static HWY_INLINE Mask maskOf(hn::Mask<Tag> m) { return {hn::RebindMask(MaskTag(), m)}; }
    static HWY_INLINE hn::Mask<Tag> rawOf(Mask m) { return hn::RebindMask(Tag(), m.raw); }
};

using Float = Wide<float>;
using Double = Wide<double>;
using Uint = Wide<std::uint32_t>;
using Int = Wide<std::int32_t>;
using Mask = Float::Mask;
using FloatTag = Float::Tag;

/// Whole numbers in as many lanes as F has.
template <typename F>
using UintOf = std::conditional_t<std::is_same_v<F, float>, std::uint32_t, Uint>;
template <typename F>
using IntOf = std::conditional_t<std::is_same_v<F, float>, std::int32_t, Int>;

/// Lanes of a Float, at most.
inline constexpr std::size_t kLanes = hn::MaxLanes(FloatTag());
HWY_INLINE std::size_t lanes() { return hn::Lanes(FloatTag()); }

HWY_INLINE Mask allLanes() { return Float(0) == Float(0); }
HWY_INLINE Mask noLanes() { return Float(0) < Float(0); }

HWY_INLINE float select(bool where, float a, float b) { return where ? a : b; }
HWY_INLINE std::int32_t select(bool where, std::int32_t a, std::int32_t b) { return where ? a : b; }
HWY_INLINE std::uint32_t select(bool where, std::uint32_t a, std::uint32_t b) { return where ? a : b; }
HWY_INLINE std::int32_t selectOrZero(bool where, std::int32_t a) { return where ? a : 0; }
HWY_INLINE float selectOrZero(bool where, float a) { return where ? a : 0; }
HWY_INLINE bool none(bool a) { return !a; }
HWY_INLINE bool any(bool a) { return a; }
HWY_INLINE bool all(bool a) { return a; }

HWY_INLINE Float max(Float a, Float b) { return select(a < b, b, a); }
HWY_INLINE Float min(Float a, Float b) { return select(b < a, b, a); }
HWY_INLINE Float sqrt(Float a) { return hn::Sqrt(a.raw); }
HWY_INLINE Float abs(Float a) { return hn::Abs(a.raw); }
HWY_INLINE Float floor(Float a) { return hn::Floor(a.raw); }
HWY_INLINE Float copySign(Float size, Float sign) { return hn::CopySign(size.raw, sign.raw); }
HWY_INLINE float max(float a, float b) { return a < b ? b : a; }
HWY_INLINE float min(float a, float b) { return b < a ? b : a; }
HWY_INLINE float sqrt(float a) { return std::sqrt(a); }
HWY_INLINE float abs(float a) { return std::fabs(a); }
/// Without a call; of -0 it is 0.
HWY_INLINE float floor(float a) {
    constexpr float kWholeFromHere = 0x1p23F;
    if (!(std::fabs(a) < kWholeFromHere)) return a;
    const auto whole = static_cast<float>(static_cast<std::int32_t>(a));
    return whole > a ? whole - 1 : whole;
}
HWY_INLINE float copySign(float size, float sign) { return std::copysign(size, sign); }

HWY_INLINE Mask isFinite(Float a) { return abs(a) < std::numeric_limits<float>::infinity(); }
HWY_INLINE bool isFinite(float a) { return std::isfinite(a); }

/// x brought to within low..high; NaN stays.
template <typename F>
HWY_INLINE F clamp(F x, std::type_identity_t<F> low, std::type_identity_t<F> high) {
    return min(max(x, low), high);
}

/// 3x^2 - 2x^3 of x clamped to 0..1.
template <typename F>
HWY_INLINE F smoothstep(F x) {
    const F c = clamp(x, 0.0F, 1.0F);
    return c * c * (3.0F - 2.0F * c);
}

/// Rounded towards zero.
HWY_INLINE Int truncate(Float a) { return hn::ConvertTo(Int::Tag(), a.raw); }
HWY_INLINE std::int32_t truncate(float a) { return static_cast<std::int32_t>(a); }
HWY_INLINE float toFloat(std::int32_t a) { return static_cast<float>(a); }
HWY_INLINE Float toFloat(Int a) { return hn::ConvertTo(FloatTag(), a.raw); }
/// The same bits, otherwise understood.
HWY_INLINE Uint bitsOf(Float a) { return hn::BitCast(Uint::Tag(), a.raw); }
HWY_INLINE std::uint32_t bitsOf(float a) { return std::bit_cast<std::uint32_t>(a); }
HWY_INLINE std::int32_t toInt(std::uint32_t a) { return static_cast<std::int32_t>(a); }
HWY_INLINE std::uint32_t toUint(std::int32_t a) { return static_cast<std::uint32_t>(a); }
HWY_INLINE Float floatOf(Uint bits) { return hn::BitCast(FloatTag(), bits.raw); }
HWY_INLINE float floatOf(std::uint32_t bits) { return std::bit_cast<float>(bits); }
HWY_INLINE Float floatOf(Int bits) { return hn::BitCast(FloatTag(), bits.raw); }
HWY_INLINE Int toInt(Uint a) { return hn::BitCast(Int::Tag(), a.raw); }
HWY_INLINE Uint toUint(Int a) { return hn::BitCast(Uint::Tag(), a.raw); }
template <int bits, typename T>
HWY_INLINE Wide<T> shiftLeft(Wide<T> a) {
    return hn::ShiftLeft<bits>(a.raw);
}
template <int bits, typename T>
HWY_INLINE Wide<T> shiftRight(Wide<T> a) {
    return hn::ShiftRight<bits>(a.raw);
}
template <int bits>
HWY_INLINE std::uint32_t shiftRight(std::uint32_t a) {
    return a >> bits;
}
template <int bits>
HWY_INLINE std::uint32_t shiftLeft(std::uint32_t a) {
    return a << bits;
}
/// By the same number of bits in all lanes; of signed numbers the sign follows to the right.
template <typename T>
HWY_INLINE Wide<T> operator<<(Wide<T> a, int bits) {
    return hn::ShiftLeftSame(a.raw, bits);
}
template <typename T>
HWY_INLINE Wide<T> operator>>(Wide<T> a, int bits) {
    return hn::ShiftRightSame(a.raw, bits);
}
/// first, first + 1, ... (Iota of a variable would be built number by number.)
HWY_INLINE Uint iota(std::size_t first) {
    return Uint(hn::Iota(Uint::Tag(), 0)) + static_cast<std::uint32_t>(first);
}

/// Memory needs no alignment, and room for a whole vector.
HWY_INLINE Float load(const float* from) { return hn::LoadU(FloatTag(), from); }
HWY_INLINE Uint load(const std::uint32_t* from) { return hn::LoadU(Uint::Tag(), from); }
HWY_INLINE Int load(const std::int32_t* from) { return hn::LoadU(Int::Tag(), from); }
template <typename T>
HWY_INLINE void store(Wide<T> a, T* to) {
    hn::StoreU(a.raw, hn::ScalableTag<T>(), to);
}
/// The first `count` values, with zeros behind them; so many are read.
HWY_INLINE Float loadSome(const float* from, std::size_t count) {
    HWY_ALIGN float values[kLanes] = {};
    for (std::size_t i = 0; i < count; ++i) values[i] = from[i];
    return load(values);
}
/// from[index], each in its lane.
HWY_INLINE Float gather(const float* from, Int index) { return hn::GatherIndex(FloatTag(), from, index.raw); }
HWY_INLINE Uint gather(const std::uint32_t* from, Int index) {
    return hn::GatherIndex(Uint::Tag(), from, index.raw);
}
HWY_INLINE float gather(const float* from, std::int32_t index) { return from[index]; }
HWY_INLINE std::uint32_t gather(const std::uint32_t* from, std::int32_t index) { return from[index]; }
/// Some of the lanes, to be stored side by side; what follows them in the vector becomes undefined.
class Compressor {
  public:
    HWY_INLINE explicit Compressor(Mask lanes) : side_(lanes.raw), count_(lanes.count()) {}

    HWY_INLINE void store(Float a, float* to) const { side_.store(a.raw, to); }
    HWY_INLINE void store(Uint a, std::uint32_t* to) const {
        side_.store(floatOf(a).raw, reinterpret_cast<float*>(to));
    }
    HWY_INLINE std::size_t count() const { return count_; }

  private:
    Compaction side_;
    std::size_t count_;
};

} // namespace HWY_NAMESPACE
} // namespace rtcore
HWY_AFTER_NAMESPACE();

#endif
