// The way of a lamp's light to a ray through fog and along it to the ray's beginning, in vectors of rays.
// Included once for each instruction set, inside foreach_target.h's loop.
#include "rtcore/scene/light.h"
#include "rtcore/shading/fog_math-inl.h"

#if defined(RTCORE_SHADING_FOG_PATH_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef RTCORE_SHADING_FOG_PATH_INL_H_
#undef RTCORE_SHADING_FOG_PATH_INL_H_
#else
#define RTCORE_SHADING_FOG_PATH_INL_H_
#endif

HWY_BEFORE_NAMESPACE();
namespace rtcore {
namespace HWY_NAMESPACE {

/// fogLength() between two heights (in scale heights) `distance` apart, `atA` and `atB` the densities there.
HWY_INLINE Floats lengthBetween(Floats a, Floats atA, Floats b, Floats atB, Floats distance) {
    const Floats rise = hn::Abs(hn::Sub(a, b));
    const Floats level = hn::Mul(larger(atA, atB), meanDecaySeries(smaller(rise, constant(0.25F))));
    const Floats steep = hn::Div(hn::Abs(hn::Sub(atA, atB)), rise);
    return hn::Mul(distance, hn::IfThenElse(hn::Lt(rise, constant(0.25F)), level, steep));
}

/// How a lamp with a place shines: to all sides alike, in a spot's cone, or with the cosine of a rectangle.
/// Lamps with a size shine from their middle.
enum class Beam { Even, Cone, Cosine };

/// Where closer counts as this close.
inline float leastApart(const Light& light) {
    if (light.kind != LightKind::Rectangle) return light.radius;
    return light.radius + 0.25F * (light.width + light.height);
}

/// Such a lamp, seen from rays.
template <bool exponential, Beam beam>
struct LampPath {
    HWY_INLINE LampPath(const FogMedium& medium, const Light& light, Vectors origin, Vectors direction)
        : fog(medium), cosOuter(light.cosOuter), perCosine(1 / (light.cosInner - light.cosOuter)) {
        const Vectors offset = constant(light.position.x, light.position.y, light.position.z) - origin;
        foot = dot(offset, direction);
        const Vectors across = offset - direction * foot;
        const Floats nearest = hn::Mul(hn::Sqrt(dot(offset, offset)), constant(1e-4F));
        apart = larger(hn::Sqrt(dot(across, across)),
                       larger(larger(nearest, constant(leastApart(light))), constant(1e-9F)));
        if constexpr (exponential) {
            height = fog.height(origin);
            density = expOf(hn::Neg(height));
            slope = fog.slope(direction);
            lampHeight =
                larger(hn::Mul(constant((dot(medium.up, light.position) - medium.ground)), fog.perHeight),
                       constant(FogMedium::kLowest));
            lampDensity = expOf(hn::Neg(lampHeight));
        }
        if constexpr (beam != Beam::Even) {
            const Vectors axis = constant(light.direction.x, light.direction.y, light.direction.z);
            axial = hn::Neg(dot(offset, axis));
            perAxial = dot(direction, axis);
            offsetSquare = dot(offset, offset);
        }
    }

    /// Relative density at t times what is left of the light that comes there over r and goes back over t,
    /// times what it shines there of its intensity. `counted`: whether the fog between the lamp and t counts.
    HWY_INLINE Floats light(Floats t, Floats r, bool counted = true) const {
        Floats result;
        if constexpr (exponential) {
            const Floats z = larger(hn::Add(height, hn::Mul(slope, t)), constant(FogMedium::kLowest));
            const Floats here = expOf(hn::Neg(z));
            Floats length = lengthBetween(height, density, z, here, t);
            if (counted) length = hn::Add(length, lengthBetween(lampHeight, lampDensity, z, here, r));
            result = hn::Mul(here, expOf(hn::Neg(hn::Mul(fog.density, length))));
        } else {
            result = expOf(hn::Neg(hn::Mul(fog.density, counted ? hn::Add(t, r) : t)));
        }
        if constexpr (beam == Beam::Even) return result;
        const Floats cosine = hn::Div(hn::Add(axial, hn::Mul(perAxial, t)), r);
        if constexpr (beam == Beam::Cosine) {
            result = hn::Mul(result, larger(cosine, constant(0)));
        } else {
            const Floats share = hn::Mul(hn::Sub(cosine, constant(cosOuter)), constant(perCosine));
            const Floats x = smaller(larger(share, constant(0)), constant(1));
            result = hn::Mul(result, hn::Mul(hn::Mul(x, x), hn::Sub(constant(3), hn::Add(x, x))));
        }
        return result;
    }

