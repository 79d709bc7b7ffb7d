#include "rtcore/io/text/pattern.h"
#include "rtcore/io/variants/material_words.h"
#include "rtcore/io/variants/variant_switch.h"
#include "rtcore/sky/scene_sky.h"

#include <algorithm>
#include <functional>
#include <set>
#include <utility>

namespace rtcore {

namespace {

using Wanted = std::function<bool(std::size_t)>;

/// Of the materials that are `wanted`.
std::vector<MaterialOverride> materialsOf(const Scene& base, const Scene& shown, const Wanted& wanted) {
    std::vector<MaterialOverride> all;
    for (std::size_t i = 0; i < shown.materials.size(); ++i) {
        if (!wanted(i)) continue;
        const auto edit =
            std::ranges::find(shown.materialEdits, static_cast<int>(i) + 1,
                              [](const MaterialOverride& each) { return each.number.value_or(0); });
        MaterialOverride change = changeBetween(shown.model, base.materials[i], shown.materials[i],
                                                edit != shown.materialEdits.end() ? &*edit : nullptr);
        change.number = static_cast<int>(i) + 1;
        nameMaterial(shown, i, change);
        all.push_back(std::move(change));
    }
    return all;
}

std::vector<PartDescription> partsOf(const Scene& shown, const std::vector<NamedPart>& parts,
                                     const Wanted& wanted) {
    std::vector<PartDescription> all;
    for (std::size_t i = 0; i < parts.size(); ++i) {
        if (!wanted(i)) continue;
        PartDescription part{.pattern = std::string(parts[i].name), .number = {}};
        part.hidden = isIn(parts[i], shown.hiddenParts);
        if (part.pattern.empty() || isPattern(part.pattern)) {
            part.pattern.clear();
            part.number = static_cast<int>(i) + 1;
        }
        all.push_back(std::move(part));
    }
    return all;
}

/// The base with the surroundings that `variant` has, if any.
VariantScene baseWith(const VariantScene& base, const SceneVariant& variant) {
    VariantScene with = base;
    if (variant.surroundings) putSurroundings(with, *variant.surroundings);
    return with;
}

void sayLight(const Scene& shown, int id, SceneVariant& variant) {
    if (const auto at = lightWithId(shown, id))
        variant.lights.push_back(describeLight(shown, *at));
    else
        variant.removedLights.push_back(id);
}

bool sameLight(const Scene& a, const Scene& b, int id) {
    const auto inA = lightWithId(a, id), inB = lightWithId(b, id);
    if (!inA || !inB) return !inA && !inB;
    return describeLight(a, *inA) == describeLight(b, *inB);
}

std::set<int> idsOf(const Scene& a, const Scene& b) {
    std::set<int> ids;
    for (const Scene* const scene : {&a, &b})
        for (const SceneLight& each : scene->lights) ids.insert(each.notes.id);
    return ids;
}

} // namespace

SceneVariant differences(const VariantScene& base, const VariantScene& shown) {
    const Scene &before = base.scene, &now = shown.scene;
    SceneVariant variant;
    variant.materials = materialsOf(
        before, now, [&](std::size_t i) { return !looksAs(before.materials[i], now.materials[i]); });
    const std::vector<NamedPart> parts = namedParts(now.model);
    variant.parts = partsOf(now, parts, [&](std::size_t i) {
        return isIn(parts[i], before.hiddenParts) != isIn(parts[i], now.hiddenParts);
    });
    if (surroundingsOf(base) != surroundingsOf(shown)) variant.surroundings = surroundingsOf(shown);
    const VariantScene with = baseWith(base, variant);
    for (const int id : idsOf(with.scene, now))
        if (!sameLight(with.scene, now, id)) sayLight(now, id, variant);
    return variant;
}

SceneVariant updated(const SceneVariant& variant, const VariantScene& base, const VariantScene& shown) {
    const Scene& now = shown.scene;
    SceneVariant result{.name = variant.name};
    result.materials = materialsOf(base.scene, now, [&](std::size_t i) {
        return std::ranges::any_of(variant.materials, [&](const auto& each) { return isFor(each, now, i); });
    });
    const std::vector<NamedPart> parts = namedParts(now.model);
    result.parts = partsOf(now, parts, [&](std::size_t i) {
        return std::ranges::any_of(variant.parts, [&](const auto& each) { return isFor(each, parts[i], i); });
    });
    std::set<int> ids(variant.removedLights.begin(), variant.removedLights.end());
    for (const LightDescription& each : variant.lights) ids.insert(each.id);
    if (variant.surroundings) {
        result.surroundings = surroundingsOf(shown);
        const VariantScene with = baseWith(base, result);
        for (const int sun : {variant.surroundings->sunId, result.surroundings->sunId})
            if (sun != 0 && !sameLight(with.scene, now, sun)) ids.insert(sun);
    }
    for (const int id : ids) sayLight(now, id, result);
    return result;
}

} // namespace rtcore
