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
struct GaussRule {
    std::size_t count;
    float node[6], weight[6];
};
inline constexpr GaussRule kRules[] = {
    {2, {0.3399810435848563F, 0.8611363115940526F}, {0.6521451548625461F, 0.3478548451374538F}},
    {3,
     {0.2386191860831969F, 0.6612093864662645F, 0.9324695142031521F},
     {0.4679139345726910F, 0.3607615730481386F, 0.1713244923791704F}},
    {4,
     {0.1834346424956498F, 0.5255324099163290F, 0.7966664774136267F, 0.9602898564975363F},
     {0.3626837833783620F, 0.3137066458778873F, 0.2223810344533745F, 0.1012285362903763F}},
    {6,
     {0.1252334085114689F, 0.3678314989981802F, 0.5873179542866175F, 0.7699026741943047F, 0.9041172563704749F,
      0.9815606342467192F},
     {0.2491470458134028F, 0.2334925365383548F, 0.2031674267230659F, 0.1600783285433462F, 0.1069393259953184F,
      0.0471753363865118F}}};

/// As many nodes as a panel over so much of q needs; more where exponential fog changes much on it.
inline const GaussRule& ruleFor(float width, bool changes) {
    const std::size_t rule = width <= 1.5F ? 0 : width <= 3 ? 1 : width <= 5 ? 2 : 3;
    return kRules[changes ? (rule < 2 ? rule + 1 : 3) : rule];
}

/// The q of a block of rays where their stretches begin, pass the lamp, get thick and end.
struct Panels {
    static constexpr std::size_t kEdges = 4;
    float edge[kEdges][kWaveBlock];
    float change[kWaveBlock]; ///< by how much the logarithm of the light changes on the stretch, at most

    /// The widest of one of the three panels: for all rays alike, so that the bits do not depend on the
    /// length of vectors.
    float width(std::size_t panel) const {
        float most = 0;
        for (std::size_t i = 0; i < kWaveBlock; ++i) {
            const float wide = edge[panel + 1][i] - edge[panel][i];
            most = wide > most ? wide : most;
        }
        return most;
    }
    bool changeMuch() const {
        for (const float c : change) {
            if (c > 4) return true;
        }
        return false;
    }
};

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
HWY_INLINE Floats panel(const Path& path, const GaussRule& rule, Floats a, Floats b) {
    const Floats middle = expOf(hn::Mul(hn::Add(a, b), constant(0.5F)));
    const Floats half = hn::Mul(hn::Sub(b, a), constant(0.5F));
    const Floats halfApart = hn::Mul(path.apart, constant(0.5F));
    // e^q and e^-q, times half the lamp's distance from the ray.
    const Floats rising = hn::Mul(halfApart, middle), falling = hn::Div(halfApart, middle);
    const auto at = [&](Floats up, Floats down) {
        const Floats r = hn::Add(up, down);
        const Floats t = larger(hn::Add(path.foot, hn::Sub(up, down)), constant(0));
        return hn::Div(path.light(t, r), r);
    };
    Floats sum = constant(0);
    for (std::size_t k = 0; k < rule.count; ++k) {
        const Floats off = expOf(hn::Mul(half, constant(rule.node[k])));
        const Floats back = hn::Div(constant(1), off);
        const Floats both = hn::Add(at(hn::Mul(rising, back), hn::Mul(falling, off)),
                                    at(hn::Mul(rising, off), hn::Mul(falling, back)));
        sum = hn::Add(sum, hn::Mul(constant(rule.weight[k]), both));
    }
    return hn::Mul(sum, half);
}

/// Writes the edges of the panels of a vector of rays, all the same where a ray has none.
template <typename Path>
HWY_INLINE void layPanels(const Path& path, Floats from, Floats to, Panels& panels, std::size_t i) {
    const FloatTag d;
    path.clip(from, to);
    const Lanes used = hn::Lt(from, to);
    const auto place = [&](Floats t) { return inverseSinh(hn::Div(hn::Sub(t, path.foot), path.apart)); };
    const Floats a = hn::IfThenElseZero(used, place(from)), b = hn::IfThenElseZero(used, place(to));
    const Floats middle = smaller(larger(hn::Zero(d), a), b);
    const Floats thick = smaller(larger(place(path.thickFrom(to)), middle), b);
    const Floats edges[] = {a, middle, hn::IfThenElseZero(used, thick), b};
    for (std::size_t k = 0; k < Panels::kEdges; ++k) hn::StoreU(edges[k], d, panels.edge[k] + i);
    hn::StoreU(hn::IfThenElseZero(used, path.change(from, to)), d, panels.change + i);
}

template <bool exponential, Beam beam>
HWY_INLINE void addLampAll(const FogMedium& medium, const Light& light, const LampArrays& a) {
    const FloatTag d;
    const Colour colour = light.intensity * medium.scattered * medium.density;
    const Vectors scale = constant(colour.r, colour.g, colour.b);
    const auto pathAt = [&](std::size_t i) {
        return LampPath<exponential, beam>(
            medium, light, loadVectors(a.origin.x + i, a.origin.y + i, a.origin.z + i),
            loadVectors(a.direction.x + i, a.direction.y + i, a.direction.z + i));
    };
    for (std::size_t block = 0; block < a.count; block += kWaveBlock) {
        Panels panels;
        for (std::size_t i = 0; i < kWaveBlock; i += hn::Lanes(d)) {
            const std::size_t at = block + i;
            layPanels(pathAt(at), hn::LoadU(d, a.from + at), hn::LoadU(d, a.to + at), panels, i);
        }
        const bool changes = exponential && panels.changeMuch();
        for (std::size_t k = 0; k + 1 < Panels::kEdges; ++k) {
            const float width = panels.width(k);
            if (!(width > 0)) continue;
            const GaussRule& rule = ruleFor(width, changes);
            for (std::size_t i = 0; i < kWaveBlock; i += hn::Lanes(d)) {
                const Floats start = hn::LoadU(d, panels.edge[k] + i);
                const Floats end = hn::LoadU(d, panels.edge[k + 1] + i);
                if (hn::AllFalse(d, hn::Lt(start, end))) continue;
                const std::size_t at = block + i;
                const Floats part = panel(pathAt(at), rule, start, end);
                const Vectors old = loadVectors(a.scattered.x + at, a.scattered.y + at, a.scattered.z + at);
                const Vectors sum = old + scale * hn::IfThenElseZero(hn::Lt(start, end), part);
                storeVectors(sum, a.scattered.x + at, a.scattered.y + at, a.scattered.z + at);
            }
        }
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
