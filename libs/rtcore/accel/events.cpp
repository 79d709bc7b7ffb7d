#include "rtcore/accel/events.h"

#include "rtcore/accel/event_sweep.h"

#include <algorithm>
#include <array>
#include <cstring>

namespace rtcore {

Split cheapestSplit(const Event* events, std::size_t count, std::uint32_t triangles, const Box3& cell,
                    int axis, const CostModel& cost) {
    const SweptPlane plane = sweepEvents(events, count, triangles, AreaOfParts(cell, axis), cost);
    const Event* e = plane.event;
    if (e == nullptr) return {};
    Split split{plane.cost, eventPosition(*e), axis, plane.planarLower, plane.lower, plane.upper};
    if (eventKind(*e) != EventKind::End) return split;
    const Event positionAndKind = *e >> 30U;
    while (++e != events + count && *e >> 30U == positionAndKind) --split.upper;
    return split;
}

AlongSplit divideAlong(Event* events, std::size_t count, const Split& split, Side* sides, Event* lower,
                       std::vector<std::uint32_t>& straddling) {
    const EventKind firstUpper = split.planarLower ? EventKind::Start : EventKind::Planar;
    Event* const end = events + count;
    Event* const border = std::lower_bound(events, end, makeEvent(split.position, firstUpper, 0));
    // A triangle that ends above is on the upper side, unless it begins below: then its start event puts it
    // on both sides.
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
        const auto side = static_cast<unsigned>(sides[eventTriangle(e)]);
        *l = e;
        l += side & 1U; // Side::Lower
        *u = e;
        u += side >> 1U; // Side::Upper
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
            std::array<Event, kBlock> block; // since both may overlap
            std::memcpy(block.data(), events + left, sizeof block);
            std::memcpy(events + out, block.data(), sizeof block);
        }
        const bool takeOld = left > 0 && events[left - 1] > added[right - 1];
        events[--out] = takeOld ? events[--left] : added[--right];
    }
    return count + added.size();
}

} // namespace rtcore
