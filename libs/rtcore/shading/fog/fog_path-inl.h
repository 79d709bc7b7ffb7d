// The path of light through fog from a light to a ray and along it to the ray's origin, in vectors of rays.
// Included once for each instruction set, inside foreach_target.h's loop.
#include "rtcore/lights/light_sample-inl.h"
#include "rtcore/shading/fog/fog_math-inl.h"

#if defined(RTCORE_SHADING_FOG_FOG_PATH_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef RTCORE_SHADING_FOG_FOG_PATH_INL_H_
#undef RTCORE_SHADING_FOG_FOG_PATH_INL_H_
#else
#define RTCORE_SHADING_FOG_FOG_PATH_INL_H_
#endif

HWY_BEFORE_NAMESPACE();
namespace rtcore {
namespace HWY_NAMESPACE {

/// fogLength() between two heights (in scale heights) `distance` apart, `atA` and `atB` the densities there.
HWY_INLINE Float lengthBetween(Float a, Float atA, Float b, Float atB, Float distance) {
    const Float rise = abs(a - b);
    const Float level = max(atA, atB) * meanDecaySeries(min(rise, 0.25F));
    const Float steep = abs(atA - atB) / rise;
    return distance * select(rise < 0.25F, level, steep);
}

/// Calls use.operator()<beam>().
template <typename Use>
HWY_INLINE void forBeam(Beam beam, Use&& use) {
    if (beam == Beam::Cone) return use.template operator()<Beam::Cone>();
    if (beam == Beam::Cosine) return use.template operator()<Beam::Cosine>();
    if (beam == Beam::Measured) return use.template operator()<Beam::Measured>();
    use.template operator()<Beam::Even>();
}

/// Where closer counts as this close.
inline float minApart(const Light& light) {
    if (!traitsOf(light).sides) return light.radius;
    return light.radius + 0.25F * (light.width + light.height);
}

/// A light that has a position, seen from rays; an area light shines from its middle.
template <bool exponential, Beam beam>
struct LightPath {
    HWY_INLINE LightPath(const FogMedium& medium, const Light& light, Float3 origin, Float3 direction)
        : extinction(medium.density), cosOuter(light.cosOuter),
          perCosine(1 / (light.cosInner - light.cosOuter)) {
        const Float3 offset = broadcast(light.position) - origin;
        foot = dot(offset, direction);
        const Float3 across = offset - direction * foot;
        const Float nearest = sqrt(dot(offset, offset)) * 1e-4F;
        apart = max(sqrt(dot(across, across)), max(max(nearest, minApart(light)), 1e-9F));
        if constexpr (exponential) {
            height = fogHeight<Float>(medium, origin);
            density = fastExp(-height);
            slope = fogSlope<Float>(medium, direction);
            lightHeight = fogHeight<float>(medium, light.position);
            lightDensity = fastExp(-lightHeight);
        }
        if constexpr (beam != Beam::Even) {
            const Float3 axis = broadcast(light.direction);
            axial = -dot(offset, axis);
            perAxial = dot(direction, axis);
            offsetSquare = dot(offset, offset);
        }
        if constexpr (beam == Beam::Measured) {
            const Float3 right = broadcast(light.right);
            const Float3 side = broadcast(cross(light.right, light.direction));
            web = &photometryOf(light);
            cosOuter = web->cosReach;
            sideways = {-dot(offset, right), -dot(offset, side), 0.0F};
            perSideways = {dot(direction, right), dot(direction, side), 0.0F};
        }
    }

