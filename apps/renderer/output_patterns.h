/// Where the images of a run go when the command line does not say.
#pragma once

#include "renderer/renderer_options.h"

#include "rtcore/io/text/scn.h"

#include <filesystem>
#include <vector>

namespace renderer {

/// The patterns of the command line; none when only a film was asked for; else the output that `scene` (null
/// for what is no .scn) names, else the scene's name in the current folder. Throws rtcore::FileError BadData
/// when the scene's output cannot be written or lies, links followed, outside of the scene's folder.
std::vector<std::filesystem::path> outputPatterns(const RendererOptions& options,
                                                  const rtcore::SceneFile* scene);

} // namespace renderer
