/// Loading a scene with progress shown and Ctrl-C heeded.
#pragma once

#include "renderer/renderer_options.h"

#include "common/progress/progress.h"

#include "rtcore/io/scene_loader.h"

#include <cstdint>

namespace renderer {

/// rtcore::loadScene with the limits that `options` sets. Prints the loader's warnings, and the time of each
/// phase with --verbose. Throws rtcore::FileError.
rtcore::LoadedScene loadWithProgress(const RendererOptions& options, app::Progress& progress);

/// The primary rays of a single image whose size no file can change; else 0.
std::uint64_t knownRays(const RendererOptions& options);

} // namespace renderer
