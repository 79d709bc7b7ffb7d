/// The check of rendered files by `Renderer --verify`.
#pragma once

#include "renderer/renderer_options.h"

#include "common/process/exit_codes.h"
#include "common/progress/progress.h"

namespace renderer {

/// Prints a line for each file of the list's frames that is missing or broken: the frame's number, the file,
/// and "missing" or "broken: why", separated by tabs. Done when there is none, else Failed. Neither the
/// scene's model nor the .cam files are looked at. Throws as readCameraList and findFlaws do.
app::ExitCode verifyFrames(const RendererOptions& options, app::Progress& progress);

} // namespace renderer
