/// Content of AC3D files, found in their text.
#pragma once

#include <filesystem>

namespace rtcore {

/// Whether an object of an .ac file has both a texture and a subdivision, which smears the one along seams:
/// Assimp subdivides texture coordinates as if they were one surface. False where the file is no .ac.
/// Throws as openFileBytes() does.
bool subdividesTextures(const std::filesystem::path& path);

} // namespace rtcore
