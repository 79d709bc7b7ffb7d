/// X3D files in the words that Assimp understands.
#pragma once

#include "rtcore/io/import/assimp/xml_tree.h"

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace rtcore {

/// The text of an .x3d file in which
/// - groups that are used again (USE) stand as copies, since Assimp closes a level too many behind them, as
/// it
///   does behind groups without content;
/// - Anchor, Billboard, Collision and StaticGroup are groups, LOD is its first level;
/// - cones stand upright;
/// - an image of several addresses has one: the first that is there, else the first;
/// - Inline has the first file that is there, in the model's folder or below, or shows nothing.
/// Nothing where the file is no .x3d, is no sound XML, or needs none of that. Throws as openFileBytes() does,
/// and FileError BadData where a group holds itself, groups are nested too deeply or copies are too large.
std::optional<std::string> x3dForAssimp(const std::filesystem::path& path);

/// The addresses of each Inline of a document of which no file is there, or none that may be read.
std::vector<std::string> x3dFilesLeftOut(std::span<const xml::Node> nodes, const std::filesystem::path& path);

/// Whether the file is X3D of text by its name.
bool isX3d(const std::filesystem::path& path);

} // namespace rtcore
