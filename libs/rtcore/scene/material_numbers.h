/// Numbers of a material that scene files and edits set as they are, one row each: .scn files are read and
/// written, materials changed and .bsp files checked by it.
#pragma once

#include "rtcore/scene/material.h"

#include <limits>
#include <optional>

namespace rtcore {

/// Changes of these numbers by a scene file or an edit; absent ones stay.
struct MaterialNumberChanges {
    std::optional<float> opacity = {}, attenuationDistance = {}, indexOfRefraction = {}, priority = {},
                         coat = {}, coatRoughness = {};

    friend bool operator==(const MaterialNumberChanges&, const MaterialNumberChanges&) = default;
};

struct MaterialNumber {
    const char* key;
    std::optional<float> MaterialNumberChanges::*change;
    float Material::*field;
    float minimum, maximum;
    int version; ///< of .scn files, in which the key came
    bool whole = false;
};

inline constexpr float kUnlimitedNumber = std::numeric_limits<float>::max();

/// In the order in which they are written.
inline constexpr MaterialNumber kMaterialNumbers[] = {
    {"opacity", &MaterialNumberChanges::opacity, &Material::opacity, 0, 1, 1},
    {"attenuationDistance", &MaterialNumberChanges::attenuationDistance, &Material::attenuationDistance, 0,
     kUnlimitedNumber, 1},
    {"indexOfRefraction", &MaterialNumberChanges::indexOfRefraction, &Material::indexOfRefraction, 1, 5, 1},
    {"priority", &MaterialNumberChanges::priority, &Material::priority, 0, kMaxPriority, 2, true},
    {"coat", &MaterialNumberChanges::coat, &Material::coat, 0, 1, 2},
    {"coatRoughness", &MaterialNumberChanges::coatRoughness, &Material::coatRoughness, 0, 1, 2},
};

} // namespace rtcore
