/// The Renderer's command line as data; known without the ray tracer.
#pragma once

#include "common/cli/options.h"

namespace renderer {

/// The table of options.
const app::ProgramSpec& rendererSpec();

} // namespace renderer
