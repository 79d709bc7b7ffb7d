#include "rtcore/accel/events.h"

#include <algorithm>
#include <cstring>

namespace rtcore {

namespace {

Event positionAndKind(Event e) { return e >> 30U; }

/// The sweep of a plane over the events of one axis.
class Sweep {
  public:
    Sweep(std::uint32_t triangles, const Box3& cell, int axis, const CostModel& cost)
        : area_(cell, axis), cost_(cost), axis_(axis), upper_(triangles) {}

    Split best() const { return best_; }

    /// Passes planes on the lower face of the cell, which are none. Returns where the others begin.
    const Event* skipLowerFace(const Event* e, const Event* end) {
        const std::uint32_t face = orderedBits(area_.lo);
        for (; e != end && *e >> 32U <= face; ++e) {
            lower_ += eventKind(*e) != EventKind::End ? 1 : 0;
            upper_ -= eventKind(*e) != EventKind::Start ? 1 : 0;
        }
        return e;
    }
    /// The end of what precedes the planes on the upper face of the cell.
    const Event* withoutUpperFace(const Event* e, const Event* end) const {
        const std::uint32_t face = orderedBits(area_.hi);
        while (end != e && end[-1] >> 32U >= face) --end;
        return end;
    }

    /// All events at the position of the first, whose sides may be empty. Returns where the next begin.
    const Event* passPosition(const Event* e, const Event* end) {
        const Event position = *e >> 32U << 2U;
        std::uint32_t planar = 0;
        for (; e != end && positionAndKind(*e) == position; ++e) --upper_;
        for (; e != end && positionAndKind(*e) == (position | 1U); ++e) ++planar;
        const float p = fromOrderedBits(static_cast<std::uint32_t>(position >> 2U));
        consider(p, lower_, upper_, false);
        upper_ -= planar;
        lower_ += planar;
        if (planar > 0) consider(p, lower_, upper_, true);
        for (; e != end && positionAndKind(*e) == (position | 2U); ++e) ++lower_;
        return e;
    }

    /// Positions with triangles on both sides, up to `end`, where a position begins. Considers a plane at
    /// every event instead of every position: among equal ones only the last end and the first start count
    /// right, but the others count more triangles and so are never cheaper. That leaves no branch to
    /// mispredict.
    void passOccupied(const Event* e, const Event* end) {
        const float traversal = cost_.traversal;
        const float intersection = cost_.intersection;
        const AreaOfParts area = area_;
        float best = best_.cost;
        const Event* cheapest = nullptr;
        std::uint32_t lower = lower_;
        std::uint32_t upper = upper_;
        while (e != end) {
            const Event event = *e;
            if (eventKind(event) == EventKind::Planar) {
                lower_ = lower;
                upper_ = upper;
                best_.cost = best;
                settle(cheapest, end);
                cheapest = nullptr;
                e = passPosition(e, end);
                lower = lower_;
                upper = upper_;
                best = best_.cost;
                continue;
            }
            const std::uint32_t start = static_cast<std::uint32_t>(event >> 31U) & 1U;
            upper -= 1 - start;
            const float p = eventPosition(event);
            const float c =
                traversal +
                intersection * (area.lower(p) * static_cast<float>(static_cast<std::int32_t>(lower)) +
                                area.upper(p) * static_cast<float>(static_cast<std::int32_t>(upper)));
            if (c < best) {
                best = c;
                cheapest = e;
                best_.lower = lower;
                best_.upper = upper;
            }
            lower += start;
            ++e;
        }
        lower_ = lower;
        upper_ = upper;
        best_.cost = best;
        settle(cheapest, end);
    }

  private:
    void consider(float position, std::uint32_t lower, std::uint32_t upper, bool planarLower) {
        const float cost = cost_.split(area_.lower(position), area_.upper(position), lower, upper);
        if (cost < best_.cost) best_ = {cost, position, axis_, planarLower, lower, upper};
    }

    /// Completes the best split when it is the one at `e`: other ends at its position follow.
    void settle(const Event* e, const Event* end) {
        if (e == nullptr) return;
        best_.position = eventPosition(*e);
        best_.axis = axis_;
        best_.planarLower = false;
        if (eventKind(*e) != EventKind::End) return;
        const Event kind = positionAndKind(*e);
        while (++e != end && positionAndKind(*e) == kind) --best_.upper;
    }

    AreaOfParts area_;
    const CostModel& cost_;
    int axis_;
    Split best_;
    std::uint32_t lower_ = 0;
    std::uint32_t upper_;
};

} // namespace

Split cheapestSplit(const Event* events, std::size_t count, std::uint32_t triangles, const Box3& cell,
                    int axis, const CostModel& cost) {
    Sweep sweep(triangles, cell, axis, cost);
    const Event* e = sweep.skipLowerFace(events, events + count);
    const Event* const end = sweep.withoutUpperFace(e, events + count);
    if (e == end) return sweep.best();
    e = sweep.passPosition(e, end);
    if (e == end) return sweep.best();
    const Event* last = end - 1;
    while (last != e && last[-1] >> 32U == *last >> 32U) --last;
    sweep.passOccupied(e, last);
    sweep.passPosition(last, end);
    return sweep.best();
}

void classify(const Event* events, std::size_t count, const Split& split, Side* sides,
              std::vector<std::uint32_t>& straddling) {
    const Event plane = static_cast<Event>(orderedBits(split.position)) << 32U;
    const Event* const end = events + count;
    const Event* const inPlane = std::lower_bound(events, end, plane);
    const Event* const after = std::lower_bound(inPlane, end, plane + (Event{1} << 32U));
    // Whoever ends above the plane is there, unless it begins below: then its start finds it on both sides.
    for (const Event* e = after; e != end; ++e) sides[eventTriangle(*e)] = Side::Upper;
    for (const Event* e = events; e != inPlane; ++e) {
        sides[eventTriangle(*e)] = eventKind(*e) == EventKind::Start ? Side::Both : Side::Lower;
    }
    for (const Event* e = inPlane; e != after; ++e) {
        const EventKind kind = eventKind(*e);
        const bool isLower = kind == EventKind::End || (kind == EventKind::Planar && split.planarLower);
        sides[eventTriangle(*e)] = isLower ? Side::Lower : Side::Upper;
    }
    // Both starts below and ends above name the straddling ones; the shorter part is quicker to read.
    const bool above = end - after < inPlane - events;
    const EventKind wanted = above ? EventKind::End : EventKind::Start;
    for (const Event* e = above ? after : events; e != (above ? end : inPlane); ++e) {
        if (sides[eventTriangle(*e)] == Side::Both && eventKind(*e) == wanted) {
            straddling.push_back(eventTriangle(*e));
        }
    }
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