    /// From where on the fog of a ray that falls up to `to` is within some scale heights of its thickest;
    /// else a place that is not ahead.
    HWY_INLINE Floats thickFrom(Floats to) const {
        if constexpr (!exponential) return constant(-1e30F);
        const Floats falling = smaller(slope, constant(-1e-20F));
        const Floats from = hn::Add(to, hn::Div(constant(4), falling));
        return hn::IfThenElse(hn::Lt(slope, hn::Zero(FloatTag())), from, constant(-1e30F));
    }

    /// A bound of how much the logarithm of light() changes on the stretch, the beam left out.
    HWY_INLINE Floats change(Floats from, Floats to) const {
        const Floats distance = hn::Sub(to, from);
        if constexpr (!exponential) return hn::Mul(hn::Add(fog.density, fog.density), distance);
        const Floats lowest = hn::Add(height, smaller(hn::Mul(slope, from), hn::Mul(slope, to)));
        const Floats densest = larger(expOf(hn::Neg(lowest)), lampDensity);
        const Floats depth = hn::Mul(hn::Mul(fog.density, densest), distance);
        return hn::Add(hn::Mul(hn::Abs(slope), distance), hn::Add(depth, depth));
    }

    /// Leaves of the stretch what lies in the beam, when that is convex.
    HWY_INLINE void clip(Floats& from, Floats& to) const {
        if constexpr (beam == Beam::Cone) {
            if (cosOuter >= 0) clipToCone(from, to);
        } else if constexpr (beam == Beam::Cosine) {
            const Floats plane = hn::Div(hn::Neg(axial), nonZero(perAxial));
            const Lanes ahead = hn::Gt(perAxial, constant(0));
            from = hn::IfThenElse(ahead, larger(from, plane), from);
            to = hn::IfThenElse(ahead, to, smaller(to, plane));
        }
    }

    VectorFog fog;
    Floats foot;                                            ///< t where the ray passes the lamp
    Floats apart;                                           ///< and how far from it
    Floats height, density, slope, lampHeight, lampDensity; ///< where the fog is exponential
    Floats axial, perAxial, offsetSquare;                   ///< where the beam is not even
    float cosOuter, perCosine;

  private:
    HWY_INLINE void clipToCone(Floats& from, Floats& to) const {
        // (axial + perAxial t)^2 = cosOuter^2 (offsetSquare - 2 foot t + t^2)
        const Floats square = constant(cosOuter * cosOuter);
        const Floats a = hn::Sub(hn::Mul(perAxial, perAxial), square);
        const Floats b = hn::Add(hn::Mul(perAxial, axial), hn::Mul(square, foot));
        const Floats c = hn::Sub(hn::Mul(axial, axial), hn::Mul(square, offsetSquare));
        const Floats rest = hn::Sub(hn::Mul(b, b), hn::Mul(a, c));
        const Floats root = hn::Sqrt(larger(rest, constant(0)));
        const Floats q = hn::Neg(hn::Add(b, hn::CopySign(root, b)));
        const Floats x = hn::Div(q, nonZero(a)), y = hn::Div(c, nonZero(q));
        const Floats first = smaller(x, y), second = larger(x, y);
        const Lanes within = hn::Lt(a, constant(0));
        const Lanes ahead = hn::Gt(perAxial, constant(0));
        // Between the two, or from the farther one on, or up to the nearer one.
        const Floats start = hn::IfThenElse(within, first, hn::IfThenElse(ahead, second, from));
        const Floats end = hn::IfThenElse(within, second, hn::IfThenElse(ahead, to, first));
        // Between them may lie the cone's other half, where the spot does not shine.
        const Floats middle = hn::Mul(hn::Add(first, second), constant(0.5F));
        const Lanes behind = hn::Lt(hn::Add(axial, hn::Mul(perAxial, middle)), constant(0));
        const Lanes missed = hn::And(within, hn::Or(behind, hn::Lt(rest, constant(0))));
        from = larger(from, start);
        to = hn::IfThenElse(missed, from, smaller(to, end));
    }

    static HWY_INLINE Floats nonZero(Floats v) {
        const Lanes small = hn::Lt(hn::Abs(v), constant(1e-20F));
        return hn::IfThenElse(small, hn::CopySign(constant(1e-20F), v), v);
    }
};

} // namespace HWY_NAMESPACE
} // namespace rtcore
HWY_AFTER_NAMESPACE();

#endif
