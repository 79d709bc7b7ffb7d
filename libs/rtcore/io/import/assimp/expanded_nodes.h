/// Nodes that Assimp makes while it parses, counted before.
#pragma once

#include "rtcore/io/import/assimp/fbx_elements.h"

#include <cstdint>
#include <filesystem>
#include <vector>

namespace rtcore {

/// Throws FileError BadData where nodes of a Collada, FBX or glTF 1 file, which may name one many times,
/// stand for more than fit into so many bytes (0: any), or hold themselves. Other files, and damaged ones,
/// have none here. `fbx`: what readFbxElements() says of a file of that format. Throws as openFileBytes()
/// does.
void refuseManyNodes(const std::filesystem::path& path, const std::vector<FbxElement>& fbx,
                     std::uint64_t memoryLimit);

} // namespace rtcore
