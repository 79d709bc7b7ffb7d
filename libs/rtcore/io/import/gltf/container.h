/// The two forms of a glTF file: JSON alone, and JSON with a binary chunk behind it (.glb).
#pragma once

#include "rtcore/io/import/gltf/json_members.h"
#include "rtcore/platform/files.h"

#include <cstdint>
#include <filesystem>
#include <optional>

namespace rtcore::gltf {

struct Container {
    InputFile file;
    Json root;                                 ///< an object of asset version 2
    std::uint64_t binary = 0, binaryBytes = 0; ///< where the chunk of buffer 0 stands in the file; 0, 0: none
};

/// Nothing where the name is not that of glTF 2 (.gltf, .glb, .vrm, or without an ending), or the content is
/// not: other readers may have a word for it. A chunk that the file is too short for is as long as it is
/// there. JSON with bytes that are no UTF-8 is read as if these were Latin-1. Throws as openFileBytes() does.
std::optional<Container> openContainer(const std::filesystem::path& path);

} // namespace rtcore::gltf
