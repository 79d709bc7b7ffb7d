/// Content of model files that Assimp ignores without a word, found in their text.
#pragma once

#include "rtcore/platform/sentence.h"

#include <filesystem>
#include <vector>

namespace rtcore {

/// Forms of what is to be said of a Collada file (.dae): textures that do not repeat, orthographic cameras.
/// Nothing when the file is no .dae.
std::vector<const char*> unreadInCollada(const std::filesystem::path& path);

/// What is to be said of an .x3d file: text and other nodes that Assimp does not know, files
/// that are not there, levels of detail.
/// Nothing when the file is none, or no sound XML.
std::vector<Sentence> unreadInX3d(const std::filesystem::path& path);

} // namespace rtcore
