// Light selection: a point samples one light, with a probability close to its fraction of the unoccluded
// light that arrives there. Included once for each instruction set, inside the loop of foreach_target.h.
#include "rtcore/lights/light_sample-inl.h"
#include "rtcore/lights/light_tree-inl.h"
#include "rtcore/pathtracing/light_set.h"
#include "rtcore/pathtracing/visibility_cache-inl.h"

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
inline constexpr float kUniformFraction = 0.05F;

/// Unoccluded irradiance from the middle of a light at a surface, as luminance; 0 from below the surface.
template <typename F>
HWY_INLINE F expectedOf(const Light& light, Vec3Of<F> point, Vec3Of<F> normal) {
    return forKind(light.kind, [&]<LightKind kind>() HWY_ATTR {
        const LightSample<F> sample = sampleLight<kind, F>(light, point);
        const F arriving = luminance<F>(sample.irradiance) * max(dot(normal, sample.toLight), F(0));
        return selectOrZero(isFinite(arriving), arriving);
    });
}

/// The light of a candidate (LightRows), as far as it is known to arrive in that cell.
template <typename F>
HWY_INLINE F arrivingOf(const LightRows& rows, std::uint32_t candidate, F unhindered, UintOf<F> cell) {
    return rows.visible.known() ? unhindered * visiblePart<F>(rows.visible, candidate, cell) : unhindered;
}
template <typename F>
HWY_INLINE F expectedOfSurroundings(const LightRows& rows, UintOf<F> cell) {
    if (!rows.visible.known()) return F(rows.surroundingLight);
    return gather(rows.visible.surroundings, toInt(cell));
}

template <typename F>
HWY_INLINE F expectedOfEmitters(const LightRows& rows, Vec3Of<F> point) {
    const Vec3Of<F> offset = broadcast<F>(rows.emittersCentre) - point;
    const F arriving = rows.emittersIntensity / max(dot(offset, offset), F(rows.emittersSquare));
    return selectOrZero(isFinite(arriving), arriving);
}

/// Where scattered rays from `point` are to meet the light, and next event shares it with them.
HWY_INLINE Mask raysMeet(const LightRows& rows, const Light& light, Float3 point) {
    if (!rows.byTree() || !isAreaLight(light.kind)) return Uint(0U) == Uint(0U);
    return isWithin(point, light.position, reachOf(light));
}

/// The same of a node in the cut of a tree.
template <typename F>
HWY_INLINE F expectedOfCut(const LightTreeRows& tree, std::uint32_t c, Vec3Of<F> point, Vec3Of<F> normal) {
    return expectedOfNode<F>(tree.directed, broadcastNode<F>(tree.nodes[tree.cut[c]]), point, normal);
}
/// Of the tree of lights, where one light is weighed by itself.
template <typename F>
HWY_INLINE F expectedOfCut(const LightRows& rows, std::uint32_t c, Vec3Of<F> point, Vec3Of<F> normal) {
    const LightNode& node = rows.tree.nodes[rows.tree.cut[c]];
    if ((node.kind & light_node::kLeaf) != 0) return expectedOf<F>(rows.light[node.next], point, normal);
    return expectedOfCut<F>(rows.tree, c, point, normal);
}

/// Mixes the fraction of the expected light with a uniform part: the middle says little about a large light
/// and nothing about occluders, and a light with the probability 0 would be missing from the image.
template <typename F>
HWY_INLINE F selectionProbability(const LightRows& rows, F expected, F total) {
    const float each = 1.0F / static_cast<float>(rows.candidates());
    const auto some = total > 0.0F;
    return select(some,
                  expected / select(some, total, F(1)) * (1 - kUniformFraction) + kUniformFraction * each,
                  F(each));
}

/// The probabilities that a point of that cell samples a light, the emitters or the surroundings, where the
/// expected light of all of them is `total`.
template <typename F>
HWY_INLINE F probabilityOfLight(const LightRows& rows, std::uint32_t k, Vec3Of<F> point, Vec3Of<F> normal,
                                UintOf<F> cell, F total) {
    const std::uint32_t c = rows.byTree() ? rows.tree.cutOf[k] : k;
    const F unhindered = rows.byTree() ? expectedOfCut<F>(rows, c, point, normal)
                                       : expectedOf<F>(rows.light[k], point, normal);
    const F probability = selectionProbability<F>(rows, arrivingOf<F>(rows, c, unhindered, cell), total);
    return rows.byTree() ? probability * probabilityOfLeaf<F>(rows.tree, k, point, normal) : probability;
}
/// Of a cluster of emitters; of all of them without a tree.
template <typename F>
HWY_INLINE F probabilityOfEmitters(const LightRows& rows, std::uint32_t cluster, Vec3Of<F> point,
                                   Vec3Of<F> normal, UintOf<F> cell, F total) {
    const LightTreeRows& tree = rows.emitterTree;
    const std::uint32_t c = rows.emittersByTree() ? tree.cutOf[cluster] : 0;
    const F unhindered =
        rows.emittersByTree() ? expectedOfCut<F>(tree, c, point, normal) : expectedOfEmitters<F>(rows, point);
    const F arriving = arrivingOf<F>(rows, rows.lightCandidates() + c, unhindered, cell);
    const F probability = selectionProbability<F>(rows, arriving, total);
    return rows.emittersByTree() ? probability * probabilityOfLeaf<F>(tree, cluster, point, normal)
                                 : probability;
}
template <typename F>
HWY_INLINE F probabilityOfSurroundings(const LightRows& rows, UintOf<F> cell, F total) {
    return selectionProbability<F>(rows, expectedOfSurroundings<F>(rows, cell), total);
}

