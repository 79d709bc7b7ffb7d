#include "rtcore/shading/surface/material_table.h"

#include "rtcore/lights/ambient_light.h"

#include <algorithm>

namespace rtcore {

namespace {

MaterialRow whiteRow(const Mesh& mesh, const RenderSettings& settings, Colour ambientLight) {
    Material white;
    white.diffuse = kWhite;
    MaterialRow row = rowOf(white, mesh, settings, ambientLight);
    row.traits = traits::kPoint;
    return row;
}

} // namespace

void MaterialTable::prepare(const Scene& scene, const RenderSettings& settings) {
    prepare(scene, settings, unoccludedAmbient(scene, settings));
}

void MaterialTable::prepare(const Scene& scene, const RenderSettings& settings, Colour ambientLight) {
    const std::size_t count = scene.materials.size() + (scene.ground ? 1 : 0);
    rows_.resize(count + 1);
    clear_.resize(count);
    traits_ = 0;
    anyEmission_ = tintedShadows_ = anyTint_ = false;
    const Mesh& mesh = scene.mesh();
    for (std::size_t i = 0; i < count; ++i) {
        const Material& m = scene.material(static_cast<std::uint32_t>(i));
        const MaterialRow& row = rows_[i] = rowOf(m, mesh, settings, ambientLight);
        traits_ |= row.traits;
        const bool emits = std::ranges::any_of(row.emitted, [](float channel) { return channel != 0; });
        anyEmission_ = anyEmission_ || emits || (hasRoughness(m) && !isBlack(ambientLight));
        const bool clear = (settings.refractions && m.opacity < 1) ||
                           (settings.textures && m.alphaTexture != kNoTexture) ||
                           (m.vertexAlpha != 0 && !mesh.alphas.empty());
        anyTint_ = anyTint_ || (settings.textures && m.specularTexture != kNoTexture);
        clear_[i] = clear ? 1 : 0;
        tintedShadows_ = tintedShadows_ || clear;
    }
    rows_[count] = whiteRow(mesh, settings, ambientLight);
    anyEmission_ = anyEmission_ || (settings.falseColours.seesWhite() && !isBlack(ambientLight));
}

} // namespace rtcore
