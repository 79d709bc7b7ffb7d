/// The events of the exact builder: where the bound of a triangle begins or ends along one axis. An event is
/// one 64-bit key - position, kind, triangle - so that sorting and comparing are those of integers.
#pragma once

#include "rtcore/accel/cost_model.h"
#include "rtcore/accel/uninitialized_array.h"
#include "rtcore/math/box.h"

#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace rtcore {

using Event = std::uint64_t;

/// Ends come before what lies in the plane, and that before starts, so that one sweep counts in the right
/// order.
enum class EventKind : std::uint32_t { End = 0, Planar = 1, Start = 2 };

inline constexpr std::uint32_t kEventTriangleMask = (1U << 30U) - 1;

/// Floats as unsigned numbers of the same order; -0 counts as 0.
inline std::uint32_t orderedBits(float x) {
    const auto bits = std::bit_cast<std::uint32_t>(x + 0.0F);
    return (bits & 0x80000000U) != 0 ? ~bits : bits | 0x80000000U;
}
inline float fromOrderedBits(std::uint32_t ordered) {
    const std::uint32_t negative = (ordered >> 31U) - 1; // all ones or none: a choice without a branch
    return std::bit_cast<float>(ordered ^ (negative | 0x80000000U));
}

inline Event makeEvent(float position, EventKind kind, std::uint32_t triangle) {
    return static_cast<Event>(orderedBits(position)) << 32U | static_cast<Event>(kind) << 30U | triangle;
}
inline float eventPosition(Event e) { return fromOrderedBits(static_cast<std::uint32_t>(e >> 32U)); }
inline EventKind eventKind(Event e) { return static_cast<EventKind>(e >> 30U & 3U); }
inline std::uint32_t eventTriangle(Event e) { return static_cast<std::uint32_t>(e) & kEventTriangleMask; }

/// Writes the one or two events of what reaches from `lo` to `hi` and returns the position after them.
inline Event* writeEvents(float lo, float hi, std::uint32_t triangle, Event* out) {
    if (lo == hi) {
        *out++ = makeEvent(lo, EventKind::Planar, triangle);
    } else {
        *out++ = makeEvent(lo, EventKind::Start, triangle);
        *out++ = makeEvent(hi, EventKind::End, triangle);
    }
    return out;
}
inline Event* writeEvents(const Box3& box, int axis, std::uint32_t triangle, Event* out) {
    return writeEvents(box.lo[axis], box.hi[axis], triangle, out);
}

using EventList = UninitializedArray<Event>;

/// The cheapest plane across `axis` strictly inside `cell`; `triangles` is how many the node holds.
Split cheapestSplit(const Event* events, std::size_t count, std::uint32_t triangles, const Box3& cell,
                    int axis, const CostModel& cost);

/// A bit for each side that a triangle is on alone, so that counting needs no comparison.
enum class Side : std::uint8_t { Both = 0, Lower = 1, Upper = 2 };

/// Divides the events along split.axis: sets the `sides` of all their triangles, copies to `lower` (room for
/// `count` and one) the events of those on the lower side only, and moves together, in place, those of the
/// upper side only, so that two more for each triangle on both sides fit behind them. Appends those on both
/// sides to `straddling`, in the order of their starts; it must be empty before.
struct AlongSplit {
    std::size_t lower;      ///< how many are in `lower`
    std::size_t upperFirst; ///< where those of the upper side begin in `events`
    std::size_t upper;      ///< and how many they are
};
AlongSplit divideAlong(Event* events, std::size_t count, const Split& split, Side* sides, Event* lower,
                       std::vector<std::uint32_t>& straddling);

/// Copies the events of triangles that are on one side only, in order. `upper` may be `events` itself; both
/// outputs need room for `count` events. Returns how many went to each side.
struct PartitionCounts {
    std::size_t lower, upper;
};
PartitionCounts partition(const Event* events, std::size_t count, const Side* sides, Event* lower,
                          Event* upper);

/// Merges the sorted `added` into the sorted `events`, which has room for both. Returns the number of all.
std::size_t mergeEvents(Event* events, std::size_t count, const std::vector<Event>& added);

} // namespace rtcore
