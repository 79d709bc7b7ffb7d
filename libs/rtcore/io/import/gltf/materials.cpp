#include "rtcore/io/import/gltf/materials.h"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

namespace rtcore::gltf {

namespace {

constexpr const char *kGlossiness = "KHR_materials_pbrSpecularGlossiness", *kVolume = "KHR_materials_volume",
                     *kTransmission = "KHR_materials_transmission", *kIor = "KHR_materials_ior",
                     *kSpecular = "KHR_materials_specular", *kUnlit = "KHR_materials_unlit",
                     *kClearcoat = "KHR_materials_clearcoat",
                     *kEmissiveStrength = "KHR_materials_emissive_strength";

std::optional<Colour> colourOf(const Json& object, const char* name) {
    if (const auto rgb = numbers<3>(object, name)) return Colour{(*rgb)[0], (*rgb)[1], (*rgb)[2]};
    return std::nullopt;
}

/// A colour and an opacity.
void readBase(const Json& object, const char* name, SourceMaterial& m) {
    m.diffuse = {1, 1, 1};
    if (const auto rgba = numbers<4>(object, name)) {
        m.diffuse = {(*rgba)[0], (*rgba)[1], (*rgba)[2]};
        m.opacity = (*rgba)[3];
    }
}

void readMetallicRoughness(const Json& material, const Images& images, SourceMaterial& m) {
    const Json& pbr = member(material, "pbrMetallicRoughness");
    m.rules = MaterialRules::MetallicRoughness;
    readBase(pbr, "baseColorFactor", m);
    m.metallic = number(pbr, "metallicFactor", 1);
    m.roughness = number(pbr, "roughnessFactor", 1);
    m.diffuseMap = images.mapOf(member(pbr, "baseColorTexture"));
    m.metallicRoughnessMap = images.mapOf(member(pbr, "metallicRoughnessTexture"));
}

void readSpecularGlossiness(const Json& pbr, const Images& images, SourceMaterial& m) {
    m.rules = MaterialRules::SpecularGlossiness;
    readBase(pbr, "diffuseFactor", m);
    m.specular = colourOf(pbr, "specularFactor").value_or(kWhite);
    m.glossiness = number(pbr, "glossinessFactor", 1);
    m.diffuseMap = images.mapOf(member(pbr, "diffuseTexture"));
    m.specularGlossinessMap = images.mapOf(member(pbr, "specularGlossinessTexture"));
}

void readAlpha(const Json& material, SourceMaterial& m) {
    const std::string mode = text(material, "alphaMode");
    m.alphaMode = mode == "BLEND" ? AlphaMode::Blend : mode == "MASK" ? AlphaMode::Mask : AlphaMode::Opaque;
    m.alphaCutoff = number(material, "alphaCutoff", 0.5F);
    m.alphaInDiffuseMap = m.alphaMode != AlphaMode::Opaque;
    m.frontOnly = !flag(material, "doubleSided", false);
}

/// An index of 0 stands for one without end.
void readIndex(const Json& material, SourceMaterial& m) {
    m.refraction = number(extension(material, kIor), "ior", 1.5F);
    if (extension(material, kIor).is_null()) return;
    const float root = m.refraction > 0 ? (m.refraction - 1) / (m.refraction + 1) : 1;
    m.reflectance = root * root;
}

void readSpecular(const Json& material, const Images& images, SourceMaterial& m) {
    const Json& specular = extension(material, kSpecular);
    if (specular.is_null()) return;
    m.specularColour = colourOf(specular, "specularColorFactor").value_or(kWhite);
    m.specularWeight = number(specular, "specularFactor", 1);
    m.specularColourMap = images.mapOf(member(specular, "specularColorTexture"));
    m.specularWeightMap = images.mapOf(member(specular, "specularTexture"));
}

/// Without a thickness it has no volume, without a distance light passes through that as it is.
void readTransmission(const Json& material, const Images& images, SourceMaterial& m) {
    const Json &passing = extension(material, kTransmission), &volume = extension(material, kVolume);
    m.transmissionFactor = number(passing, "transmissionFactor", 0);
    m.transmissionMap = images.mapOf(member(passing, "transmissionTexture"));
    const float distance = number(volume, "attenuationDistance", 0);
    if (!(number(volume, "thicknessFactor", 0) > 0) || !(distance > 0)) return;
    m.attenuationDistance = distance;
    m.transmission = colourOf(volume, "attenuationColor").value_or(kWhite);
}

void readCoat(const Json& material, const Images& images, SourceMaterial& m) {
    const Json& coat = extension(material, kClearcoat);
    m.coat = number(coat, "clearcoatFactor", 0);
    m.coatRoughness = number(coat, "clearcoatRoughnessFactor", 0);
    m.coatMap = images.mapOf(member(coat, "clearcoatTexture"));
    m.coatRoughnessMap = images.mapOf(member(coat, "clearcoatRoughnessTexture"));
}

void readEmission(const Json& material, const Images& images, SourceMaterial& m) {
    m.emission = colourOf(material, "emissiveFactor").value_or(Colour{}) *
                 number(extension(material, kEmissiveStrength), "emissiveStrength", 1);
    m.emissionMap = images.mapOf(member(material, "emissiveTexture"));
}

/// The number of the set by which an image lies as `use` says.
std::uint32_t setOf(const Json& use, std::vector<TexcoordUse>& sets) {
    const TexcoordUse own = texcoordUseOf(use);
    auto at = std::ranges::find(sets, own);
    if (at == sets.end() && sets.size() <= kMaxFurtherSets) at = sets.insert(sets.end(), own);
    return at == sets.end() ? 0 : static_cast<std::uint32_t>(at - sets.begin());
}

/// Of the images that are looked up point by point. What is unlit shows the first alone.
std::vector<TexcoordUse> layImages(const Json& material, SourceMaterial& m) {
    const Json &pbr = member(material, "pbrMetallicRoughness"), &glossy = extension(material, kGlossiness);
    const Json& base =
        member(glossy.is_null() ? pbr : glossy, glossy.is_null() ? "baseColorTexture" : "diffuseTexture");
    const std::array images{
        std::pair{&m.diffuseMap, &base}, std::pair{&m.normalMap, &member(material, "normalTexture")},
        std::pair{&m.emissionMap, &member(material, "emissiveTexture")},
        std::pair{&m.metallicRoughnessMap, &member(pbr, "metallicRoughnessTexture")},
        std::pair{&m.transmissionMap, &member(extension(material, kTransmission), "transmissionTexture")}};
    std::vector<TexcoordUse> sets;
    for (const auto& [map, use] : images)
        if (!map->empty() && (sets.empty() || !m.unlit)) map->texcoordSet = setOf(*use, sets);
    if (sets.empty()) sets.emplace_back();
    return sets;
}

SourceMaterial sourceMaterialOf(const Json& material, const Images& images) {
    SourceMaterial m;
    m.name = text(material, "name");
    readMetallicRoughness(material, images, m);
    if (const Json& pbr = extension(material, kGlossiness); !pbr.is_null()) {
        m.metallicRoughnessMap = {};
        readSpecularGlossiness(pbr, images, m);
    }
    readAlpha(material, m);
    readIndex(material, m);
    readSpecular(material, images, m);
    readTransmission(material, images, m);
    readCoat(material, images, m);
    readEmission(material, images, m);
    const Json& normal = member(material, "normalTexture");
    m.normalMap = images.mapOf(normal);
    m.normalScale = number(normal, "scale", 1);
    m.unlit = !extension(material, kUnlit).is_null();
    return m;
}

} // namespace

StatedMaterial materialOf(const Json& material, const Images& images) {
    StatedMaterial stated{sourceMaterialOf(material, images), {}};
    stated.texcoords = layImages(material, stated.source);
    return stated;
}

bool hasUnevenCoat(const Json& material, const Images& images) {
    const Json& coat = extension(material, kClearcoat);
    return number(coat, "clearcoatFactor", 0) > 0 &&
           std::ranges::any_of(
               std::array{"clearcoatTexture", "clearcoatRoughnessTexture", "clearcoatNormalTexture"},
               [&](const char* map) { return !images.mapOf(member(coat, map)).empty(); });
}

} // namespace rtcore::gltf
