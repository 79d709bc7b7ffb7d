#include "rtcore/scene/metallic_roughness.h"

#include <algorithm>
#include <cmath>

namespace rtcore {

namespace {

constexpr Colour kDielectric{kDielectricReflectance, kDielectricReflectance, kDielectricReflectance};
constexpr float kLeastRoughness = 0.01F;
constexpr float kMirrorsBelow = 0.3F; ///< roughness

Colour mixed(Colour a, Colour b, float t) { return a * (1 - t) + b * t; }

float quotient(float part, float of) { return of > 0 ? std::clamp(part / of, 0.0F, 1.0F) : 0; }

} // namespace

void setReflection(Material& m, Colour f0, float roughness) {
    const float r = std::max(roughness, kLeastRoughness);
    const float alpha = r * r;
    const auto unit = [](float v) { return std::clamp(v, 0.0F, 1.0F) + 0.0F; };
    m.specular = {unit(f0.r), unit(f0.g), unit(f0.b)};
    m.shininess = std::clamp((2 / (alpha * alpha) - 2) / 4, 0.0F, 100000.0F);
    m.mirrorScale = std::max(0.0F, 1 - roughness / kMirrorsBelow);
    m.fresnel = m.mirrorScale > 0 ? 1 : 0;
    m.mirror = m.mirrorScale > 0 ? m.specular : Colour{};
}

void setMetallicRoughness(Material& m, Colour base, Colour textureMean, float metallic, float roughness) {
    m.roughness = roughness;
    m.metallic = metallic;
    setReflection(m, mixed(kDielectric, base * textureMean, metallic), roughness);
    m.diffuse = base * (1 - metallic);
}

Colour baseColourOf(const Material& m, Colour textureMean) {
    if (m.metallic <= 0) return m.diffuse;
    const bool metal = m.metallic >= 1;
    const Colour part = metal ? m.specular : m.diffuse;
    const Colour of = metal ? textureMean : kWhite * (1 - m.metallic);
    return {quotient(part.r, of.r), quotient(part.g, of.g), quotient(part.b, of.b)};
}

// The inverse of the shininess in setReflection().
float roughnessOf(const Material& m) {
    if (m.roughness != kNoRoughness) return m.roughness;
    if (isBlack(m.specular)) return 1;
    const float alphaSquared = 1 / (1 + 2 * m.shininess);
    return std::clamp(std::sqrt(std::sqrt(alphaSquared)), 0.0F, 1.0F);
}

void conserveEnergy(Material& m) {
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
