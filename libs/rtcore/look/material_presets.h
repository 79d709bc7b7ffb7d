/// Ready-made materials, by name.
#pragma once

#include "rtcore/scene/material_override.h"

#include <cstddef>
#include <span>
#include <string_view>

namespace rtcore {

inline constexpr std::size_t kMaterialPresets = 24;

/// The look says all that a [[material]] can say of roughness, metal, coat, glass and emission, and leaves
/// textures out; the priority of solids stays. It is for the material that it is given to: it has neither a
/// name nor a number. Where `attenuationDistance` is 0, glass tints light once, whatever its size.
struct MaterialPreset {
    const char* name; ///< English, lower case, without blanks; a form, so that it can be translated
    MaterialOverride look;
};

/// All of them, related ones together. Safe from many threads.
std::span<const MaterialPreset> materialPresets();

/// Throws BadValue, with the nearest name, where none has that name.
const MaterialPreset& materialPresetNamed(std::string_view name);

} // namespace rtcore
