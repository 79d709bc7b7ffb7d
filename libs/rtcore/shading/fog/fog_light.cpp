#include "rtcore/shading/fog/fog_light.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "rtcore/shading/fog/fog_light.cpp"
#include "rtcore/simd/foreach_target.h"

#include "rtcore/shading/fog/fog_path-inl.h"

#ifndef RTCORE_SHADING_FOG_FOG_LIGHT_TYPES
#define RTCORE_SHADING_FOG_FOG_LIGHT_TYPES
namespace rtcore {

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

/// The q of a block of rays where their stretches begin, pass the light, get thick and end.
struct Panels {
    static constexpr std::size_t kEdges = 4;
    float edge[kEdges][kWaveBlock];
    float change[kWaveBlock]; ///< by how much the logarithm of the light changes on the stretch, at most

    /// The widest of one of the three panels: for all rays alike, so that the bits do not depend on the
    /// length of vectors.
    float width(std::size_t panel) const {
        float max = 0;
        for (std::size_t i = 0; i < kWaveBlock; ++i) {
            const float wide = edge[panel + 1][i] - edge[panel][i];
            max = wide > max ? wide : max;
        }
        return max;
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

/// The integral over q from `a` to `b` of path.light() / r.
template <typename Path>
HWY_INLINE Float panel(const Path& path, const GaussRule& rule, Float a, Float b) {
    const Float middle = fastExp((a + b) * 0.5F);
    const Float half = (b - a) * 0.5F;
    const Float halfApart = path.apart * 0.5F;
    // e^q and e^-q, times half the light's distance from the ray.
    const Float rising = halfApart * middle, falling = halfApart / middle;
    const auto at = [&](Float up, Float down) {
        const Float r = up + down;
        const Float t = max(path.foot + (up - down), 0.0F);
        return path.light(t, r) / r;
    };
    Float sum = 0.0F;
    for (std::size_t k = 0; k < rule.count; ++k) {
        const Float off = fastExp(half * rule.node[k]);
        const Float back = 1.0F / off;
        const Float both = at(rising * back, falling * off) + at(rising * off, falling * back);
        sum = sum + rule.weight[k] * both;
    }
    return sum * half;
}

/// Writes the edges of the panels of a vector of rays, all the same where a ray has none.
template <typename Path>
HWY_INLINE void layPanels(const Path& path, Float from, Float to, Panels& panels, std::size_t i) {
    path.clip(from, to);
    const Mask used = from < to;
    const auto qAt = [&](Float t) { return fastAsinh((t - path.foot) / path.apart); };
    const Float a = selectOrZero(used, qAt(from)), b = selectOrZero(used, qAt(to));
    const Float middle = min(max(Float(0), a), b);
    const Float thick = min(max(qAt(path.thickFrom(to)), middle), b);
    const Float edges[] = {a, middle, selectOrZero(used, thick), b};
    for (std::size_t k = 0; k < Panels::kEdges; ++k) store(edges[k], panels.edge[k] + i);
    store(selectOrZero(used, path.change(from, to)), panels.change + i);
}

template <bool exponential, Beam beam>
HWY_INLINE void addLocalAll(const FogMedium& medium, const Light& light, const FogRays& a) {
    const Float3 scale = broadcast(light.intensity * medium.scattered * medium.density);
    const auto pathAt = [&](std::size_t i) {
        return LightPath<exponential, beam>(medium, light, loadAt(a.origin, i), loadAt(a.direction, i));
    };
    for (std::size_t block = 0; block < a.count; block += kWaveBlock) {
        Panels panels;
        for (std::size_t i = 0; i < kWaveBlock; i += lanes()) {
            const std::size_t at = block + i;
            layPanels(pathAt(at), load(a.from + at), load(a.to + at), panels, i);
        }
        const bool changes = exponential && panels.changeMuch();
        for (std::size_t k = 0; k + 1 < Panels::kEdges; ++k) {
            const float width = panels.width(k);
            if (!(width > 0)) continue;
            const GaussRule& rule = ruleFor(width, changes);
            for (std::size_t i = 0; i < kWaveBlock; i += lanes()) {
                const Float start = load(panels.edge[k] + i);
                const Float end = load(panels.edge[k + 1] + i);
                if (none(start < end)) continue;
                const std::size_t at = block + i;
                const Float part = selectOrZero(start < end, panel(pathAt(at), rule, start, end));
                storeAt(loadAt(a.scattered, at) + scale * part, a.scattered, at);
            }
        }
    }
}

/// With s the length of fog up to a point of the ray (fogLength()), the depth of both ways is
/// deepest + extinction * s * (1 - dz / lz): dz and lz are what the ray and the way to the light rise.
template <bool exponential>
HWY_INLINE void addSunAll(const FogMedium& medium, const Light& light, const FogRays& a) {
    const Float3 scale = broadcast(light.intensity * medium.scattered);
    const float rise = -dot(medium.up, light.direction);
    if (exponential && !(rise > 1e-6F)) return;
    for (std::size_t i = 0; i < a.count; i += lanes()) {
        const Float distance = load(a.distance + i);
        Float weight;
        if constexpr (exponential) {
            const Float height = fogHeight<Float>(medium, loadAt(a.origin, i));
            const Float own = dot(broadcast(medium.up), loadAt(a.direction, i));
            const Float tau =
                medium.density * exponentialLength<Float>(height, own * medium.perHeight, distance);
            const Float toLight = medium.density * fastExp(-height) / (rise * medium.perHeight);
            const Float factor = 1.0F - own / rise;
            // tau (1 - e^-x) / x e^-toLight, x = tau factor; by the end that is less deep where x < 0
            const Float x = tau * factor;
            const Float depth = toLight + min(x, 0.0F);
            const Float size = abs(x);
            const Float spread = select(size < 0.25F, tau * meanDecaySeries(min(size, 0.25F)),
                                        (1.0F - fastExp(-size)) / abs(factor));
            weight = spread * fastExp(-max(depth, 0.0F));
        } else {
            weight = fogOpacity(medium.density * distance);
        }
        storeAt(loadAt(a.scattered, i) + scale * weight, a.scattered, i);
    }
}

template <bool exponential>
HWY_INLINE void addAll(const FogMedium& medium, const Light& light, const FogRays& a) {
    if (!traitsOf(light).position) return addSunAll<exponential>(medium, light, a);
    forBeam(traitsOf(light).beam,
            [&]<Beam beam>() HWY_ATTR { addLocalAll<exponential, beam>(medium, light, a); });
}

void addLight(const FogMedium& medium, const Light& light, const FogRays& a) {
    medium.exponential ? addAll<true>(medium, light, a) : addAll<false>(medium, light, a);
}

} // namespace HWY_NAMESPACE
} // namespace rtcore
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace rtcore {

HWY_EXPORT(addLight);

void addFogLight(const FogWave& fog, const Light& light) {
    HWY_DYNAMIC_DISPATCH(addLight)(fog.medium(), light, fog.rays());
}

} // namespace rtcore
#endif
