/// DXF files in the words that Assimp understands.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace rtcore {

/// The text of a .dxf file in which faces of polyface meshes name their corners without signs. A minus says
/// that the edge behind the corner is invisible; Assimp drops such corners. Nothing where the file is no .dxf
/// or has none of these. Throws as openFileBytes() does.
std::optional<std::string> dxfForAssimp(const std::filesystem::path& path);

} // namespace rtcore
