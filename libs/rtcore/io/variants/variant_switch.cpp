#include "rtcore/io/variants/variant_switch.h"

#include "rtcore/io/text/pattern.h"
#include "rtcore/io/variants/material_words.h"
#include "rtcore/scene/material_edit.h"
#include "rtcore/sky/scene_sky.h"

#include <algorithm>
#include <initializer_list>
#include <set>
#include <utility>

namespace rtcore {

namespace {

using Variants = std::initializer_list<const SceneVariant*>;

// --- Materials ---

std::vector<MaterialOverride>::const_iterator editAt(const Scene& scene, std::size_t index) {
    return std::ranges::find(scene.materialEdits, static_cast<int>(index) + 1,
                             [](const MaterialOverride& each) { return each.number.value_or(0); });
}

void putEdit(Scene& scene, MaterialOverride edit) {
    const auto at = std::ranges::lower_bound(scene.materialEdits, *edit.number, {},
                                             [](const MaterialOverride& each) { return *each.number; });
    scene.materialEdits.insert(at, std::move(edit));
}

void takeBaseMaterial(Scene& scene, const Scene& base, std::size_t index) {
    scene.materials[index] = base.materials[index];
    if (const auto edit = editAt(scene, index); edit != scene.materialEdits.end())
        scene.materialEdits.erase(edit);
    if (const auto edit = editAt(base, index); edit != base.materialEdits.end()) putEdit(scene, *edit);
}

/// The one that the base has is known to be there.
void changeMaterial(Scene& scene, std::size_t index, const MaterialOverride& change) {
    scene.materials[index] = changedMaterial(scene.model, scene.materials[index], change);
    MaterialOverride edit;
    edit.number = static_cast<int>(index) + 1;
    if (const auto now = editAt(scene, index); now != scene.materialEdits.end()) {
        edit = *now;
        scene.materialEdits.erase(now);
    }
    edit.add(change);
    putEdit(scene, std::move(edit));
}

void switchMaterials(Scene& scene, const Scene& base, const SceneVariant& from, const SceneVariant& to) {
    const std::vector<Material> before = scene.materials;
    for (std::size_t i = 0; i < scene.materials.size(); ++i) {
        const auto names = [&](const SceneVariant& variant) {
            return std::ranges::any_of(variant.materials,
                                       [&](const auto& each) { return isFor(each, scene, i); });
        };
        if (!names(from) && !names(to)) continue;
        takeBaseMaterial(scene, base, i);
        for (const MaterialOverride& each : to.materials)
            if (each.changes() && isFor(each, scene, i)) changeMaterial(scene, i, each);
    }
    closeSurfaces(scene, before);
}

// --- Parts ---

void switchParts(Scene& scene, const Scene& base, const SceneVariant& from, const SceneVariant& to) {
    if (from.parts.empty() && to.parts.empty()) return;
    const std::vector<NamedPart> parts = namedParts(scene.model);
    std::vector<std::uint8_t> hide(parts.size()), show(parts.size());
    for (std::size_t i = 0; i < parts.size(); ++i) {
        std::optional<bool> hidden;
        for (const PartDescription& each : from.parts)
            if (isFor(each, parts[i], i)) hidden = isIn(parts[i], base.hiddenParts);
        for (const PartDescription& each : to.parts)
            if (isFor(each, parts[i], i)) hidden = each.hidden;
        if (hidden) (*hidden ? hide : show)[i] = 1;
    }
    scene.hiddenParts = withParts(scene.model, parts, hide, true, scene.hiddenParts);
    scene.hiddenParts = withParts(scene.model, parts, show, false, scene.hiddenParts);
}

// --- Lights ---

/// With the lights of their skies, whose numbers other lights of the base may have.
std::set<int> lightsIn(Variants variants) {
    std::set<int> ids;
    for (const SceneVariant* const each : variants) {
        for (const LightDescription& light : each->lights) ids.insert(light.id);
        ids.insert(each->removedLights.begin(), each->removedLights.end());
        if (each->surroundings && each->surroundings->sunId != 0) ids.insert(each->surroundings->sunId);
    }
    return ids;
}

void eraseLights(Scene& scene, const std::set<int>& ids, bool sun) {
    std::erase_if(scene.lights, [&](const SceneLight& each) {
        return ids.contains(each.notes.id) && (sun || !each.ofSky);
    });
    if (!ids.empty()) scene.removedLightId = std::max(scene.removedLightId, *ids.rbegin());
}

/// Those of the base that no variant has by now. Its sun is there already, or its sky is not.
void takeBaseLights(Scene& scene, const Scene& base, const std::set<int>& ids) {
    for (const SceneLight& each : base.lights) {
        if (!ids.contains(each.notes.id)) continue;
        const auto at = lightWithId(scene, each.notes.id);
        if (at && each.ofSky == scene.lights[*at].ofSky)
            scene.lights[*at] = each;
        else if (!at && !each.ofSky)
            scene.lights.push_back(each);
    }
}

void putLights(Scene& scene, const SceneVariant& to) {
    for (const LightDescription& each : to.lights)
        putLight(scene, lightWithId(scene, each.id).value_or(scene.lights.size()), each);
    eraseLights(scene, {to.removedLights.begin(), to.removedLights.end()}, true);
}

int sunIdOf(const Scene& scene) {
    const auto sun = sunOf(scene);
    return sun ? scene.lights[*sun].notes.id : 0;
}

void switchSurroundings(VariantScene& shown, const VariantScene& base, const SceneVariant& from,
                        const SceneVariant& to) {
    std::set<int> ids = lightsIn({&from, &to});
    eraseLights(shown.scene, ids, false);
    if (to.surroundings) {
        putSurroundings(shown, *to.surroundings);
    } else if (from.surroundings) {
        putSurroundings(shown, surroundingsOf(base));
        const int sun = sunIdOf(base.scene);
        if (sun != 0)
            ids.insert(sun);
        else if (const int made = sunIdOf(shown.scene); made != 0)
            eraseLights(shown.scene, {made}, true);
    }
    if (ids.empty()) return;
    takeBaseLights(shown.scene, base.scene, ids);
    putLights(shown.scene, to);
}

} // namespace

const SceneVariant& shownVariant(const SceneFile& file) {
    static const SceneVariant kNone;
    if (file.shown) return *file.shown;
    const auto active = findVariant(file.variants, file.activeVariant);
    return active != file.variants.end() ? *active : kNone;
}

bool isFor(const PartDescription& part, const NamedPart& named, std::size_t index) {
    return part.number ? std::cmp_equal(*part.number, index + 1) : matchesPattern(part.pattern, named.name);
}

VariantSurroundings surroundingsOf(const VariantScene& lit) {
    const Scene& scene = lit.scene;
    VariantSurroundings all{scene.background, scene.ambient, lit.skyLight};
    const int files = static_cast<int>(scene.fileEnvironments());
    const int active = scene.activeEnvironment;
    if (scene.sky && active != files)
        all.environment = active;
    else if (!scene.sky && active >= 0 && active < files)
        all.environment = active;
    all.sky = scene.sky;
    all.sunId = sunIdOf(scene);
    return all;
}

void putSurroundings(VariantScene& lit, const VariantSurroundings& surroundings) {
    Scene& scene = lit.scene;
    lit.skyLight = surroundings.skyLight;
    scene.background = surroundings.background;
    scene.ambient = surroundings.ambient;
    const bool hasSun = sunOf(scene).has_value();
    if (scene.sky && (!hasSun || isSunEdited(scene))) setSky(scene, std::nullopt);
    if (scene.sky != surroundings.sky) setSky(scene, surroundings.sky);
    const int files = static_cast<int>(scene.fileEnvironments());
    const int none = files > 0 || scene.sky ? kNoEnvironment : 0;
    const int usual = scene.sky ? files : none;
    scene.activeEnvironment = surroundings.environment.value_or(usual);
    if (scene.activeEnvironment >= files + (scene.sky ? 1 : 0)) scene.activeEnvironment = usual;
    if (const auto sun = sunOf(scene)) scene.lights[*sun].light.on = 1;
    if (surroundings.sunId == 0 || sunIdOf(scene) == 0) return;
    std::erase_if(scene.lights,
                  [&](const SceneLight& each) { return !each.ofSky && each.notes.id == surroundings.sunId; });
    scene.lights[*sunOf(scene)].notes.id = surroundings.sunId;
}

void sortLights(Scene& scene, const Scene& base) {
    const auto rank = [&](const SceneLight& each) {
        const auto at = lightWithId(base, each.notes.id);
        return std::pair(each.ofSky ? base.lights.size() + 1 : at.value_or(base.lights.size()),
                         each.notes.id);
    };
    std::ranges::stable_sort(scene.lights, {}, rank);
}

void switchVariant(VariantScene& shown, const VariantScene& base, const SceneVariant& from,
                   const SceneVariant& to) {
    switchMaterials(shown.scene, base.scene, from, to);
    switchParts(shown.scene, base.scene, from, to);
    switchSurroundings(shown, base, from, to);
    const bool lights = from.surroundings || to.surroundings || !lightsIn({&from, &to}).empty();
    if (lights) sortLights(shown.scene, base.scene);
}

} // namespace rtcore
