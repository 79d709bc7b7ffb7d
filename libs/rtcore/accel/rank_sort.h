/// Sorting a few events, where the mispredicted branches of a comparison sort cost more than comparing all
/// with all.
#pragma once

#include "rtcore/accel/events.h"

#include <cstddef>

namespace rtcore {

inline constexpr std::size_t kMaxRanked = 96;

/// Sorts `count` events, kMaxRanked at most, of which no two are equal.
void rankSort(Event* events, std::size_t count);

} // namespace rtcore
