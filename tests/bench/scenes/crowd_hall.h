/// Fifty figures of 20,000 small triangles each that stand close together in a furnished hall, all of whose
/// boards, slats and benches are strips 1,500 times as long as wide: what trees find hardest, side by side.
#pragma once

#include "support/sample_meshes.h"

namespace bench {

/// Always the same. Metres, y is up; the hall is 30 long (x), 6 high and 12 wide (z), from the origin on.
test::SampleMesh crowdInHall();

} // namespace bench
