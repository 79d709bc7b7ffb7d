/// Facts about a glTF file that Assimp does not hand over.
#pragma once

#include "rtcore/platform/sentence.h"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace rtcore {

struct GltfFile {
    std::vector<std::string> missingBuffers; ///< files that it names and that are not there
    std::vector<float> emissiveStrengths;    ///< by material; KHR_materials_emissive_strength
    std::vector<std::string>
        ignoredExtensions; ///< that it uses but does not require, and that change what is seen
    /// Extensions that it requires and that are not read, without those of materials, which are only ignored.
    std::vector<std::string> unreadRequirements;
    bool geometryUnread = false; ///< one of these says how positions are stored
    std::string generator;       ///< the program that wrote it; may be ""
    /// The triangles in the meshes of the scene that is shown, as their primitives declare them.
    std::uint64_t triangles = 0;
    /// Numbers of vertices; colours of primitives with so many have an alpha.
    std::set<std::uint64_t> countsWithAlpha;
};

/// A remedy for an extension that is not read, as the end of a sentence.
Sentence remedyFor(const std::string& extension);

/// Nothing when it is no glTF 2 (.gltf or .glb, by content), or its JSON is damaged.
std::optional<GltfFile> readGltfFile(const std::filesystem::path& path);

/// Why no reader takes a file that is glTF by its content or its name: its version, or where it is damaged;
/// what to do, as one sentence without a name. Nothing when it is no glTF, or no reason is found.
std::optional<Sentence> gltfDamage(const std::filesystem::path& path);

} // namespace rtcore
