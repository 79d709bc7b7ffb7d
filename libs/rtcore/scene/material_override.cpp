#include "rtcore/scene/material_override.h"

#include "rtcore/scene/material_numbers.h"
#include "rtcore/scene/material_textures.h"

#include <algorithm>

namespace rtcore {

namespace {

/// `colour` cut down to what `taken` leaves of 1.
Colour remainder(Colour colour, Colour taken) {
    return {std::min(colour.r, 1 - taken.r), std::min(colour.g, 1 - taken.g),
            std::min(colour.b, 1 - taken.b)};
}

template <typename T, typename Field>
void apply(const std::optional<T>& value, Field& field) {
    if (value) field = static_cast<Field>(*value);
}

template <typename T>
void replace(std::optional<T>& value, const std::optional<T>& later) {
    if (later) value = later;
}

void leaveOutTextures(Material& m) {
    for (const auto texture : kMaterialTextures) m.*texture = kNoTexture;
}

} // namespace

void MaterialOverride::applyTo(Material& material, const TextureMeans& means) const {
    if (textures && !*textures) leaveOutTextures(material);
    apply(flipTextures, material.flipTextures);
    if (saysRoughness()) {
        const bool textured = material.metallicRoughnessTexture != kNoTexture;
        const float ownRoughness = roughnessOf(material) * (textured ? means.roughness : 1);
        const float ownMetallic = material.metallic * (textured ? means.metallic : 1);
        setMetallicRoughness(material, diffuse.value_or(material.diffuse), metallic.value_or(ownMetallic),
                             roughness.value_or(ownRoughness));
        material.metallicRoughnessTexture = kNoTexture;
    }
    if (saysPhong()) setPhong(material, means);
    if (!saysRoughness()) apply(diffuse, material.diffuse);
    apply(specular, material.specular);
    if (diffuse && !specular && !saysRoughness() && !hasRoughness(material))
        material.specular = remainder(material.specular, *diffuse);
    if (specular && (!diffuse || saysRoughness())) material.diffuse = remainder(material.diffuse, *specular);
    apply(shininess, material.shininess);
    apply(reflectivity, material.mirror);
    if (reflectivity) material.mirrorScale = 1;
    apply(fresnel, material.fresnel);
    apply(transmission, material.transmission);
    for (const MaterialNumber& each : kMaterialNumbers) apply(this->*each.change, material.*each.field);
    apply(emission, material.emission);
}

void MaterialOverride::add(const MaterialOverride& later) {
    if (later.saysRoughness()) {
        specular.reset();
        shininess.reset();
        reflectivity.reset();
        fresnel.reset();
    }
    const bool tooMuch = later.diffuse && specular && maxComponent(*later.diffuse + *specular) > 1;
    if (tooMuch) specular.reset();
    const bool tooBright = later.specular && diffuse && maxComponent(*later.specular + *diffuse) > 1;
    if (tooBright) diffuse.reset();
    replace(diffuse, later.diffuse);
    replace(specular, later.specular);
    replace(transmission, later.transmission);
    replace(emission, later.emission);
    replace(reflectivity, later.reflectivity);
    replace(shininess, later.shininess);
    for (const MaterialNumber& each : kMaterialNumbers) replace(this->*each.change, later.*each.change);
    replace(roughness, later.roughness);
    replace(metallic, later.metallic);
    replace(fresnel, later.fresnel);
    replace(textures, later.textures);
    replace(flipTextures, later.flipTextures);
    replace(diffuseTexture, later.diffuseTexture);
}

bool MaterialOverride::changes() const {
    MaterialOverride named;
    named.pattern = pattern;
    named.number = number;
    return *this != named;
}

} // namespace rtcore
