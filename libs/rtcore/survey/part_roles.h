/// Clues to a model's up axis and kind in the names of its parts and materials.
#pragma once

#include "rtcore/scene/model.h"

#include <array>

namespace rtcore {

/// Parts named after parts of buildings, in English, German, French, Spanish, Italian, Czech, Polish,
/// Portuguese or Dutch.
struct PartRoles {
    std::array<double, 3> lying{};    ///< area of floors, ceilings and grounds across each axis; scene units
    std::array<double, 3> standing{}; ///< area of walls, doors and windows across each axis
    bool building = false;  ///< it has several of what only buildings have: floors, walls, stairs ...
    bool landscape = false; ///< not that, and most of it is ground, or it has a sky around it
};

/// A part's own name counts before its material's. Looks at a sample of at most some hundred thousand
/// triangles: the same for the same model.
PartRoles partRoles(const Model& model);

} // namespace rtcore
