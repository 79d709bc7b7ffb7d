#include "rtcore/io/variants/material_words.h"

#include "rtcore/io/text/pattern.h"
#include "rtcore/scene/material_edit.h"
#include "rtcore/scene/material_textures.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <string_view>
#include <utility>

namespace rtcore {

namespace {

std::string_view nameAt(const Scene& scene, std::size_t index) {
    return scene.model.name(scene.materials[index].nameOffset);
}

template <typename T>
void sayOther(std::optional<T>& word, const T& from, const T& to) {
    if (from != to) word = to;
}

Colour meanOr1(const Model& model, std::uint32_t texture) {
    return texture == kNoTexture ? kWhite : textureMean(model, texture);
}

/// What textures make of a material on the average, without holes and the normal map.
void tellMeans(const Model& model, Material& m) {
    const TextureMeans means = roughnessMeans(model, m);
    const Colour specular = meanOr1(model, m.specularTexture);
    m.diffuse = m.diffuse * meanOr1(model, m.diffuseTexture);
    m.emission = m.emission * meanOr1(model, m.emissionTexture);
    if (!hasRoughness(m)) {
        m.specular = m.specular * specular;
        m.mirror = m.mirror * specular;
    } else {
        m.roughness *= means.roughness;
        m.metallic *= means.metallic;
    }
    if (m.transmissionTexture != kNoTexture)
        m.opacity = 1 - (1 - m.opacity) * textureMean(model, m.transmissionTexture).r;
}

/// All that differs but the words of a kind.
MaterialOverride otherWords(const Material& from, const Material& to) {
    MaterialOverride words;
    sayOther(words.diffuse, from.diffuse, to.diffuse);
    sayOther(words.transmission, from.transmission, to.transmission);
    sayOther(words.emission, from.emission, to.emission);
    for (const MaterialNumber& each : kMaterialNumbers)
        sayOther(words.*each.change, from.*each.field, to.*each.field);
    if (from.flipTextures != to.flipTextures) words.flipTextures = to.flipTextures != 0;
    if (hasTextures(from) && !hasTextures(to)) words.textures = false;
    return words;
}

} // namespace

bool isFor(const MaterialOverride& table, const Scene& scene, std::size_t index) {
    return table.number ? static_cast<std::size_t>(*table.number) == index + 1
                        : matchesPattern(table.pattern, nameAt(scene, index));
}

bool isForOne(const MaterialOverride& table, const Scene& scene) {
    std::size_t found = 0;
    for (std::size_t i = 0; i < scene.materials.size(); ++i) found += isFor(table, scene, i) ? 1 : 0;
    return found == 1 && (table.number || !isPattern(table.pattern));
}

void nameMaterial(const Scene& scene, std::size_t index, MaterialOverride& table) {
    MaterialOverride named;
    named.pattern = nameAt(scene, index);
    if (named.pattern.empty() || !isForOne(named, scene)) return;
    table.pattern = named.pattern;
    table.number.reset();
}

bool looksAs(Material a, Material b) {
    for (Material* each : {&a, &b}) {
        if (isBlack(each->mirror)) each->mirrorScale = 1;
    }
    return a == b;
}

MaterialOverride speltOut(MaterialOverride table, const Material& shown) {
    table.diffuse = shown.diffuse;
    table.roughness.reset();
    table.metallic.reset();
    table.specular.reset();
    table.shininess.reset();
    table.reflectivity.reset();
    table.fresnel.reset();
    if (hasRoughness(shown)) {
        table.roughness = shown.roughness;
        table.metallic = shown.metallic;
        return table;
    }
    table.coat.reset();
    table.specular = shown.specular;
    table.shininess = shown.shininess;
    table.fresnel = shown.fresnel != 0;
    if (shown.mirrorScale == 1) table.reflectivity = shown.mirror;
    return table;
}

MaterialOverride lookOf(const Model& model, const Material& shown, const Material& to) {
    const bool same = hasTextures(shown) && std::ranges::all_of(kMaterialTextures, [&](auto texture) {
                          return shown.*texture == to.*texture;
                      });
    Material m = shown;
    if (!same) tellMeans(model, m);
    MaterialOverride look;
    for (const MaterialNumber& each : kMaterialNumbers) look.*each.change = m.*each.field;
    look = speltOut(look, m);
    if (!hasRoughness(m)) {
        look.reflectivity = m.mirror * m.mirrorScale;
        look.coat = 0.0F; // it lies over roughness alone
    }
    look.transmission = m.transmission;
    look.emission = m.emission;
    look.textures = same;
    if (same) look.flipTextures = m.flipTextures != 0;
    return look;
}

MaterialOverride changeBetween(const Model& model, const Material& from, const Material& to,
                               const MaterialOverride* edit) {
    const MaterialOverride other = otherWords(from, to);
    MaterialOverride made = edit != nullptr ? *edit : other;
    made.pattern.clear();
    made.number.reset();
    made.diffuseTexture.reset();
    for (const MaterialOverride& words : std::array{other, made, speltOut(made, to)})
        if (looksAs(changedMaterial(model, from, words), to)) return words;
    return speltOut(other, to);
}

} // namespace rtcore
