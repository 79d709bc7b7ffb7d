/// X3D files in the words that Assimp understands.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace rtcore {

/// The text of an .x3d file in which
/// - groups that are used again (USE) stand as copies, since Assimp closes a level too many behind them, as
/// it
///   does behind groups without content;
/// - Anchor, Billboard, Collision and StaticGroup are groups, LOD is its first level;
/// - cones stand upright;
/// - an image or file of several addresses has one: the first that is there, else the first.
/// Nothing where the file is no .x3d, is no sound XML, or needs none of that. Throws as openFileBytes() does,
/// and FileError BadData where a group holds itself, groups are nested too deeply or copies are too large.
std::optional<std::string> x3dForAssimp(const std::filesystem::path& path);

/// Whether the file is X3D of text by its name.
bool isX3d(const std::filesystem::path& path);

} // namespace rtcore