    /// Relative density at t, times transmittance over r to the light and back over t, times the light's
    /// relative intensity in that direction. `counted`: whether the fog between the light and t counts.
    HWY_INLINE Float light(Float t, Float r, bool counted = true) const {
        Float result;
        if constexpr (exponential) {
            const Float z = max(height + slope * t, FogMedium::kLowest);
            const Float here = fastExp(-z);
            Float length = lengthBetween(height, density, z, here, t);
            if (counted) length += lengthBetween(lightHeight, lightDensity, z, here, r);
            result = here * fastExp(-(extinction * length));
        } else {
            result = fastExp(-(extinction * (counted ? t + r : t)));
        }
        if constexpr (beam == Beam::Even) return result;
        if constexpr (beam == Beam::Measured) {
            const Float3 at = sideways + perSideways * t;
            return result * measuredFactor<Float>(*web, axial + perAxial * t, at.x, at.y);
        }
        const Float cosine = (axial + perAxial * t) / r;
        if constexpr (beam == Beam::Cosine) return result * max(cosine, 0.0F);
        return result * smoothstep((cosine - cosOuter) * perCosine);
    }

    /// From where on the fog of a ray that falls up to `to` is within some scale heights of its thickest;
    /// else a t that is not ahead.
    HWY_INLINE Float thickFrom(Float to) const {
        if constexpr (!exponential) return -1e30F;
        const Float from = to + 4.0F / min(slope, -1e-20F);
        return select(slope < 0.0F, from, -1e30F);
    }

    /// A bound of how much the logarithm of light() changes on the stretch, the beam left out.
    HWY_INLINE Float change(Float from, Float to) const {
        const Float distance = to - from;
        if constexpr (!exponential) return (extinction + extinction) * distance;
        const Float lowest = height + min(slope * from, slope * to);
        const Float densest = max(fastExp(-lowest), lightDensity);
        const Float depth = extinction * densest * distance;
        return abs(slope) * distance + (depth + depth);
    }

    /// Leaves of the stretch what lies in the beam, when that is convex.
    HWY_INLINE void clip(Float& from, Float& to) const {
        if constexpr (beam == Beam::Cone || beam == Beam::Measured) {
            if (cosOuter >= 0) clipToCone(from, to);
        } else if constexpr (beam == Beam::Cosine) {
            const Float plane = -axial / nonZero(perAxial);
            const Mask ahead = perAxial > 0.0F;
            from = select(ahead, max(from, plane), from);
            to = select(ahead, to, min(to, plane));
        }
    }

    Float extinction; ///< per scene unit, where the relative density is 1
    Float foot;       ///< t where the ray passes the light
    Float apart;      ///< and how far from it
    Float height, density, slope, lightHeight, lightDensity; ///< where the fog is exponential
    Float axial, perAxial, offsetSquare;                     ///< where the beam is not even
    float cosOuter, perCosine;
    Float3 sideways, perSideways; ///< where the beam was measured: along C = 0 and C = 90 degrees
    const Photometry* web;

  private:
    HWY_INLINE void clipToCone(Float& from, Float& to) const {
        // (axial + perAxial t)^2 = cosOuter^2 (offsetSquare - 2 foot t + t^2)
        const Float square = cosOuter * cosOuter;
        const Float a = perAxial * perAxial - square;
        const Float b = perAxial * axial + square * foot;
        const Float c = axial * axial - square * offsetSquare;
        const Float rest = b * b - a * c;
        const Float root = sqrt(max(rest, 0.0F));
        const Float q = -(b + copySign(root, b));
        const Float x = q / nonZero(a), y = c / nonZero(q);
        const Float first = min(x, y), second = max(x, y);
        const Mask within = a < 0.0F;
        const Mask ahead = perAxial > 0.0F;
        // Between the two, or from the farther one on, or up to the nearer one.
        const Float start = select(within, first, select(ahead, second, from));
        const Float end = select(within, second, select(ahead, to, first));
        // Between them may lie the cone's other half, where the spot does not shine.
        const Float middle = (first + second) * 0.5F;
        const Mask behind = axial + perAxial * middle < 0.0F;
        const Mask missed = within & (behind | (rest < 0.0F));
        from = max(from, start);
        to = select(missed, from, min(to, end));
    }

    static HWY_INLINE Float nonZero(Float v) { return select(abs(v) < 1e-20F, copySign(1e-20F, v), v); }
};

} // namespace HWY_NAMESPACE
} // namespace rtcore
HWY_AFTER_NAMESPACE();

#endif
