/// A run of the Renderer, from its command line to its exit code.
#pragma once

#include "common/cli/command_line.h"
#include "common/cli/options.h"
#include "common/process/exit_codes.h"

namespace renderer {

/// Loads the scene once and renders every frame that is asked for. A frame of a list whose .cam file is bad
/// is reported and left out; the exit code is then that of the first such frame. Anything else throws.
app::ExitCode runRenderer(const app::Arguments& arguments);

/// Whether there are weights of a net where they are looked for without --nets, for --version.
app::Feature netFeature();

} // namespace renderer
