#include "rtcore/scene/material_edit.h"

#include "rtcore/scene/image_summary.h"

#include <algorithm>
#include <utility>

namespace rtcore {

namespace {

/// Sorted by number, so that the same edits in any order are the same.
MaterialOverride& editOf(Scene& scene, std::size_t index) {
    const int number = static_cast<int>(index) + 1;
    std::vector<MaterialOverride>& edits = scene.materialEdits;
    auto at = std::find_if(edits.begin(), edits.end(),
                           [&](const MaterialOverride& edit) { return *edit.number >= number; });
    if (at != edits.end() && *at->number == number) return *at;
    MaterialOverride none;
    none.number = number;
    return *edits.insert(at, none);
}

ImageSummary summaryOf(const Model& model, std::uint32_t texture) {
    return summarise(model, model.textures[texture]);
}

} // namespace

Colour textureMean(const Model& model, std::uint32_t texture) { return summaryOf(model, texture).meanColour; }

TextureMeans roughnessMeans(const Model& model, const Material& material) {
    TextureMeans means;
    if (material.metallicRoughnessTexture != kNoTexture) {
        const ImageSummary summary = summaryOf(model, material.metallicRoughnessTexture);
        means.roughness = summary.meanChannel[1];
        means.metallic = summary.meanChannel[2];
    }
    return means;
}

Material changedMaterial(const Model& model, Material material, const MaterialOverride& change) {
    TextureMeans means;
    if (change.needsMeans()) {
        means = roughnessMeans(model, material);
        if (material.diffuseTexture != kNoTexture && change.textures.value_or(true))
            means.diffuse = textureMean(model, material.diffuseTexture);
    }
    change.applyTo(material, means);
    return material;
}

void editMaterial(Scene& scene, std::span<const Material> loaded, std::size_t index,
                  const MaterialOverride& change) {
    MaterialOverride& edit = editOf(scene, index);
    edit.add(change);
    scene.materials[index] = changedMaterial(scene.model, loaded[index], edit);
}

void giveLook(Scene& scene, std::span<const Material> loaded, std::size_t index, MaterialOverride look) {
    MaterialOverride& edit = editOf(scene, index);
    look.pattern.clear();
    look.number = edit.number;
    if (!look.priority) look.priority = edit.priority;
    edit = std::move(look);
    scene.materials[index] = changedMaterial(scene.model, loaded[index], edit);
}

void resetMaterial(Scene& scene, std::span<const Material> loaded, std::size_t index) {
    std::erase_if(scene.materialEdits,
                  [&](const MaterialOverride& edit) { return *edit.number == static_cast<int>(index) + 1; });
    scene.materials[index] = loaded[index];
}

void closeSurfaces(Scene& scene, std::span<const Material> before) {
    const bool same =
        std::equal(before.begin(), before.end(), scene.materials.begin(), scene.materials.end(),
                   [](const Material& a, const Material& b) {
                       return isTransparent(a) == isTransparent(b) && (a.opacity < 1) == (b.opacity < 1);
                   });
    if (same) return;
    scene.closed = findClosedSurfaces(scene.model.mesh, scene.materials);
    scene.solids = findGlassSolids(scene.model.mesh, scene.materials, scene.closed);
}

} // namespace rtcore
