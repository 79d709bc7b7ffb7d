/// The inner loop of the exact builder: a plane that sweeps over events, several at a time.
#pragma once

#include "rtcore/accel/events.h"

#include <cstddef>
#include <cstdint>
#include <limits>

namespace rtcore {

/// The cheapest plane of a sweep.
struct SweptPlane {
    float cost = std::numeric_limits<float>::infinity();
    const Event* event = nullptr; ///< it goes through; none: there is no plane
    std::uint32_t lower = 0;      ///< triangles on each side, but ends that follow `event` at its position
    std::uint32_t upper = 0;      ///< still count
    bool planarLower = false;
};

/// The first of the cheapest planes strictly inside the cell of `area`. CostModel::emptyFactor is at most 1.
///
/// Considers a plane at every event instead of every position: among equal ones only the last end and the
/// first start count right, but the others count more triangles and so are never cheaper. The same bits on
/// every instruction set.
SweptPlane sweepEvents(const Event* events, std::size_t count, std::uint32_t triangles,
                       const AreaOfParts& area, const CostModel& cost);

} // namespace rtcore
