#include "rtserver/document/material_tables.h"

#include "rtcore/io/variants/material_words.h"
#include "rtcore/scene/material_edit.h"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace rtserver {

namespace {

using rtcore::MaterialOverride;
using Tables = std::vector<MaterialOverride>;

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
        if (rtcore::isFor(each, scene, index)) apply(each);
    }
    MaterialOverride merged = table;
    merged.add(edit);
    for (const MaterialOverride& candidate : {merged, rtcore::speltOut(merged, shown)}) {
        const rtcore::Material start = before;
        if (rtcore::looksAs(apply(candidate), shown)) {
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
            return rtcore::isFor(table, scene, index);
        });
        const bool alone = last != tables.rend() && rtcore::isForOne(*last, scene);
        if (alone && takesUp(scene, index, edit, tables, *last)) continue;
        rtcore::nameMaterial(scene, index, edit);
        tables.push_back(std::move(edit));
    }
}

} // namespace rtserver
