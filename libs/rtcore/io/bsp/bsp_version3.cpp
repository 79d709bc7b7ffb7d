#include "rtcore/io/bsp/bsp_version3.h"

#include "rtcore/scene/material_edit.h"

#include <algorithm>

namespace rtcore {

namespace {

float quotient(float part, float of) { return of > 0 ? std::clamp(part / of, 0.0F, 1.0F) : 0; }

/// The diffuse albedo was base (1 - metallic), the specular one that of a metal whose base colour the mean of
/// the texture multiplied.
Colour baseColourOf(const Model& model, const Material& m) {
    if (m.metallic <= 0) return m.diffuse;
    const bool metal = m.metallic >= 1, textured = m.diffuseTexture != kNoTexture;
    const Colour part = metal ? m.specular : m.diffuse;
    const Colour of = !metal     ? kWhite * (1 - m.metallic)
                      : textured ? textureMean(model, m.diffuseTexture)
                                 : kWhite;
    return {quotient(part.r, of.r), quotient(part.g, of.g), quotient(part.b, of.b)};
}

} // namespace

std::vector<Material> materialsOfVersion3(const Model& model) {
    std::vector<Material> materials(model.materials.begin(), model.materials.end());
    for (Material& m : materials) {
        if (!hasRoughness(m)) continue;
        const Colour base = baseColourOf(model, m), reflected = m.specular;
        const float roughness = m.roughness;
        m.roughness = kNoRoughness;
        setMetallicRoughness(m, base, m.metallic, roughness);
        if (m.metallic <= 0) m.specular = reflected;
    }
    return materials;
}

} // namespace rtcore
