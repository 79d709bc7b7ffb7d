#include "rtcore/io/import/assimp/assimp_parts.h"

#include "rtcore/io/images/image_file.h"
#include "rtcore/io/import/import_forms.h"
#include "rtcore/io/import/materials/exporter_colours.h"
#include "rtcore/platform/error.h"
#include "rtcore/platform/sentence.h"

#include <assimp/GltfMaterial.h>
#include <assimp/ObjMaterial.h>
#include <assimp/material.h>
#include <assimp/scene.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <initializer_list>
#include <optional>
#include <span>
#include <utility>

namespace rtcore {

namespace {

/// Reads properties that may be there; the key macros expand to three arguments.
class Properties {
  public:
    explicit Properties(const aiMaterial& material) : material_(material) {}

    bool has(const char* key, unsigned type, unsigned index) const {
        const aiMaterialProperty* property = nullptr;
        return aiGetMaterialProperty(&material_, key, type, index, &property) == aiReturn_SUCCESS;
    }
    bool read(float& value, const char* key, unsigned type, unsigned index) const {
        return material_.Get(key, type, index, value) == aiReturn_SUCCESS;
    }
    bool read(int& value, const char* key, unsigned type, unsigned index) const {
        return material_.Get(key, type, index, value) == aiReturn_SUCCESS;
    }
    bool read(bool& value, const char* key, unsigned type, unsigned index) const {
        return material_.Get(key, type, index, value) == aiReturn_SUCCESS;
    }
    bool read(Colour& value, const char* key, unsigned type, unsigned index) const {
        aiColor4D colour;
        if (aiGetMaterialColor(&material_, key, type, index, &colour) != aiReturn_SUCCESS) return false;
        value = {colour.r, colour.g, colour.b};
        return true;
    }
    std::string text(const char* key, unsigned type, unsigned index) const {
        aiString value;
        return material_.Get(key, type, index, value) == aiReturn_SUCCESS ? value.C_Str() : "";
    }
    /// The first image of these kinds.
    SourceMap picture(std::initializer_list<aiTextureType> kinds) const {
        for (const aiTextureType kind : kinds) {
            std::string name = text(AI_MATKEY_TEXTURE(kind, 0));
            if (name.empty()) continue;
            return {std::move(name), wrap(AI_MATKEY_MAPPINGMODE_U(kind, 0)),
                    wrap(AI_MATKEY_MAPPINGMODE_V(kind, 0)),
                    filter(AI_MATKEY_GLTF_MAPPINGFILTER_MAG(kind, 0))};
        }
        return {};
    }

  private:
    /// A decal, which ends at its edge, comes nearest to one that is clamped.
    TextureWrap wrap(const char* key, unsigned type, unsigned index) const {
        int mode = aiTextureMapMode_Wrap;
        read(mode, key, type, index);
        if (mode == aiTextureMapMode_Mirror) return TextureWrap::MirroredRepeat;
        const bool ends = mode == aiTextureMapMode_Clamp || mode == aiTextureMapMode_Decal;
        return ends ? TextureWrap::ClampToEdge : TextureWrap::Repeat;
    }

    TextureFilter filter(const char* key, unsigned type, unsigned index) const {
        constexpr int kNearest = 9728; // of OpenGL
        int filter = 0;
        read(filter, key, type, index);
        return filter == kNearest ? TextureFilter::Nearest : TextureFilter::Linear;
    }

