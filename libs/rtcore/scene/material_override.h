/// Changes of the model's materials by a scene file or an edit.
#pragma once

#include "rtcore/math/colour.h"
#include "rtcore/scene/material_numbers.h"
#include "rtcore/scene/metallic_roughness.h"

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace rtcore {

/// Names materials by exactly one of the first two. What is absent stays. Ranges as in Material.
struct MaterialOverride : MaterialNumberChanges {
    std::string pattern = {};       ///< for names, with * and ? (matchesPattern()); "": by number
    std::optional<int> number = {}; ///< one of the model's materials, counted from 1
    std::optional<Colour> diffuse = {}, specular = {}, transmission = {}, emission = {};
    std::optional<Colour> reflectivity = {}; ///< the material's `mirror`, with a mirrorScale of 1
    std::optional<float> shininess = {};
    /// Each of them, or a coat, makes the material one of setMetallicRoughness() that is the same everywhere:
    /// its texture of both goes. Each of `specular`, `shininess`, `reflectivity` and `fresnel` makes it one
    /// of setPhong(); with both it is Phong's model of that roughness.
    std::optional<float> roughness = {}, metallic = {};
    std::optional<bool> fresnel = {};
    std::optional<bool> textures = {};                        ///< false: none of the material's own
    std::optional<bool> flipTextures = {};                    ///< whether these are turned upside down
    std::optional<std::filesystem::path> diffuseTexture = {}; ///< loaded by the scene loader

    bool saysRoughness() const { return roughness || metallic || coat.value_or(0) > 0; }
    bool saysPhong() const { return specular || shininess || reflectivity || fresnel; }
    /// applyTo() needs the means of textures.
    bool needsMeans() const { return saysRoughness() || saysPhong(); }
    /// Applies all but the path of the texture. Where the sum of diffuse and specular would exceed 1, the one
    /// that is not overridden gives way. `means`: of the diffuse texture afterwards, and of the present one
    /// of roughness and metal.
    void applyTo(Material& material, const TextureMeans& means = {}) const;
    /// Adds `later`, which takes precedence. Applying one after the other would not always do the same, since
    /// a later value replaces all that say the same in other words: roughness replaces shininess. The name or
    /// number of the material stays.
    void add(const MaterialOverride& later);
    /// Anything but a name.
    bool changes() const;
    friend bool operator==(const MaterialOverride&, const MaterialOverride&) = default;
};

} // namespace rtcore
