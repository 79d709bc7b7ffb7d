#include "rtcore/scene/metallic_roughness.h"

#include <algorithm>
#include <cmath>

namespace rtcore {

namespace {

constexpr Colour kDielectric{kDielectricReflectance, kDielectricReflectance, kDielectricReflectance};
constexpr float kMinRoughness = 0.01F;

} // namespace

void setMetallicRoughness(Material& m, Colour base, float metallic, float roughness) {
    const Material plain;
    if (!hasRoughness(m)) m.specular = kDielectric;
    m.diffuse = base;
    m.roughness = roughness;
    m.metallic = metallic;
    m.shininess = plain.shininess;
    m.mirror = plain.mirror;
    m.mirrorScale = plain.mirrorScale;
    m.fresnel = plain.fresnel;
}

void setPhong(Material& m, const TextureMeans& means) {
    if (!hasRoughness(m)) return;
    const bool textured = m.metallicRoughnessTexture != kNoTexture;
    const float roughness = m.roughness * (textured ? means.roughness : 1);
    const float metallic = m.metallic * (textured ? means.metallic : 1);
    const float alpha = std::max(roughness, kMinRoughness) * std::max(roughness, kMinRoughness);
    m.specular = m.specular * (1 - metallic) + m.diffuse * means.diffuse * metallic;
    m.diffuse = m.diffuse * (1 - metallic);
    m.shininess = std::clamp((2 / (alpha * alpha) - 2) / 4, 0.0F, 100000.0F);
    m.mirrorScale = std::max(0.0F, 1 - roughness / kMirrorsBelow);
    m.fresnel = m.mirrorScale > 0 ? 1 : 0;
    m.mirror = m.mirrorScale > 0 ? m.specular : Colour{};
    m.roughness = kNoRoughness;
    m.metallic = 0;
    m.metallicRoughnessTexture = kNoTexture;
    conserveEnergy(m);
}

// The inverse of the shininess in setPhong().
float roughnessOf(const Material& m) {
    if (hasRoughness(m)) return m.roughness;
    if (isBlack(m.specular)) return 1;
    const float alphaSquared = 1 / (1 + 2 * m.shininess);
    return std::clamp(std::sqrt(std::sqrt(alphaSquared)), 0.0F, 1.0F);
}

void conserveEnergy(Material& m) {
    if (hasRoughness(m)) return;
    float scale = 1;
    const auto limit = [&](float kd, float ks) {
        if (kd + ks > 1) scale = std::min(scale, std::max(0.0F, (1 - kd) / ks));
    };
    limit(m.diffuse.r, m.specular.r);
    limit(m.diffuse.g, m.specular.g);
    limit(m.diffuse.b, m.specular.b);
    m.specular = m.specular * scale;
}

} // namespace rtcore
