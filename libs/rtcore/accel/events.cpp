#include "rtcore/accel/events.h"

#include "rtcore/accel/event_sweep.h"

#include <algorithm>
#include <cstring>

namespace rtcore {

namespace {

/// The sweep of a plane over the events of one axis.
class Sweep {
  public:
    Sweep(std::uint32_t triangles, const Box3& cell, int axis, const CostModel& cost)
        : cost_(cost), axis_(axis), state_{cost.traversal,
                                           cost.intersection,
                                           AreaOfParts(cell, axis),
                                           0,
                                           triangles,
                                           Split{}.cost,
                                           nullptr,
                                           0,
                                           0,
                                           false} {}

    /// Passes planes on the lower face of the cell, which are none. Returns where the others begin.
    const Event* skipLowerFace(const Event* e, const Event* end) {
        const std::uint32_t face = orderedBits(state_.area.lo);
        for (; e != end && *e >> 32U <= face; ++e) {
            state_.lower += eventKind(*e) != EventKind::End ? 1 : 0;
            state_.upper -= eventKind(*e) != EventKind::Start ? 1 : 0;
        }
        return e;
    }
    /// The end of what precedes the planes on the upper face of the cell.
    const Event* withoutUpperFace(const Event* e, const Event* end) const {
        const std::uint32_t face = orderedBits(state_.area.hi);
        while (end != e && end[-1] >> 32U >= face) --end;
        return end;
    }

    /// All events at the position of the first, where a side may be empty. Returns where the next begin.
    const Event* passPosition(const Event* e, const Event* end) {
        const Event* plane = e;
        const Event position = *e >> 32U << 2U;
        std::uint32_t planar = 0;
        for (; e != end && *e >> 30U == position; ++e) {
            --state_.upper;
            plane = e;
        }
        for (; e != end && *e >> 30U == (position | 1U); ++e) ++planar;
        consider(plane, false);
        state_.upper -= planar;
        state_.lower += planar;
        if (planar > 0) consider(plane, true);
        for (; e != end && *e >> 30U == (position | 2U); ++e) ++state_.lower;
        return e;
    }

    /// Positions with triangles on both sides: from where a position begins to where one does.
    void passOccupied(const Event* e, const Event* end) {
        constexpr std::ptrdiff_t kMost = std::ptrdiff_t{1} << 30U;
        while (end - e >= 8) e += sweepBlocks(e, static_cast<std::size_t>(std::min(end - e, kMost)), state_);
        for (; e != end; ++e) {
            const EventKind kind = eventKind(*e);
            if (kind == EventKind::Planar) {
                considerPlanar(e, state_.lower, state_.upper, state_);
            } else {
                state_.upper -= kind == EventKind::End ? 1 : 0;
                consider(e, false);
                state_.upper += kind == EventKind::End ? 1 : 0;
            }
            state_.lower += kind != EventKind::End ? 1 : 0;
            state_.upper -= kind != EventKind::Start ? 1 : 0;
        }
    }

    /// `end` is that of all events.
    Split best(const Event* end) const {
        const Event* e = state_.cheapest;
        if (e == nullptr) return {};
        Split split{state_.cost,        eventPosition(*e),    axis_,
                    state_.planarLower, state_.cheapestLower, state_.cheapestUpper};
        // Triangles that end in the plane and were not yet counted out, since it cost the same.
        const Event positionAndKind = *e >> 30U;
        if (eventKind(*e) != EventKind::End) return split;
        while (++e != end && *e >> 30U == positionAndKind) --split.upper;
        return split;
    }

  private:
    void consider(const Event* e, bool planarLower) {
        const float p = eventPosition(*e);
        const float cost =
            cost_.split(state_.area.lower(p), state_.area.upper(p), state_.lower, state_.upper);
        if (!(cost < state_.cost)) return;
        state_.cost = cost;
        state_.cheapest = e;
        state_.cheapestLower = state_.lower;
        state_.cheapestUpper = state_.upper;
        state_.planarLower = planarLower;
    }

    const CostModel& cost_;
    int axis_;
    SweepState state_;
};

} // namespace

Split cheapestSplit(const Event* events, std::size_t count, std::uint32_t triangles, const Box3& cell,
                    int axis, const CostModel& cost) {
    Sweep sweep(triangles, cell, axis, cost);
    const Event* e = sweep.skipLowerFace(events, events + count);
    const Event* const end = sweep.withoutUpperFace(e, events + count);
    if (e == end) return {};
    e = sweep.passPosition(e, end);
    if (e == end) return sweep.best(end);
    const Event* last = end - 1;
    while (last != e && last[-1] >> 32U == *last >> 32U) --last;
    sweep.passOccupied(e, last);
    sweep.passPosition(last, end);
    return sweep.best(end);
}

AlongSplit divideAlong(Event* events, std::size_t count, const Split& split, Side* sides, Event* lower,
                       std::vector<std::uint32_t>& straddling) {
    const EventKind firstUpper = split.planarLower ? EventKind::Start : EventKind::Planar;
    Event* const end = events + count;
    Event* const border = std::lower_bound(events, end, makeEvent(split.position, firstUpper, 0));
    // Whoever ends above is there, unless it begins below: then its start finds it on both sides.
    for (const Event* e = border; e != end; ++e) sides[eventTriangle(*e)] = Side::Upper;
    for (const Event* e = events; e != border; ++e) {
        sides[eventTriangle(*e)] = eventKind(*e) == EventKind::Start ? Side::Both : Side::Lower;
    }
    Event* l = lower;
    for (const Event* e = events; e != border; ++e) {
        const bool both = sides[eventTriangle(*e)] == Side::Both;
        *l = *e;
        l += both ? 0 : 1;
        if (both) straddling.push_back(eventTriangle(*e));
    }
    if (straddling.empty()) {
        return {static_cast<std::size_t>(l - lower), static_cast<std::size_t>(border - events),
                static_cast<std::size_t>(end - border)};
    }
    Event* const upper = border - straddling.size();
    Event* u = upper;
    for (const Event* e = border; e != end; ++e) {
        *u = *e;
        u += sides[eventTriangle(*e)] != Side::Both ? 1 : 0;
    }
    return {static_cast<std::size_t>(l - lower), static_cast<std::size_t>(upper - events),
            static_cast<std::size_t>(u - upper)};
}

PartitionCounts partition(const Event* events, std::size_t count, const Side* sides, Event* lower,
                          Event* upper) {
    Event* l = lower;
    Event* u = upper;
    for (std::size_t i = 0; i < count; ++i) {
        const Event e = events[i];
        const Side side = sides[eventTriangle(e)];
        *l = e;
        l += side == Side::Lower ? 1 : 0;
        *u = e;
        u += side == Side::Upper ? 1 : 0;
    }
    return {static_cast<std::size_t>(l - lower), static_cast<std::size_t>(u - upper)};
}

std::size_t mergeEvents(Event* events, std::size_t count, const std::vector<Event>& added) {
    std::size_t left = count;
    std::size_t right = added.size();
    std::size_t out = count + added.size();
    constexpr std::size_t kBlock = 8;
    while (right > 0) {
        while (left >= kBlock && events[left - kBlock] > added[right - 1]) {
            left -= kBlock;
            out -= kBlock;
            std::memmove(events + out, events + left, kBlock * sizeof(Event));
        }
        const bool takeOld = left > 0 && events[left - 1] > added[right - 1];
        events[--out] = takeOld ? events[--left] : added[--right];
    }
    return count + added.size();
}

} // namespace rtcore
