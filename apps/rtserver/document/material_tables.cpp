#include "rtserver/document/material_tables.h"

#include "rtcore/io/text/pattern.h"
#include "rtcore/scene/material_edit.h"

#include <algorithm>
#include <cstddef>
#include <string_view>
#include <utility>

namespace rtserver {

namespace {

using rtcore::MaterialOverride;
using Tables = std::vector<MaterialOverride>;

std::string_view nameAt(const rtcore::Scene& scene, std::size_t index) {
    return scene.model.name(scene.materials[index].nameOffset);
}

bool isFor(const MaterialOverride& table, const rtcore::Scene& scene, std::size_t index) {
    return table.number ? static_cast<std::size_t>(*table.number) == index + 1
                        : rtcore::matchesPattern(table.pattern, nameAt(scene, index));
}

bool isForOne(const MaterialOverride& table, const rtcore::Scene& scene) {
    std::size_t found = 0;
    for (std::size_t i = 0; i < scene.materials.size(); ++i) found += isFor(table, scene, i) ? 1 : 0;
    return found == 1 && (table.number || !rtcore::isPattern(table.pattern));
}

/// By its name, where that is one's own and no pattern.
void nameMaterial(const rtcore::Scene& scene, std::size_t index, MaterialOverride& table) {
    MaterialOverride named;
    named.pattern = nameAt(scene, index);
    if (named.pattern.empty() || !isForOne(named, scene)) return;
    table.pattern = named.pattern;
    table.number.reset();
}

/// A mirror that reflects nothing is none, whatever its scale.
bool looksAs(rtcore::Material a, rtcore::Material b) {
    for (rtcore::Material* each : {&a, &b}) {
        if (isBlack(each->mirror)) each->mirrorScale = 1;
    }
    return a == b;
}

/// The same material in words of its own kind: what tables say one after the other in words of both kinds
/// depends on the material before each.
MaterialOverride speltOut(MaterialOverride table, const rtcore::Material& shown) {
    table.diffuse = shown.diffuse;
    table.roughness.reset();
    table.metallic.reset();
    table.specular.reset();
    table.shininess.reset();
    table.reflectivity.reset();
    table.fresnel.reset();
    if (rtcore::hasRoughness(shown)) {
        table.roughness = shown.roughness;
        table.metallic = shown.metallic;
        return table;
    }
    table.coat.reset();
    table.specular = shown.specular;
    table.shininess = shown.shininess;
    table.fresnel = shown.fresnel != 0;
    if (shown.mirrorScale == 1) table.reflectivity = shown.mirror;
    return table;
}

/// Whether `table`, the last one for a material, can say all that is shown of it, and takes it up.
bool takesUp(const rtcore::Scene& scene, std::size_t index, const MaterialOverride& edit, Tables& tables,
             MaterialOverride& table) {
    const rtcore::Material& shown = scene.materials[index];
    rtcore::Material before = scene.model.materials[index];
    // The scene's file may have given it a texture, which no edit changes.
    const auto apply = [&](const MaterialOverride& change) {
        if (change.diffuseTexture) before.diffuseTexture = shown.diffuseTexture;
        before = rtcore::changedMaterial(scene.model, before, change);
        if (change.diffuseTexture) before.diffuseTexture = shown.diffuseTexture;
        return before;
    };
    for (const MaterialOverride& each : tables) {
        if (&each == &table) break;
        if (isFor(each, scene, index)) apply(each);
    }
    MaterialOverride merged = table;
    merged.add(edit);
    for (const MaterialOverride& candidate : {merged, speltOut(merged, shown)}) {
        const rtcore::Material start = before;
        if (looksAs(apply(candidate), shown)) {
            table = candidate;
            return true;
        }
        before = start;
    }
    return false;
}

} // namespace

void addMaterialEdits(const rtcore::Scene& scene, Tables& tables) {
    for (MaterialOverride edit : scene.materialEdits) {
        const std::size_t index = static_cast<std::size_t>(*edit.number) - 1;
        const auto last = std::find_if(tables.rbegin(), tables.rend(), [&](const MaterialOverride& table) {
            return isFor(table, scene, index);
        });
        const bool alone = last != tables.rend() && isForOne(*last, scene);
        if (alone && takesUp(scene, index, edit, tables, *last)) continue;
        nameMaterial(scene, index, edit);
        tables.push_back(std::move(edit));
    }
}

} // namespace rtserver
