/// The light that a scene is first seen in.
#pragma once

#include "rtcore/io/loading/loading.h"

namespace rtcore {

/// The look that the options name, or else a light for what has none, or none that reaches what is seen.
void giveLight(Loading& loading);

} // namespace rtcore
