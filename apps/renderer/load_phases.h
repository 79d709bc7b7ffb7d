/// Loading a scene with progress shown and Ctrl-C heeded.
#pragma once

#include "renderer/renderer_options.h"

#include "common/progress.h"

#include "rtcore/io/scene_loader.h"

namespace renderer {

/// rtcore::loadScene with the limits that `options` sets. Prints the loader's warnings, and the time of each
/// phase with --verbose. Throws rtcore::FileError.
rtcore::LoadedScene loadWithProgress(const RendererOptions& options, app::Progress& progress);

} // namespace renderer
