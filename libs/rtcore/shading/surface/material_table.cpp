#include "rtcore/shading/surface/material_table.h"

#include "rtcore/lights/ambient_light.h"

#include <algorithm>

namespace rtcore {

void MaterialTable::prepare(const Scene& scene, const RenderSettings& settings) {
    prepare(scene, settings, unoccludedAmbient(scene, settings));
}

void MaterialTable::prepare(const Scene& scene, const RenderSettings& settings, Colour ambientLight) {
    rows_.resize(scene.materials.size() + (scene.ground ? 1 : 0));
    clear_.resize(rows_.size());
    traits_ = 0;
    anyEmission_ = tintedShadows_ = anyTint_ = false;
    const Mesh& mesh = scene.mesh();
    for (std::size_t i = 0; i < rows_.size(); ++i) {
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
}

} // namespace rtcore
