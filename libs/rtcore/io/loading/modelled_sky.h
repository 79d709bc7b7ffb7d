/// Skies that were modelled around everything, as a dome.
#pragma once

#include "rtcore/io/loading/loading.h"

namespace rtcore {

/// Hides them, since they would keep the light out: their picture becomes an environment map where it can.
void hideDomes(Loading& loading);

} // namespace rtcore
