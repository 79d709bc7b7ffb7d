/// The sections of a .scn for the model's materials.
#pragma once

#include "rtcore/io/loading/loading.h"

#include <filesystem>

namespace rtcore {

/// Changes the materials, with the images that they are given in place of the model's. `path` of the .scn.
void overrideMaterials(Loading& loading, const std::filesystem::path& path, const SceneFile& file);

} // namespace rtcore
