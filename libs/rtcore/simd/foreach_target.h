/// Compiles the including source once for each instruction set; before it, the source defines
/// HWY_TARGET_INCLUDE as its own path. Comes before all headers named "-inl.h", which the loop includes again
/// each time.
#pragma once

#include "rtcore/simd/targets.h"

#include <hwy/foreach_target.h>
