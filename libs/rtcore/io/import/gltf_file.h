/// What Assimp does not tell about a glTF file.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace rtcore {

struct GltfFile {
    std::vector<std::string> missingBuffers;    ///< files that it names and that are not there
    std::vector<float> emissiveStrengths;       ///< by material; KHR_materials_emissive_strength
    std::vector<std::string> ignoredExtensions; ///< that it uses, and that change what is seen
    std::string generator;                      ///< the program that wrote it; may be ""
    std::uint64_t triangles = 0;                ///< of all meshes, as their primitives declare them
};

/// Nothing when it is no glTF 2 (.gltf or .glb, by content), or its JSON is damaged.
std::optional<GltfFile> readGltfFile(const std::filesystem::path& path);

} // namespace rtcore
