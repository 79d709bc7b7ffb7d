/// Points at random, none of them near another.
#pragma once

#include "rtcore/sampling/sample_id.h"

#include <vector>

namespace rtcore {

/// The distance between neighbours if `count` points lay as far apart as the plane allows: sqrt(2 / (sqrt(3)
/// count)).
float largestPoissonDistance(int count);

/// `count` points of the unit torus, at least about 0.7 of the largest distance apart, so that they may be
/// shifted and repeat without seams. Always the same. They stand in rows from top to bottom, from left to
/// right in each: neighbours in the list are near each other. By throwing darts at a radius that shrinks
/// when nothing fits (McCool and Fiume 1992). Milliseconds for 256 points.
std::vector<SquarePoint> poissonDisc(int count);

} // namespace rtcore
