// Vectors of space and colours as wide as the processor's registers: math/vec.h over Float. Included once for
// each instruction set, inside the loop of foreach_target.h, or alone.
#include "rtcore/math/colour.h"
#include "rtcore/math/vec.h"
#include "rtcore/simd/wide-inl.h"

#if defined(RTCORE_MATH_FLOAT3_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef RTCORE_MATH_FLOAT3_INL_H_
#undef RTCORE_MATH_FLOAT3_INL_H_
#else
#define RTCORE_MATH_FLOAT3_INL_H_
#endif

HWY_BEFORE_NAMESPACE();
namespace rtcore {
namespace HWY_NAMESPACE {

#define RT_FORMULA HWY_INLINE
#include "rtcore/math/vec3_text.h"
#undef RT_FORMULA

/// A vector of space, or the red, green and blue of a colour, in each lane.
using Float3 = Vec3T<Float>;

/// The vector type of formulas over the number F: Vec3, Vec3d or Float3.
template <typename F>
using Vec3Of = std::conditional_t<std::is_floating_point_v<F>, rtcore::Vec3T<F>, Vec3T<F>>;

/// The same in all lanes.
template <typename F = Float>
HWY_INLINE Vec3Of<F> broadcast(Vec3 v) {
    return {v.x, v.y, v.z};
}
template <typename F = Float>
HWY_INLINE Vec3Of<F> broadcast(Colour c) {
    return {c.r, c.g, c.b};
}
HWY_INLINE Float3 broadcast(const float (&v)[3]) { return {v[0], v[1], v[2]}; }

HWY_INLINE Float3 select(Mask where, Float3 a, Float3 b) {
    return {select(where, a.x, b.x), select(where, a.y, b.y), select(where, a.z, b.z)};
}
HWY_INLINE Float3 selectOrZero(Mask where, Float3 a) {
    return {selectOrZero(where, a.x), selectOrZero(where, a.y), selectOrZero(where, a.z)};
}
HWY_INLINE Vec3 select(bool where, Vec3 a, Vec3 b) { return where ? a : b; }
HWY_INLINE Vec3 selectOrZero(bool where, Vec3 a) { return where ? a : Vec3{}; }
HWY_INLINE Float3 abs(Float3 a) { return {abs(a.x), abs(a.y), abs(a.z)}; }
HWY_INLINE Vec3 abs(Vec3 a) { return {abs(a.x), abs(a.y), abs(a.z)}; }
template <typename V>
HWY_INLINE auto maxComponent(const V& a) {
    return max(a.x, max(a.y, a.z));
}
template <typename F>
HWY_INLINE F luminance(Vec3Of<F> c) {
    return kLuminance.r * c.x + kLuminance.g * c.y + kLuminance.b * c.z;
}
HWY_INLINE Mask isZero(Float3 a) { return (a.x == 0.0F) & (a.y == 0.0F) & (a.z == 0.0F); }

HWY_INLINE Float3 load(const float* x, const float* y, const float* z) { return {load(x), load(y), load(z)}; }
HWY_INLINE void store(Float3 a, float* x, float* y, float* z) {
    store(a.x, x);
    store(a.y, y);
    store(a.z, z);
}
/// x, y, z, x, y, z...
HWY_INLINE Float3 loadInterleaved(const float* from) {
    Float3 a;
    hn::LoadInterleaved3(FloatTag(), from, a.x.raw, a.y.raw, a.z.raw);
    return a;
}
/// Loads from three arrays {x, y, z}, from the element `i` on.
template <typename Arrays>
HWY_INLINE Float3 loadAt(const Arrays& from, std::size_t i) {
    return load(from.x + i, from.y + i, from.z + i);
}
template <typename Arrays>
HWY_INLINE void storeAt(Float3 a, const Arrays& to, std::size_t i) {
    store(a, to.x + i, to.y + i, to.z + i);
}
template <typename Arrays>
HWY_INLINE void storeAt(Float3 a, const Compressor& some, const Arrays& to, std::size_t i) {
    some.store(a.x, to.x + i);
    some.store(a.y, to.y + i);
    some.store(a.z, to.z + i);
}

/// The direction at `turn` around `axis`, which is of unit length.
template <typename F, typename Turn>
HWY_INLINE Vec3Of<F> aroundAxis(Vec3Of<F> axis, const Turn& turn) {
    const auto basis = basisAround(axis);
    return basis.tangent * turn.cosine + basis.bitangent * turn.sine;
}

/// rtcore::normalize() one by one.
HWY_NOINLINE inline void normalizeEach(const float* x, const float* y, const float* z, float* out,
                                       std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) {
        const Vec3 unit = rtcore::normalize(Vec3{x[i], y[i], z[i]});
        out[i] = unit.x;
        out[count + i] = unit.y;
        out[2 * count + i] = unit.z;
    }
}

/// The unit vectors in those of the lanes that are used.
HWY_INLINE Float3 normalize(Float3 a, Mask used) {
    const Float square = dot(a, a);
    const Mask ordinary = (square > kMinSquare) & (square < kMaxSquare);
    const Float3 unit = a / sqrt(square);
    if (HWY_LIKELY(none(without(used, ordinary)))) return unit;
    HWY_ALIGN float x[kLanes], y[kLanes], z[kLanes], out[3 * kLanes];
    store(a, x, y, z);
    normalizeEach(x, y, z, out, lanes());
    return select(ordinary, unit, load(out, out + lanes(), out + 2 * lanes()));
}
HWY_INLINE Float3 normalize(Float3 a) { return normalize(a, allLanes()); }

} // namespace HWY_NAMESPACE
} // namespace rtcore
HWY_AFTER_NAMESPACE();

#endif
