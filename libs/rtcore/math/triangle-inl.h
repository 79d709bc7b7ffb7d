// Points, normals and clearances of triangles, over the number F: float or Float. Included once for each
// instruction set, inside the loop of foreach_target.h, or alone.
#include "rtcore/math/float3-inl.h"
#include "rtcore/math/triangle.h"

#if defined(RTCORE_MATH_TRIANGLE_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef RTCORE_MATH_TRIANGLE_INL_H_
#undef RTCORE_MATH_TRIANGLE_INL_H_
#else
#define RTCORE_MATH_TRIANGLE_INL_H_
#endif

HWY_BEFORE_NAMESPACE();
namespace rtcore {
namespace HWY_NAMESPACE {

/// Positions of the corners, or what belongs to them.
template <typename F>
struct Corners {
    Vec3Of<F> a, b, c;
};

/// The mean, weighted by the barycentric coordinates of a point: 1 - u - v, u and v.
template <typename F>
HWY_INLINE Vec3Of<F> interpolate(const Corners<F>& of, F u, F v) {
    return of.a * (1.0F - u - v) + of.b * u + of.c * v;
}

/// Not of unit length.
template <typename F>
HWY_INLINE Vec3Of<F> normalOf(const Corners<F>& p) {
    return cross(p.b - p.a, p.c - p.a);
}

/// `normals` are those of the corners, `front` that of the face, of unit length.
template <typename F>
HWY_INLINE auto normalsBehind(const Corners<F>& normals, Vec3Of<F> front) {
    return dot(normals.a + normals.b + normals.c, front) < kNormalsBehind;
}

/// `normal`: of unit length.
template <typename F>
HWY_INLINE F surfaceClearance(const Corners<F>& p, Vec3Of<F> normal) {
    const auto largest = [](F x, F y, F z) { return max(abs(x), max(abs(y), abs(z))); };
    const Vec3Of<F> extent{largest(p.a.x, p.b.x, p.c.x), largest(p.a.y, p.b.y, p.c.y),
                           largest(p.a.z, p.b.z, p.c.z)};
    return (4.0F * dot(extent, abs(normal)) + maxComponent(extent)) * 0x1p-20F;
}

} // namespace HWY_NAMESPACE
} // namespace rtcore
HWY_AFTER_NAMESPACE();

#endif
