/// Materials of .bsp files of version 3, which are still read: those with a roughness hold what Phong's model
/// makes of them.
#pragma once

#include "rtcore/scene/model.h"

#include <vector>

namespace rtcore {

/// The materials of a checked model of that version as Material has them now: with the colours that the lobes
/// were made from.
std::vector<Material> materialsOfVersion3(const Model& model);

} // namespace rtcore
