#include "rtcore/io/import/materials/material_mapping.h"

#include "rtcore/scene/metallic_roughness.h"

#include <algorithm>
#include <cmath>

namespace rtcore {

namespace {

float bounded(float v, float lo, float hi, float otherwise) {
    return std::isfinite(v) ? std::clamp(v, lo, hi) + 0.0F : otherwise;
}
float unit(float v, float otherwise = 0) { return bounded(v, 0, 1, otherwise); }
Colour unit(Colour c) { return {unit(c.r), unit(c.g), unit(c.b)}; }

/// Light passes straight: neither bent nor mirrored at the surface.
void makeVeil(Material& m, float opacity) {
    m.opacity = opacity;
    m.indexOfRefraction = 1;
}

/// Where there is something that it can multiply.
void setSpecularMap(const SourceMaterial& s, Material& m, TextureStore& textures) {
    if (!isBlack(m.specular) || !isBlack(m.mirror)) m.specularTexture = textures.texture(s.specularMap);
}

void makeGlass(Material& m, float opacity, float refraction) {
    m.opacity = opacity;
    m.indexOfRefraction = bounded(refraction, 1, 5, 1.5F);
}

void mapClassic(const SourceMaterial& s, Material& m, TextureStore& textures) {
    // Without an exponent there is no highlight: many formats default to a white one.
    if (s.shininess >= 1) {
        m.specular = unit(unit(s.specular) * bounded(s.specularStrength, 0, 1, 1));
        m.shininess = bounded(s.shininess, 1, 100000, 1);
    }
    m.mirror = unit(unit(s.reflective) * unit(s.reflectivity));
    setSpecularMap(s, m, textures);
    const float opacity = unit(s.opacity, 1);
    if (opacity >= 1) return;
    // A surface that only covers would not be seen at all where it covers nothing.
    const bool bends = !s.indexByHabit || opacity == 0;
    makeGlass(m, opacity, bends ? std::max(s.refraction, 1.0F) : 1.0F);
}

bool isGlassModel(int illumination) { return illumination == 4 || illumination == 6 || illumination == 7; }

/// MTL's illum: 0 constant, 1 Lambert, 2 highlight, 3 mirror, 4 glass, 5 Fresnel mirror, 6 glass, 7 Fresnel
/// glass, 8 and 9 as 3 and 4 without rays, so plain.
void mapWavefront(const SourceMaterial& s, Material& m, TextureStore& textures) {
    if (s.illumination >= 2 && s.shininess > 0) {
        m.specular = unit(s.specular);
        m.shininess = bounded(s.shininess, 1, 1000, 1);
    }
    // Opacity 0 with an opaque illumination model is Tr written the wrong way round ("d 1, Tr 1").
    const bool glassModel = isGlassModel(s.illumination);
    float opacity = unit(s.opacity, 1);
    if (opacity == 0 && !glassModel) opacity = 1;
    // Maya writes illum 4 and Ni 1 for everything.
    if (glassModel && (opacity < 1 || s.refraction != 1)) {
        makeGlass(m, opacity < 1 ? opacity : 0, s.refraction);
        // Exporters write a grey Tf of 0, 0.1 and 1 for clear glass alike: only a hue is meant.
        const Colour tint = unit(s.transmission);
        const float largest = maxComponent(tint), smallest = std::min({tint.r, tint.g, tint.b});
        if (largest - smallest > 0.01F * largest) m.transmission = tint;
        return;
    }
    if (opacity < 1) makeVeil(m, opacity);
    if (s.illumination >= 3 && s.illumination <= 7) {
        m.mirror = unit(s.specular);
        m.fresnel = s.illumination == 5 || s.illumination == 7 ? 1 : 0;
    }
    setSpecularMap(s, m, textures);
}

/// glTF's alpha says how much the surface covers; what is beside it passes as if nothing were there, however
/// smooth the surface is.
void mapTransparency(const SourceMaterial& s, Material& m, Colour base) {
    const float alpha = s.alphaMode == AlphaMode::Blend ? unit(s.opacity, 1) : 1;
    const float passing = unit(s.transmissionFactor) * (1 - unit(s.metallic));
    if (passing > 0) {
        makeGlass(m, alpha * (1 - passing), s.refraction >= 1 ? s.refraction : 1.5F);
        m.transmission = unit(base) * unit(s.transmission);
        m.attenuationDistance = bounded(s.attenuationDistance, 0, 1e16F, 0);
    } else if (alpha < 1 && isGlassModel(s.illumination)) {
        makeGlass(m, alpha, s.refraction);
    } else if (alpha < 1) {
        makeVeil(m, alpha);
    }
    const bool hole = s.alphaMode == AlphaMode::Mask && unit(s.opacity, 1) < unit(s.alphaCutoff, 0.5F);
    if (hole && s.diffuseMap.empty()) makeVeil(m, 0);
}

/// A surface that covers a part of what is behind it emits from that part alone.
void coverEmission(const SourceMaterial& s, Material& m) {
    const bool covers = s.unlit || s.rules == MaterialRules::MetallicRoughness ||
                        s.rules == MaterialRules::SpecularGlossiness;
    if (covers && m.opacity < 1 && isVeil(m)) m.emission = m.emission * m.opacity;
}

/// Straight on, of what is no metal.
Colour reflectanceOf(const SourceMaterial& s, TextureStore& textures) {
    Colour colour{bounded(s.specularColour.r, 0, 1e6F, 1), bounded(s.specularColour.g, 0, 1e6F, 1),
                  bounded(s.specularColour.b, 0, 1e6F, 1)};
    float weight = unit(s.specularWeight, 1);
    if (const auto map = textures.summary(s.specularColourMap)) colour *= map->meanColour;
    if (const auto map = textures.summary(s.specularWeightMap)) weight *= map->meanChannel[3];
    return unit(colour * unit(s.reflectance)) * weight;
}

void setCoat(const SourceMaterial& s, Material& m, TextureStore& textures) {
    m.coat = unit(s.coat);
    m.coatRoughness = unit(s.coatRoughness);
    if (const auto map = textures.summary(s.coatMap)) m.coat *= map->meanChannel[0];
    if (const auto map = textures.summary(s.coatRoughnessMap)) m.coatRoughness *= map->meanChannel[1];
}

/// Where the image is missing that says what is metal, its factor would make all of it metal.
void mapMetallicRoughness(const SourceMaterial& s, Material& m, TextureStore& textures) {
    m.metallicRoughnessTexture = textures.texture(s.metallicRoughnessMap);
    const bool missing = !s.metallicRoughnessMap.empty() && m.metallicRoughnessTexture == kNoTexture;
    setMetallicRoughness(m, m.diffuse, missing ? 0 : unit(s.metallic), unit(s.roughness, 1));
    m.specular = reflectanceOf(s, textures);
    setCoat(s, m, textures);
    mapTransparency(s, m, m.diffuse);
    if (unit(s.transmissionFactor) > 0) m.transmissionTexture = textures.texture(s.transmissionMap);
}

void mapSpecularGlossiness(const SourceMaterial& s, Material& m, TextureStore& textures) {
    Colour f0 = unit(s.specular);
    float glossiness = unit(s.glossiness, 1);
    if (const auto map = textures.summary(s.specularGlossinessMap)) {
        f0 *= map->meanColour;
        glossiness *= map->meanChannel[3];
    }
    setMetallicRoughness(m, m.diffuse, 0, 1 - glossiness);
    m.specular = f0;
    mapTransparency(s, m, m.diffuse);
}

/// Black, or nothing that a file says: an image is meant to be seen.
bool diffuseIsUnset(Colour c) { return isBlack(c) || c == kUnsetDiffuse; }

void setPictures(const SourceMaterial& s, Material& m, TextureStore& textures) {
    m.diffuseTexture = textures.texture(s.diffuseMap);
    m.normalTexture = textures.texture(s.normalMap);
    m.normalScale = bounded(s.normalScale, -1e6F, 1e6F, 1);
    if (m.normalTexture == kNoTexture && !s.heightMap.empty()) {
        const Relief relief = textures.relief(s.heightMap, bounded(s.heightScale, -1e6F, 1e6F, 1));
        m.normalTexture = relief.texture;
        m.normalScale = relief.scale;
    }
    m.emissionTexture = textures.texture(s.emissionMap);
    // Where the image is missing that says what shines, its factor would make all of it shine.
    if (m.emissionTexture == kNoTexture && !s.emissionMap.empty()) m.emission = {};
    const bool inDiffuse = s.alphaInDiffuseMap && s.alphaMap.empty();
    const SourceMap& alphaMap = inDiffuse ? s.diffuseMap : s.alphaMap;
    // An image that hides nothing would make every ray ask for nothing.
    const auto summary = textures.summary(alphaMap);
    if (!summary || !(inDiffuse ? summary->transparent : summary->transparent || summary->dark)) return;
    m.alphaTexture = textures.texture(alphaMap);
    m.alphaFromAlpha = summary->transparent ? 1 : 0;
}

/// Sets the cutoff of the alpha that varies over the surface.
void setCutoff(const SourceMaterial& s, Material& m) {
    if (s.alphaMode != AlphaMode::Mask || !hasHoles(m)) return;
    // The file's cutoff is for that alpha times the factor.
    const float factor = std::max(unit(s.opacity, 1), 1e-3F);
    m.alphaCutoff = std::clamp(unit(s.alphaCutoff, 0.5F) / factor, 1e-3F, 1.0F);
}

void makeUnlit(Material& m, Colour colour) {
    m.emission = colour;
    m.emissionTexture = m.diffuseTexture;
    m.diffuse = m.specular = m.mirror = {};
    m.fresnel = 0;
    m.roughness = kNoRoughness;
    m.metallic = m.coat = 0;
    m.metallicRoughnessTexture = m.specularTexture = kNoTexture;
    m.tintsEmission = 1;
}

} // namespace

Material mapMaterial(const SourceMaterial& source, TextureStore& textures) {
    Material m;
    m.diffuse = unit(source.diffuse);
    const auto light = [](float v) { return bounded(v, 0, 1e16F, 0); };
    m.emission = {light(source.emission.r), light(source.emission.g), light(source.emission.b)};
    setPictures(source, m, textures);
    m.vertexAlpha = source.vertexAlpha && source.alphaMode != AlphaMode::Opaque ? 1 : 0;
    setCutoff(source, m);
    const bool pbr =
        source.rules == MaterialRules::MetallicRoughness || source.rules == MaterialRules::SpecularGlossiness;
    const bool unset = source.mapReplacesDiffuse || (!pbr && diffuseIsUnset(m.diffuse));
    if (m.diffuseTexture != kNoTexture && unset) m.diffuse = kWhite;
    if (m.emissionTexture != kNoTexture && !pbr && isBlack(m.emission)) m.emission = kWhite;
    if (source.mapScalesEmission && source.emissionMap.empty() && !isBlack(m.emission))
        m.emissionTexture = m.diffuseTexture;
    const Colour colour = m.diffuse;
    switch (source.rules) {
    case MaterialRules::Classic:
        mapClassic(source, m, textures);
        break;
    case MaterialRules::Wavefront:
        mapWavefront(source, m, textures);
        break;
    case MaterialRules::MetallicRoughness:
        mapMetallicRoughness(source, m, textures);
        break;
    case MaterialRules::SpecularGlossiness:
        mapSpecularGlossiness(source, m, textures);
        break;
    }
    if (source.unlit) makeUnlit(m, colour);
    coverEmission(source, m);
    if (source.frontOnly && source.alphaMode == AlphaMode::Blend && isTransparent(m)) m.frontOnly = 1;
    conserveEnergy(m);
    return m;
}

} // namespace rtcore
