// Light selection: a point samples one light, with a probability close to its fraction of the unoccluded
// light that arrives there. Included once for each instruction set, inside the loop of foreach_target.h.
#include "rtcore/lights/light_sample-inl.h"
#include "rtcore/pathtracing/light_set.h"
#include "rtcore/sampling/alias-inl.h"

#if defined(RTCORE_PATHTRACING_LIGHT_SELECTION_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef RTCORE_PATHTRACING_LIGHT_SELECTION_INL_H_
#undef RTCORE_PATHTRACING_LIGHT_SELECTION_INL_H_
#else
#define RTCORE_PATHTRACING_LIGHT_SELECTION_INL_H_
#endif

HWY_BEFORE_NAMESPACE();
namespace rtcore {
namespace HWY_NAMESPACE {

/// Fraction of all samples that is spread uniformly over the lights. Guards against bright lights that are
/// occluded.
inline constexpr float kUniformFraction = 0.25F;

/// Unoccluded irradiance from the middle of a light at a surface, as luminance; 0 from below the surface.
template <typename F>
HWY_INLINE F expectedOf(const Light& light, Vec3Of<F> point, Vec3Of<F> normal) {
    return forKind(light.kind, [&]<LightKind kind>() HWY_ATTR {
        const LightSample<F> sample = sampleLight<kind, F>(light, point);
        const F arriving = luminance<F>(sample.irradiance) * max(dot(normal, sample.toLight), F(0));
        return selectOrZero(isFinite(arriving), arriving);
    });
}

template <typename F>
HWY_INLINE F expectedOfEmitters(const LightRows& rows, Vec3Of<F> point) {
    const Vec3Of<F> offset = broadcast<F>(rows.emittersCentre) - point;
    const F arriving = rows.emittersIntensity / max(dot(offset, offset), F(rows.emittersSquare));
    return selectOrZero(isFinite(arriving), arriving);
}

/// The same for `group`, one group for all lanes.
HWY_INLINE Float expectedOfGroup(const LightRows& rows, std::uint32_t group, Float3 point, Float3 normal) {
    if (group < rows.lights) return expectedOf<Float>(rows.light[group], point, normal);
    if (group == rows.emitterGroup()) return expectedOfEmitters<Float>(rows, point);
    return rows.surroundingLight;
}

/// Mixes the fraction of the expected light with a uniform part: the middle says little about a large light
/// and nothing about occluders, and a light with the probability 0 would be missing from the image.
template <typename F>
HWY_INLINE F selectionProbability(const LightRows& rows, F expected, F total) {
    const float each = 1.0F / static_cast<float>(rows.groups());
    const auto some = total > 0.0F;
    return select(some,
                  expected / select(some, total, F(1)) * (1 - kUniformFraction) + kUniformFraction * each,
                  F(each));
}

/// The probability where it is the same at all points (LightRows::fixed).
HWY_INLINE float fixedProbability(const LightRows& rows, std::uint32_t group) {
    return rows.selection.probability[group - (group > rows.emitterGroup() && !rows.emitters ? 1 : 0)];
}

/// The probabilities that a point samples a light, the emitters or the surroundings, where the expected light
/// of all of them is `total`.
template <typename F>
HWY_INLINE F probabilityOfLight(const LightRows& rows, std::uint32_t k, Vec3Of<F> point, Vec3Of<F> normal,
                                F total) {
    if (rows.fixed) return fixedProbability(rows, k);
    return selectionProbability<F>(rows, expectedOf<F>(rows.light[k], point, normal), total);
}
template <typename F>
HWY_INLINE F probabilityOfEmitters(const LightRows& rows, Vec3Of<F> point, F total) {
    if (rows.fixed) return fixedProbability(rows, rows.emitterGroup());
    return selectionProbability<F>(rows, expectedOfEmitters<F>(rows, point), total);
}
template <typename F>
HWY_INLINE F probabilityOfSurroundings(const LightRows& rows, F total) {
    if (rows.fixed) return fixedProbability(rows, rows.surroundingGroup());
    return selectionProbability<F>(rows, F(rows.surroundingLight), total);
}

struct ChosenLight {
    Uint group;
    Float probability;
    Float total; ///< what all are expected to throw
};

/// `bits`: 32 random ones. There is a group.
HWY_INLINE ChosenLight chooseLight(const LightRows& rows, Float3 point, Float3 normal, Uint bits) {
    if (rows.fixed) {
        const Uint index = sampleIndex<Float>(rows.selection, bits);
        const Mask skips = rows.emitters ? noLanes() : index == rows.lights;
        return {select(skips, index + 1U, index), probabilityOf<Float>(rows.selection, index), 0.0F};
    }
    HWY_ALIGN float expected[(LightSet::kMaxWeighed + 2) * kLanes];
    std::uint32_t groups[LightSet::kMaxWeighed + 2];
    std::uint32_t count = 0;
    Float total = 0.0F;
    const auto weigh = [&](std::uint32_t group) HWY_ATTR {
        const Float e = expectedOfGroup(rows, group, point, normal);
        store(e, expected + count * kLanes);
        groups[count++] = group;
        total += e;
    };
    for (std::uint32_t k = 0; k < rows.lights; ++k) weigh(k);
    if (rows.emitters) weigh(rows.emitterGroup());
    if (rows.surroundings) weigh(rows.surroundingGroup());
    const Float u = toFloat(toInt(bits >> 8)) * 0x1p-24F;
    Float before = 0.0F;
    ChosenLight chosen{groups[count - 1], 0.0F, total};
    Mask open = allLanes();
    for (std::uint32_t k = 0; k < count; ++k) {
        const Float p = selectionProbability<Float>(rows, load(expected + k * kLanes), total);
        before += p;
        // The last group takes the remainder that rounding leaves.
        const Mask here = k + 1 < count ? open & (u < before) : open;
        chosen.group = select(here, Uint(groups[k]), chosen.group);
        chosen.probability = select(here, p, chosen.probability);
        open = without(open, here);
    }
    return chosen;
}

} // namespace HWY_NAMESPACE
} // namespace rtcore
HWY_AFTER_NAMESPACE();

#endif
