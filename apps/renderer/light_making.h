/// Renderer --make-light: a file of indirect light, made before anyone walks.
#pragma once

#include "renderer/light_learning.h"

#include "common/progress/progress.h"

#include <filesystem>
#include <span>

namespace renderer {

/// Learns the light of these views and replaces `path` by it; goes on where a file of the same scene and
/// light is there already. Stopped, it keeps what was learned until then and throws rtcore::FileError
/// Stopped; also CannotWrite, and BadData for a file that is no file of light.
void makeLight(const std::filesystem::path& path, const LitScene& lit, std::span<const LightView> views,
               const LightBounds& bounds, int threads, app::Progress& progress);

} // namespace renderer
