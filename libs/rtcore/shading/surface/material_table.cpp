#include "rtcore/shading/surface/material_table.h"

#include "rtcore/lights/ambient_light.h"
#include "rtcore/math/constants.h"
#include "rtcore/scattering/phong.h"
#include "rtcore/scene/metallic_roughness.h"

#include <algorithm>

namespace rtcore {

namespace {

std::uint32_t traitsOf(const Material& m, const Mesh& mesh, const RenderSettings& settings) {
    const bool colours = !mesh.colours.empty();
    const auto used = [&](std::uint32_t texture) { return settings.textures && texture != kNoTexture; };
    std::uint32_t result = traits::kPoint;
    if (hasRoughness(m)) {
        result |= traits::kMetallic;
        if (used(m.metallicRoughnessTexture)) result |= traits::kVaried;
        // What a veil covers mirrors as if it were opaque.
        const bool covers = !settings.refractions || m.opacity >= 1 || isVeil(m);
        const bool smooth = m.roughness < kMirrorsBelow || used(m.metallicRoughnessTexture);
        if (settings.reflections && covers && smooth) result |= traits::kSharp;
    } else if (!isBlack(m.specular)) {
        if (m.shininess > 0) result |= traits::kGlossy;
        if (m.shininess < kLeastShininess) result |= traits::kRough;
    }
    if (colours || used(m.diffuseTexture)) result |= traits::kColoured;
    const bool varies = used(m.alphaTexture) || used(m.normalTexture) || used(m.emissionTexture) ||
                        used(m.specularTexture) || (m.vertexAlpha != 0 && !mesh.alphas.empty()) ||
                        (m.tintsEmission != 0 && colours);
    if ((settings.refractions && !(m.opacity >= 1)) || varies) {
        result |= traits::kGeneral;
    }
    if (!hasRoughness(m) && settings.reflections && !isBlack(m.mirror * m.mirrorScale)) {
        if ((result & traits::kGeneral) != 0) return result;
        result |= traits::kMirror;
        if (m.fresnel != 0) result |= traits::kFresnel;
    }
    return result;
}

void put(Colour c, float* to) {
    to[0] = c.r;
    to[1] = c.g;
    to[2] = c.b;
}

} // namespace

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
        MaterialRow& row = rows_[i];
        row.traits = traitsOf(m, mesh, settings);
        const bool varies = hasRoughness(m);
        const Colour ambient = varies ? Colour{} : ambientLight * (m.diffuse + m.specular);
        const Colour emitted = m.emission + ambient;
        put(m.diffuse / kPi, row.diffuse);
        put(m.emission, row.emission);
        put(ambient, row.ambient);
        put(emitted, row.emitted);
        put(m.mirror, row.mirror);
        row.mirrorScale = m.mirrorScale;
        put(m.specular, row.specular);
        const float phong = std::min(m.shininess / kLeastShininess, 1.0F);
        row.shininess = std::max(m.shininess, kLeastShininess);
        row.lobeScale = phong * (row.shininess + 2) / (2 * kPi);
        row.roughScale = (1 - phong) / (2 * kPi);
        traits_ |= row.traits;
        row.roughness = m.roughness;
        row.metallic = m.metallic;
        anyEmission_ = anyEmission_ || !isBlack(emitted) || (varies && !isBlack(ambientLight));
        const bool clear = (settings.refractions && m.opacity < 1) ||
                           (settings.textures && m.alphaTexture != kNoTexture) ||
                           (m.vertexAlpha != 0 && !mesh.alphas.empty());
        anyTint_ = anyTint_ || (settings.textures && m.specularTexture != kNoTexture);
        clear_[i] = clear ? 1 : 0;
        tintedShadows_ = tintedShadows_ || clear;
    }
}

} // namespace rtcore
