// Lamps in fog: what reaches a ray of their light, unshadowed.
#include "rtcore/shading/fog_wave.h"

#include "rtcore/platform/vector_targets.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "rtcore/shading/fog_light.cpp"
#include <hwy/foreach_target.h>
// The loop over targets comes before the code that is compiled for each of them.
#include "rtcore/shading/fog_path-inl.h"

#ifndef RTCORE_SHADING_FOG_LIGHT_TYPES
#define RTCORE_SHADING_FOG_LIGHT_TYPES
namespace rtcore {

/// Arrays of FogWave.
struct LampArrays {
    std::size_t count;
    ArraysOf3 origin, direction;
    const float *from, *to, *distance;
    ArraysOf3 scattered;
};

/// The positive half of the nodes of Gauss and Legendre, and their weights.
inline constexpr float kNodes[kFogNodes / 2] = {0.1252334085114689F, 0.3678314989981802F,
                                                0.5873179542866175F, 0.7699026741943047F,
                                                0.9041172563704749F, 0.9815606342467192F};
inline constexpr float kWeights[kFogNodes / 2] = {0.2491470458134028F, 0.2334925365383548F,
                                                  0.2031674267230659F, 0.1600783285433462F,
                                                  0.1069393259953184F, 0.0471753363865118F};

} // namespace rtcore
#endif