struct ChosenLight {
    Uint group;
    Uint cluster; ///< of emitters
    Uint cell;    ///< of the point, where visibility is known
    Float probability;
    Float total; ///< what all are expected to throw
};

/// `bits`, `more`: 32 random ones each. There is a group.
HWY_INLINE ChosenLight chooseLight(const LightRows& rows, Float3 point, Float3 normal, Uint bits, Uint more) {
    HWY_ALIGN float expected[LightSet::kMaxCandidates * kLanes];
    std::uint32_t groups[LightSet::kMaxCandidates]; // of a tree: nodes of its cut
    std::uint32_t count = 0;
    Float total = 0.0F;
    const Uint cell = rows.visible.known() ? cellOf<Float>(rows.visible, point, normal) : Uint(0U);
    const auto weigh = [&](std::uint32_t group, Float e) HWY_ATTR {
        store(e, expected + count * kLanes);
        groups[count++] = group;
        total += e;
    };
    const auto weighKnown = [&](std::uint32_t group, Float unhindered)
                                HWY_ATTR { weigh(group, arrivingOf<Float>(rows, count, unhindered, cell)); };
    if (rows.byTree()) {
        for (std::uint32_t c = 0; c < rows.tree.cuts; ++c)
            weighKnown(rows.tree.cut[c], expectedOfCut<Float>(rows, c, point, normal));
    } else {
        for (std::uint32_t k = 0; k < rows.lights; ++k)
            weighKnown(k, expectedOf<Float>(rows.light[k], point, normal));
    }
    const std::uint32_t ofLights = count;
    if (rows.emittersByTree()) {
        for (std::uint32_t c = 0; c < rows.emitterTree.cuts; ++c)
            weighKnown(rows.emitterTree.cut[c], expectedOfCut<Float>(rows.emitterTree, c, point, normal));
    } else if (rows.emitters) {
        weighKnown(rows.emitterGroup(), expectedOfEmitters<Float>(rows, point));
    }
    const std::uint32_t ofEmitters = count;
    if (rows.surroundings) weigh(rows.surroundingGroup(), expectedOfSurroundings<Float>(rows, cell));
    const Float u = toFloat(toInt(bits >> 8)) * 0x1p-24F;
    Float before = 0.0F;
    ChosenLight chosen{groups[count - 1], Uint(0U), cell, 0.0F, total};
    Mask open = allLanes(), light = noLanes(), emitter = noLanes();
    for (std::uint32_t k = 0; k < count; ++k) {
        const Float p = selectionProbability<Float>(rows, load(expected + k * kLanes), total);
        before += p;
        // The last group takes the remainder that rounding leaves.
        const Mask here = k + 1 < count ? open & (u < before) : open;
        chosen.group = select(here, Uint(groups[k]), chosen.group);
        chosen.probability = select(here, p, chosen.probability);
        open = without(open, here);
        if (k < ofLights) {
            light = light | here;
        } else if (k < ofEmitters) {
            emitter = emitter | here;
        }
    }
    const Float v = toFloat(toInt(more >> 8)) * 0x1p-24F;
    const auto leafOf = [&](const LightTreeRows& tree, Mask lanes) HWY_ATTR {
        const ChosenLeaf leaf =
            chooseLeaf(tree, select(lanes, chosen.group, Uint(0U)), lanes, point, normal, v);
        chosen.probability = chosen.probability * leaf.probability;
        return leaf.light;
    };
    if (rows.byTree()) chosen.group = select(light, leafOf(rows.tree, light), chosen.group);
    if (rows.emittersByTree()) {
        chosen.cluster = leafOf(rows.emitterTree, emitter);
        chosen.group = select(emitter, Uint(rows.emitterGroup()), chosen.group);
    }
    return chosen;
}

} // namespace HWY_NAMESPACE
} // namespace rtcore
HWY_AFTER_NAMESPACE();

#endif