    const aiMaterial& material_;
};

MaterialRules rulesOf(const Properties& p) {
    if (p.has(AI_MATKEY_GLOSSINESS_FACTOR)) return MaterialRules::SpecularGlossiness;
    // Roughness alone is what Assimp makes of the shininess of FBX.
    if (p.has(AI_MATKEY_METALLIC_FACTOR)) return MaterialRules::MetallicRoughness;
    return p.has(AI_MATKEY_OBJ_ILLUM) ? MaterialRules::Wavefront : MaterialRules::Classic;
}

void readColours(const Properties& p, SourceMaterial& m) {
    p.read(m.diffuse, AI_MATKEY_COLOR_DIFFUSE);
    if (m.rules == MaterialRules::MetallicRoughness) p.read(m.diffuse, AI_MATKEY_BASE_COLOR);
    p.read(m.specular, AI_MATKEY_COLOR_SPECULAR);
    p.read(m.emission, AI_MATKEY_COLOR_EMISSIVE);
    if (float intensity = 1; p.read(intensity, AI_MATKEY_EMISSIVE_INTENSITY))
        m.emission = m.emission * intensity;
    p.read(m.reflective, AI_MATKEY_COLOR_REFLECTIVE);
    if (m.rules == MaterialRules::Wavefront) p.read(m.transmission, AI_MATKEY_COLOR_TRANSPARENT);
}

void readNumbers(const Properties& p, SourceMaterial& m) {
    p.read(m.opacity, AI_MATKEY_OPACITY);
    p.read(m.shininess, AI_MATKEY_SHININESS);
    p.read(m.specularStrength, AI_MATKEY_SHININESS_STRENGTH);
    p.read(m.reflectivity, AI_MATKEY_REFLECTIVITY);
    const bool saysIndex = p.read(m.refraction, AI_MATKEY_REFRACTI);
    if (!saysIndex && m.rules == MaterialRules::MetallicRoughness) m.refraction = 1.5F;
    p.read(m.illumination, AI_MATKEY_OBJ_ILLUM);
    p.read(m.metallic, AI_MATKEY_METALLIC_FACTOR);
    p.read(m.roughness, AI_MATKEY_ROUGHNESS_FACTOR);
    p.read(m.glossiness, AI_MATKEY_GLOSSINESS_FACTOR);
    p.read(m.transmissionFactor, AI_MATKEY_TRANSMISSION_FACTOR);
    float thickness = 0;
    p.read(thickness, AI_MATKEY_VOLUME_THICKNESS_FACTOR);
    if (thickness > 0 && p.read(m.attenuationDistance, AI_MATKEY_VOLUME_ATTENUATION_DISTANCE)) {
        p.read(m.transmission, AI_MATKEY_VOLUME_ATTENUATION_COLOR);
    }
    // KHR_materials_ior; an index of 0 stands for one without end.
    if (saysIndex && p.has(AI_MATKEY_GLTF_ALPHAMODE)) {
        const float root = m.refraction > 0 ? (m.refraction - 1) / (m.refraction + 1) : 1;
        m.reflectance = root * root;
    }
}

/// Assimp gives all materials of Collada a specular colour, and an exponent.
void leaveOutInvented(const Properties& p, bool gouraudIsMatte, SpecularOrigin origin, SourceMaterial& m) {
    int model = 0;
    p.read(model, AI_MATKEY_SHADING_MODEL);
    if (gouraudIsMatte && model == aiShadingMode_Gouraud) origin = SpecularOrigin::None;
    if (origin == SpecularOrigin::None) m.shininess = 0;
    if (origin == SpecularOrigin::Texture) m.specular = kWhite;
}

void readAlpha(const Properties& p, SourceMaterial& m) {
    const std::string mode = p.text(AI_MATKEY_GLTF_ALPHAMODE);
    p.read(m.alphaCutoff, AI_MATKEY_GLTF_ALPHACUTOFF);
    m.alphaMode = mode.empty() || mode == "BLEND" ? AlphaMode::Blend
                  : mode == "MASK"                ? AlphaMode::Mask
                                                  : AlphaMode::Opaque;
    int flags = 0;
    p.read(flags, AI_MATKEY_TEXFLAGS_DIFFUSE(0));
    const bool isGltf = !mode.empty();
    bool bothSides = true;
    if (isGltf && p.read(bothSides, AI_MATKEY_TWOSIDED)) m.frontOnly = !bothSides;
    m.alphaInDiffuseMap = isGltf ? m.alphaMode != AlphaMode::Opaque : (flags & aiTextureFlags_UseAlpha) != 0;
    int model = 0;
    p.read(model, AI_MATKEY_SHADING_MODEL);
    m.unlit =
        (isGltf && model == aiShadingMode_NoShading) || (p.has(AI_MATKEY_OBJ_ILLUM) && m.illumination == 0);
}

void readPictures(const Properties& p, SourceMaterial& m) {
    m.diffuseMap = p.picture({aiTextureType_DIFFUSE, aiTextureType_BASE_COLOR});
    m.alphaMap = p.picture({aiTextureType_OPACITY});
    m.normalMap = p.picture({aiTextureType_NORMALS, aiTextureType_NORMAL_CAMERA});
    p.read(m.normalScale, AI_MATKEY_GLTF_TEXTURE_SCALE(aiTextureType_NORMALS, 0));
    m.heightMap = p.picture({aiTextureType_HEIGHT});
    p.read(m.heightScale, AI_MATKEY_BUMPSCALING);
    m.emissionMap = p.picture({aiTextureType_EMISSIVE, aiTextureType_EMISSION_COLOR});
    if (m.rules == MaterialRules::MetallicRoughness) {
        m.metallicRoughnessMap = p.picture({aiTextureType_UNKNOWN});
        m.transmissionMap = p.picture({aiTextureType_TRANSMISSION});
    }
    if (m.rules == MaterialRules::SpecularGlossiness) {
        m.specularGlossinessMap = p.picture({aiTextureType_SPECULAR});
    }
    if (m.rules == MaterialRules::Wavefront) m.specularMap = p.picture({aiTextureType_SPECULAR});
}

} // namespace

SourceMaterial sourceMaterialOf(const aiMaterial& material, const FormatQuirks& quirks,
                                const MaterialText& text) {
    const Properties p(material);
    SourceMaterial m;
    m.rules = rulesOf(p);
    m.name = p.text(AI_MATKEY_NAME);
    m.mapReplacesDiffuse = quirks.mapReplacesDiffuse;
    m.mapScalesEmission = quirks.mapScalesEmission;
    m.indexByHabit = quirks.indexByHabit;
    readColours(p, m);
    readNumbers(p, m);
    readAlpha(p, m);
    readPictures(p, m);
    leaveOutInvented(p, quirks.gouraudIsMatte, text.specular, m);
    if (text.specular == SpecularOrigin::Texture) m.specularMap = p.picture({aiTextureType_SPECULAR});
    if (quirks.displayColours) decodeColours(m);
    return m;
}

namespace {

/// The images that are looked up point by point; of others only the mean counts.
constexpr std::array kUsedMaps{aiTextureType_DIFFUSE, aiTextureType_BASE_COLOR, aiTextureType_OPACITY,
                               aiTextureType_NORMALS, aiTextureType_EMISSIVE};

TexcoordUse texcoordUseOf(const aiMaterial& material, aiTextureType kind, ImportReport& report) {
    TexcoordUse use;
    int set = 0;
    if (material.Get(AI_MATKEY_UVWSRC(kind, 0), set) == aiReturn_SUCCESS && set >= 0) {
        use.set = static_cast<unsigned int>(set);
    }
    aiUVTransform t;
    if (material.Get(AI_MATKEY_UVTRANSFORM(kind, 0), t) != aiReturn_SUCCESS) return use;
    if (t.mRotation != 0) {
        addWarning(report, import_forms::kTurnedTexture);
    }
    use.scale = {t.mScaling.x, t.mScaling.y};
    if (t.mRotation == 0) use.offset = {t.mTranslation.x, t.mTranslation.y};
    return use;
}

} // namespace

TexcoordUse texcoordUseOf(const aiMaterial& material, ImportReport& report) {
    std::optional<TexcoordUse> first;
    for (const aiTextureType kind : kUsedMaps) {
        if (material.GetTextureCount(kind) == 0) continue;
        const TexcoordUse use = texcoordUseOf(material, kind, report);
        if (!first) first = use;
        if (use == *first) continue;
        aiString name;
        material.Get(AI_MATKEY_NAME, name);
        addWarning(report, say(import_forms::kLaidAlike, std::string("'") + name.C_Str() + "'"));
    }
    return first.value_or(TexcoordUse{});
}

bool SceneEmbeddedPictures::has(const std::string& name) const {
    return scene_.GetEmbeddedTexture(name.c_str()) != nullptr;
}

LdrImage SceneEmbeddedPictures::decode(const std::string& name) const {
    const aiTexture* const texture = scene_.GetEmbeddedTexture(name.c_str());
    if (texture == nullptr || texture->pcData == nullptr) {
        throw FileError(FailureKind::BadData, name, "the image inside the model is empty");
    }
    if (texture->mHeight == 0) {
        const auto* const bytes = reinterpret_cast<const std::byte*>(texture->pcData);
        return decodeLdrImage({bytes, texture->mWidth}, name);
    }
    const std::uint64_t texels = std::uint64_t{texture->mWidth} * texture->mHeight;
    if (texture->mWidth > static_cast<unsigned>(kMaxImageSide) ||
        texture->mHeight > static_cast<unsigned>(kMaxImageSide) || texels > kMaxImagePixels) {
        throw FileError(FailureKind::BadData, name, "the image inside the model is too large");
    }
    LdrImage image(static_cast<int>(texture->mWidth), static_cast<int>(texture->mHeight));
    for (std::size_t i = 0; i < texels; ++i) {
        const aiTexel t = texture->pcData[i];
        image.pixels[i] = {t.r, t.g, t.b, t.a};
    }
    return image;
}

} // namespace rtcore
