/// BSPBuilder's command line as data; known without the ray tracer.
#pragma once

#include "common/cli/options.h"

namespace bspbuilder {

/// The table of options.
const app::ProgramSpec& builderSpec();

} // namespace bspbuilder
