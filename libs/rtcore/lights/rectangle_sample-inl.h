// Rectangle lights sampled by the solid angle under which they are seen, over the number F: float or Float.
// Near a rectangle the noise is far below that of points that are uniform by area (light_sample-inl.h).
// Included once for each instruction set, inside the loop of foreach_target.h, or alone.
//
// After Urena, Fajardo and King 2013, "An Area-Preserving Parametrization for Spherical Rectangles", with the
// angle of a strip in closed form in place of sums of dihedral angles, which cancel in single precision: with
// the point's foot in the plane of the rectangle as origin, h its height, and b(y) = y / sqrt(h^2 + y^2), the
// part of the strip y0..y1 between 0 and x is seen under phi = asin(s b(y1)) - asin(s b(y0)), s = x /
// sqrt(h^2 + x^2).
#include "rtcore/lights/light_sample-inl.h"

#if defined(RTCORE_LIGHTS_RECTANGLE_SAMPLE_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef RTCORE_LIGHTS_RECTANGLE_SAMPLE_INL_H_
#undef RTCORE_LIGHTS_RECTANGLE_SAMPLE_INL_H_
#else
#define RTCORE_LIGHTS_RECTANGLE_SAMPLE_INL_H_
#endif

HWY_BEFORE_NAMESPACE();
namespace rtcore {
namespace HWY_NAMESPACE {

/// Below it, in steradian, a rectangle is sampled by area: nothing is gained any more, and angles of float
/// lose their digits.
inline constexpr float kMinSolidAngle = 2e-3F;

/// A rectangle light seen from a point, in the light's axes, with the foot of the point in its plane as
/// origin.
template <typename F>
struct SeenRectangle {
    F left, right, bottom, top;
    F height;     ///< of the point before the light
    F start;      ///< the solid angle between the origin and `left`; negative where `left` is
    F solidAngle; ///< 0 where the light shines away from the point
};

/// The solid angle of the part 0..x of a strip y0..y1; negative where x is.
template <typename F>
HWY_INLINE F stripSolidAngle(F x, F y0, F y1, F height) {
    const F square = x * x + height * height;
    const F low = y0 / sqrt(square + y0 * y0), high = y1 / sqrt(square + y1 * y1);
    return fastAtan2<F>(x * height * (high - low), height * height + x * x * (low * high));
}

template <typename F>
HWY_INLINE SeenRectangle<F> seenRectangle(const Light& light, Vec3Of<F> position) {
    const Vec3Of<F> offset = broadcast<F>(light.position) - position;
    const F x = dot(offset, broadcast<F>(light.right));
    const F y = dot(offset, broadcast<F>(cross(light.direction, light.right)));
    const float halfWidth = 0.5F * light.width, halfHeight = 0.5F * light.height;
    SeenRectangle<F> seen{x - halfWidth,
                          x + halfWidth,
                          y - halfHeight,
                          y + halfHeight,
                          -dot(offset, broadcast<F>(light.direction)),
                          F(0),
                          F(0)};
    seen.start = stripSolidAngle<F>(seen.left, seen.bottom, seen.top, seen.height);
    const F end = stripSolidAngle<F>(seen.right, seen.bottom, seen.top, seen.height);
    seen.solidAngle = selectOrZero(seen.height > 0.0F, end - seen.start);
    return seen;
}

/// Up to where the part `u` of the solid angle lies.
template <typename F>
HWY_INLINE F solidAngleColumn(const SeenRectangle<F>& seen, F u) {
    const auto sine = [&](F y) HWY_ATTR { return y / sqrt(seen.height * seen.height + y * y); };
    const F low = sine(seen.bottom), high = sine(seen.top);
    const auto half = fastCircle<F>(0.5F * (seen.start + u * seen.solidAngle));
    // high^2 - 2 high low cos(phi) + low^2 as a sum of what is not negative.
    const F product = 4.0F * low * high, apart = high - low, sum = high + low;
    const F square = select(product < 0.0F, sum * sum - product * half.cosine * half.cosine,
                            apart * apart + product * half.sine * half.sine);
    const F s = clamp<F>(2.0F * half.sine * half.cosine / sqrt(max(square, F(1e-30F))), F(-1), F(1));
    const F x = seen.height * s / sqrt(max((1.0F - s) * (1.0F + s), F(1e-14F)));
    return clamp<F>(x, seen.left, seen.right);
}

/// The part `v` of the sines of a column's elevation, by what they lack of 1 on the side that is further
/// away.
template <typename F>
HWY_INLINE F solidAngleRow(const SeenRectangle<F>& seen, F x, F v) {
    const F square = x * x + seen.height * seen.height;
    const F side = copySign(F(1), seen.bottom + seen.top);
    const auto lacking = [&](F y) HWY_ATTR {
        const F length = sqrt(square + y * y), sum = length + abs(y);
        return select(y * side > 0.0F, square / (length * sum), sum / length);
    };
    const F low = lacking(seen.bottom), high = lacking(seen.top);
    const F lack = low + v * (high - low);
    const F y = side * (1.0F - lack) * sqrt(square / max(lack * (2.0F - lack), F(1e-14F)));
    return clamp<F>(y, seen.bottom, seen.top);
}

/// By solid angle, of a direction in which the rectangle is met at `distance`.
template <typename F>
HWY_INLINE F rectangleDensity(const Light& light, const SeenRectangle<F>& seen, F distance) {
    const F byArea =
        distance * distance / (areaOfFlat<LightKind::Rectangle>(light) * (seen.height / distance));
    const F density = select(seen.solidAngle >= kMinSolidAngle, 1.0F / seen.solidAngle, byArea);
    return selectOrZero(seen.height > 0.0F, density);
}

/// The density by solid angle with which sampleRectangleBySolidAngle() finds the direction of a ray that
/// meets the light at `distance` (light_hit-inl.h).
template <typename F>
HWY_INLINE F rectangleDensity(const Light& light, Vec3Of<F> origin, F distance) {
    return rectangleDensity<F>(light, seenRectangle<F>(light, origin), distance);
}

/// One sample of a light, with its density.
template <typename F>
struct LightDirectionSample {
    Vec3Of<F> toLight; ///< unit
    F free;            ///< length of the shadow ray
    Vec3Of<F>
        irradiance; ///< on a surface that faces the light, before shadows: its radiance over the density
    F density;      ///< by solid angle; 0 of lights that no ray meets
};

/// A point of a rectangle light, uniform by solid angle, or by area where that is small. `u`, `v`: 0..1,
/// without 1. Behind the light irradiance and density are 0.
template <typename F>
HWY_INLINE LightDirectionSample<F> sampleRectangleBySolidAngle(const Light& light, Vec3Of<F> position, F u,
                                                               F v) {
    const SeenRectangle<F> seen = seenRectangle<F>(light, position);
    const auto bySolidAngle = seen.solidAngle >= kMinSolidAngle;
    const F column = solidAngleColumn<F>(seen, u);
    const F x = select(bySolidAngle, column, seen.left + u * light.width);
    const F y = select(bySolidAngle, solidAngleRow<F>(seen, column, v), seen.bottom + v * light.height);
    const Vec3Of<F> offset = broadcast<F>(light.right) * x +
                             broadcast<F>(cross(light.direction, light.right)) * y -
                             broadcast<F>(light.direction) * seen.height;
    const PathToLight<F> path = pathToLight<F>(light, offset);
    const F density = rectangleDensity<F>(light, seen, path.distance);
    const F scale = selectOrZero(density > 0.0F, 1.0F / (density * areaOfFlat<LightKind::Rectangle>(light)));
    return {path.direction, path.free, broadcast<F>(light.intensity) * scale, density};
}

/// Where the part `u` of the area below a line from `a` at 0 to `b` at 1 ends; both above 0.
template <typename F>
HWY_INLINE F sampleLinear(F a, F b, F u) {
    return clamp<F>(u * (a + b) / (a + sqrt(a * a + u * (b * b - a * a))), F(0), F(0.99999994F));
}

/// The same for a matte surface with that normal: with a density that follows, from corner to corner, the
/// cosine at the surface, which on open ground is nearly all that varies. (Hart et al. 2020, "Practical
/// product sampling by fitting and composing warps")
template <typename F>
HWY_INLINE LightDirectionSample<F> sampleRectangleForSurface(const Light& light, Vec3Of<F> position,
                                                             Vec3Of<F> normal, F u, F v) {
    constexpr float kMin = 0.05F; // what lies below the horizon of one corner may lie above in the middle
    const Vec3Of<F> offset = broadcast<F>(light.position) - position;
    const Vec3Of<F> right = broadcast<F>(light.right * (0.5F * light.width)),
                    up = broadcast<F>(cross(light.direction, light.right) * (0.5F * light.height));
    const auto cosine = [&](Vec3Of<F> corner) HWY_ATTR {
        const F length = sqrt(dot(corner, corner));
        return max(dot(corner, normal) / max(length, F(1e-18F)), F(kMin));
    };
    const F leftBottom = cosine(offset - right - up), rightBottom = cosine(offset + right - up),
            leftTop = cosine(offset - right + up), rightTop = cosine(offset + right + up);
    const F row = sampleLinear<F>(leftBottom + rightBottom, leftTop + rightTop, v);
    const F left = leftBottom + row * (leftTop - leftBottom),
            high = rightBottom + row * (rightTop - rightBottom);
    const F column = sampleLinear<F>(left, high, u);
    const F density =
        4.0F * (left + column * (high - left)) / (leftBottom + rightBottom + leftTop + rightTop);
    LightDirectionSample<F> sample = sampleRectangleBySolidAngle<F>(light, position, column, row);
    sample.irradiance = sample.irradiance / density;
    sample.density = sample.density * density;
    return sample;
}

} // namespace HWY_NAMESPACE
} // namespace rtcore
HWY_AFTER_NAMESPACE();

#endif
