/// Edits of materials as the [[material]] tables of a scene's file.
#pragma once

#include "rtcore/io/text/scn.h"
#include "rtcore/scene/material_override.h"
#include "rtcore/scene/scene.h"

#include <vector>

namespace rtserver {

/// Adds what was edited in `scene` to the tables that it was loaded by. The last one for a material takes an
/// edit up where it is for that material alone and gives the same material; otherwise the edit is a table at
/// the end. However often a scene is edited, saved and loaded, a material has one table of its own. Tables
/// name materials that have a name of their own by it, which stays when the model's file changes.
void addMaterialEdits(const rtcore::Scene& scene, std::vector<rtcore::MaterialOverride>& tables);

} // namespace rtserver
