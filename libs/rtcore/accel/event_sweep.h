/// The inner loop of the exact builder: a plane that sweeps over events, several at a time.
#pragma once

#include "rtcore/accel/events.h"

#include <cstddef>
#include <cstdint>

namespace rtcore {

/// Triangles on each side of the plane before an event, and the cheapest plane so far.
struct SweepState {
    float traversal, intersection; ///< of the CostModel
    AreaOfParts area;

    std::uint32_t lower, upper; ///< triangles on each side; a flat one in the plane counts as upper

    float cost;            ///< of the cheapest plane
    const Event* cheapest; ///< the event that it goes through; null: none yet, `cost` is a limit
    std::uint32_t cheapestLower, cheapestUpper;
    bool planarLower;
};

/// Moves the plane over the first events, nearly all, and returns how many. events[-1] and events[count] must
/// exist, and events[-1] and what is in `state` be at another position than events[0].
/// Neither side may be empty between them.
///
/// Considers a plane at every event instead of every position: among equal ones only the last end and the
/// first start count right, but the others count more triangles and so are never cheaper. Of equally cheap
/// planes the first counts. The same bits on every instruction set.
std::size_t sweepBlocks(const Event* events, std::size_t count, SweepState& state);

/// The flat triangle of event `e`, with `state` before it, which it does not change but for the cheapest
/// plane. Only the whole run of flat ones at a position may change sides: considers a plane before the first
/// and after the last.
inline void considerPlanar(const Event* e, std::uint32_t lower, std::uint32_t upper, SweepState& state) {
    const float p = eventPosition(*e);
    const auto consider = [&](std::uint32_t below, std::uint32_t above, bool planarLower) {
        const float cost =
            state.traversal + state.intersection * (state.area.lower(p) * static_cast<float>(below) +
                                                    state.area.upper(p) * static_cast<float>(above));
        if (!(cost < state.cost)) return;
        state.cost = cost;
        state.cheapest = e;
        state.cheapestLower = below;
        state.cheapestUpper = above;
        state.planarLower = planarLower;
    };
    if (e[-1] >> 30U != *e >> 30U) consider(lower, upper, false);
    if (e[1] >> 30U != *e >> 30U) consider(lower + 1, upper - 1, true);
}

} // namespace rtcore
