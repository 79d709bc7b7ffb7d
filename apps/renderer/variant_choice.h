/// Which variants of a scene are rendered, and showing one.
#pragma once

#include "renderer/renderer_options.h"

#include "rtcore/io/scene_loader.h"

#include <string>
#include <vector>

namespace renderer {

/// One run for each variant that `options` asks for: of all variants of the scene, each with the variant's
/// name in the names of its outputs. Reads the .scn, but no model. Throws rtcore::FileError NoInput where the
/// scene has no such variant, with the names of those that it has.
std::vector<RendererOptions> runsOf(const RendererOptions& options);

/// The name as a part of a file's name: letters, digits and dots stay, others become '-'.
std::string fileWordOf(const std::string& name);

/// `path` with "_WORD" before its extension; `path` where `word` is empty.
std::filesystem::path withWord(const std::filesystem::path& path, const std::string& word);

/// The scene as its file shows it, or as the variant does that was asked for. skyLight.on comes behind the
/// scene's own settings.
void showVariant(const RendererOptions& options, rtcore::LoadedScene& loaded);

} // namespace renderer
