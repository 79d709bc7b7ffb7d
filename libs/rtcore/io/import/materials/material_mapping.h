/// From the materials of model files to ours. Knows nothing of Assimp.
#pragma once

#include "rtcore/io/import/materials/texture_store.h"
#include "rtcore/scene/metallic_roughness.h"

#include <string>

namespace rtcore {

/// The rules by which the numbers of a SourceMaterial are meant.
enum class MaterialRules {
    Classic,            ///< diffuse, specular, shininess, opacity, reflectivity: most formats
    Wavefront,          ///< the same with the illumination models of MTL
    MetallicRoughness,  ///< glTF 2
    SpecularGlossiness, ///< glTF 2, KHR_materials_pbrSpecularGlossiness
};
enum class AlphaMode { Opaque, Mask, Blend };

/// The diffuse colour that Assimp gives where a file says nothing.
inline constexpr Colour kUnsetDiffuse{0.6F, 0.6F, 0.6F};

/// A material as its file has it. Any floats.
struct SourceMaterial {
    MaterialRules rules = MaterialRules::Classic;
    std::string name;
    bool unlit = false; ///< shows its colour whatever the light

    Colour diffuse{0.8F, 0.8F, 0.8F}; ///< or base colour
    Colour specular, emission, reflective{1, 1, 1}, transmission{1, 1, 1};
    float opacity = 1;
    float shininess = 0;
    float specularStrength = 1;
    float reflectivity = 0;
    float refraction = 1; ///< index
    int illumination = 2; ///< MTL's illum
    float metallic = 0, roughness = 1;
    float glossiness = 1;
    float transmissionFactor = 0;               ///< KHR_materials_transmission
    float attenuationDistance = 0;              ///< KHR_materials_volume; 0 = none
    float coat = 0, coatRoughness = 0;          ///< KHR_materials_clearcoat
    float reflectance = kDielectricReflectance; ///< straight on, of what is no metal; MetallicRoughness
    Colour specularColour{1, 1, 1};             ///< KHR_materials_specular: factor on `reflectance`
    float specularWeight = 1;                   ///< the same
    AlphaMode alphaMode = AlphaMode::Opaque;
    float alphaCutoff = 0.5F;
    bool vertexAlpha = false;  ///< alphas of vertices multiply the opacity
    bool frontOnly = false;    ///< its back faces are culled
    bool indexByHabit = false; ///< `refraction` stands in every material, whether it is meant or not

    SourceMap diffuseMap, alphaMap, normalMap, emissionMap;
    float normalScale = 1; ///< how far the normal map leans
    SourceMap heightMap;   ///< in place of a normal map
    float heightScale = 1;
    SourceMap specularMap;           ///< multiplies `specular`; Classic and Wavefront
    SourceMap transmissionMap;       ///< red multiplies `transmissionFactor`
    SourceMap metallicRoughnessMap;  ///< roughness in green, metal in blue
    SourceMap specularGlossinessMap; ///< glossiness in alpha; only its mean is used
    SourceMap specularColourMap;     ///< multiplies `specularColour`; only its mean is used
    SourceMap coatMap;               ///< red multiplies `coat`; only its mean is used
    SourceMap coatRoughnessMap;      ///< green multiplies `coatRoughness`; only its mean is used
    SourceMap specularWeightMap;     ///< alpha multiplies `specularWeight`; only its mean is used
    bool alphaInDiffuseMap = false;
    bool mapReplacesDiffuse = false; ///< `diffuse` counts only without an image
    bool mapScalesEmission =
        false; ///< the diffuse image multiplies `emission`, where that has none of its own
};

/// Maps numbers and images; `textures` gets the images. Every number of the result is in the range that
/// material.h states, and k_d + k_s <= 1. The name is not set. Formulas: docs/import.md.
Material mapMaterial(const SourceMaterial& source, TextureStore& textures);

} // namespace rtcore
