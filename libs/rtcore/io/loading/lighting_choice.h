/// The sky or the environment map that a scene begins with.
#pragma once

#include "rtcore/io/loading/loading.h"

namespace rtcore {

/// Those of the options, in place of what the scene has. Settings of files win over that a sky lights.
void takeLightingOptions(Loading& loading);

} // namespace rtcore