HWY_BEFORE_NAMESPACE();
namespace rtcore {
namespace HWY_NAMESPACE {

HWY_INLINE Floats inverseSinh(Floats x) {
    // Beyond, distances are without meaning.
    const Floats size = smaller(hn::Abs(x), constant(1e15F));
    const Floats high = logOf(hn::Add(size, hn::Sqrt(hn::Add(hn::Mul(size, size), constant(1)))));
    // x - x^3 / 6 + 3 x^5 / 40
    const Floats square = hn::Mul(size, size);
    static constexpr float kSeries[] = {1, -1.0F / 6, 3.0F / 40};
    const Floats low = hn::Mul(size, polynomial(kSeries, square));
    return hn::CopySign(hn::IfThenElse(hn::Lt(size, constant(0.05F)), low, high), x);
}

/// The integral over q from `a` to `b` of path.light() / r.
template <typename Path>
HWY_INLINE Floats panel(const Path& path, Floats a, Floats b) {
    const Floats middle = hn::Mul(hn::Add(a, b), constant(0.5F));
    const Floats half = hn::Mul(hn::Sub(b, a), constant(0.5F));
    const Floats halfApart = hn::Mul(path.apart, constant(0.5F));
    const auto at = [&](Floats q) {
        const Floats e = expOf(q);
        const Floats inverse = hn::Div(constant(1), e);
        const Floats t = hn::Add(path.foot, hn::Mul(halfApart, hn::Sub(e, inverse)));
        const Floats r = hn::Mul(halfApart, hn::Add(e, inverse));
        return hn::Div(path.light(larger(t, constant(0)), r), r);
    };
    Floats sum = constant(0);
    for (std::size_t k = 0; k < kFogNodes / 2; ++k) {
        const Floats off = hn::Mul(half, constant(kNodes[k]));
        const Floats both = hn::Add(at(hn::Sub(middle, off)), at(hn::Add(middle, off)));
        sum = hn::Add(sum, hn::Mul(constant(kWeights[k]), both));
    }
    return hn::Mul(sum, half);
}

/// The integral over the ray of path.light() / r^2.
template <typename Path>
HWY_INLINE Floats integral(const Path& path, Floats from, Floats to) {
    const FloatTag d;
    path.clip(from, to);
    const Lanes used = hn::Lt(from, to);
    if (hn::AllFalse(d, used)) return hn::Zero(d);
    const Floats a = inverseSinh(hn::Div(hn::Sub(from, path.foot), path.apart));
    const Floats b = inverseSinh(hn::Div(hn::Sub(to, path.foot), path.apart));
    const Floats middle = smaller(larger(constant(0), a), b);
    Floats sum = hn::Zero(d);
    const auto add = [&](Floats start, Floats end) {
        if (!hn::AllFalse(d, hn::Lt(start, end))) sum = hn::Add(sum, panel(path, start, end));
    };
    add(a, middle);
    const Floats last =
        larger(inverseSinh(hn::Div(hn::Sub(path.thickFrom(to), path.foot), path.apart)), middle);
    add(middle, last);
    add(last, b);
    return hn::IfThenElseZero(used, sum);
}

template <bool exponential, Beam beam>
HWY_INLINE void addLampAll(const FogMedium& medium, const Light& light, const LampArrays& a) {
    const FloatTag d;
    const Colour colour = light.intensity * medium.scattered * medium.density;
    const Vectors scale = constant(colour.r, colour.g, colour.b);
    for (std::size_t i = 0; i < a.count; i += hn::Lanes(d)) {
        const Floats from = hn::LoadU(d, a.from + i), to = hn::LoadU(d, a.to + i);
        if (hn::AllFalse(d, hn::Lt(from, to))) continue;
        const LampPath<exponential, beam> path(
            medium, light, loadVectors(a.origin.x + i, a.origin.y + i, a.origin.z + i),
            loadVectors(a.direction.x + i, a.direction.y + i, a.direction.z + i));
        const Vectors old = loadVectors(a.scattered.x + i, a.scattered.y + i, a.scattered.z + i);
        const Vectors sum = old + scale * integral(path, from, to);
        storeVectors(sum, a.scattered.x + i, a.scattered.y + i, a.scattered.z + i);
    }
}

/// With s the length of fog up to a point of the ray (fogLength()), the depth of both ways is
/// deepest + extinction * s * (1 - dz / lz): dz and lz are what the ray and the way to the lamp rise.
template <bool exponential>
HWY_INLINE void addSunAll(const FogMedium& medium, const Light& light, const LampArrays& a) {
    const FloatTag d;
    const VectorFog fog(medium);
    const Colour colour = light.intensity * medium.scattered;
    const Vectors scale = constant(colour.r, colour.g, colour.b);
    const float rise = -dot(medium.up, light.direction);
    if (exponential && !(rise > 1e-6F)) return;
    for (std::size_t i = 0; i < a.count; i += hn::Lanes(d)) {
        const Floats distance = hn::LoadU(d, a.distance + i);
        Floats share;
        if constexpr (exponential) {
            const Floats height = fog.height(loadVectors(a.origin.x + i, a.origin.y + i, a.origin.z + i));
            const Vectors direction = loadVectors(a.direction.x + i, a.direction.y + i, a.direction.z + i);
            const Floats own = dot(fog.up, direction);
            const Floats tau =
                hn::Mul(fog.density, exponentialLength(height, hn::Mul(own, fog.perHeight), distance));
            const Floats toLamp =
                hn::Div(hn::Mul(fog.density, expOf(hn::Neg(height))), constant(rise * medium.perHeight));
            const Floats factor = hn::Sub(constant(1), hn::Div(own, constant(rise)));
            // tau (1 - e^-x) / x e^-toLamp, x = tau factor; by the end that is less deep where x < 0
            const Floats x = hn::Mul(tau, factor);
            const Floats depth = hn::Add(toLamp, smaller(x, constant(0)));
            const Floats size = hn::Abs(x);
            const Floats spread = hn::IfThenElse(
                hn::Lt(size, constant(0.25F)), hn::Mul(tau, meanDecaySeries(smaller(size, constant(0.25F)))),
                hn::Div(hn::Sub(constant(1), expOf(hn::Neg(size))), hn::Abs(factor)));
            share = hn::Mul(spread, expOf(hn::Neg(larger(depth, constant(0)))));
        } else {
            share = opacityOf(hn::Mul(fog.density, distance));
        }
        const Vectors old = loadVectors(a.scattered.x + i, a.scattered.y + i, a.scattered.z + i);
        storeVectors(old + scale * share, a.scattered.x + i, a.scattered.y + i, a.scattered.z + i);
    }
}

template <bool exponential>
HWY_INLINE void addAll(const FogMedium& medium, const Light& light, const LampArrays& a) {
    switch (light.kind) {
    case LightKind::Directional:
        return addSunAll<exponential>(medium, light, a);
    case LightKind::Spot:
        return addLampAll<exponential, Beam::Cone>(medium, light, a);
    case LightKind::Rectangle:
        return addLampAll<exponential, Beam::Cosine>(medium, light, a);
    default:
        return addLampAll<exponential, Beam::Even>(medium, light, a);
    }
}

void addLamp(const FogMedium& medium, const Light& light, const LampArrays& a) {
    medium.exponential ? addAll<true>(medium, light, a) : addAll<false>(medium, light, a);
}

} // namespace HWY_NAMESPACE
} // namespace rtcore
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace rtcore {

HWY_EXPORT(addLamp);

void FogWave::addLight(const Light& light) {
    HWY_DYNAMIC_DISPATCH(addLamp)
    (medium_, light, {size_, origin_, direction_, from_, to_, distance_, scattered_});
}

} // namespace rtcore
#endif
