/// All textures that a material names.
#pragma once

#include "rtcore/scene/material.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>

namespace rtcore {

inline constexpr std::array kMaterialTextures{&Material::diffuseTexture,
                                              &Material::alphaTexture,
                                              &Material::normalTexture,
                                              &Material::emissionTexture,
                                              &Material::metallicRoughnessTexture,
                                              &Material::transmissionTexture,
                                              &Material::specularTexture};

/// A material without textures: each of its textures is kNoTexture, and nothing else is.
inline constexpr auto kWordsOfPlainMaterial =
    std::bit_cast<std::array<std::uint32_t, sizeof(Material) / sizeof(std::uint32_t)>>(Material{});
static_assert(std::ranges::count(kWordsOfPlainMaterial, kNoTexture) == std::ssize(kMaterialTextures),
              "a texture of Material is missing in kMaterialTextures");

inline bool hasTextures(const Material& m) {
    return std::ranges::any_of(kMaterialTextures, [&](auto texture) { return m.*texture != kNoTexture; });
}

} // namespace rtcore
