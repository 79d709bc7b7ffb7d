#include "rtcore/accel/events.h"

#include <algorithm>
#include <array>

namespace rtcore {

namespace {

/// Below this a comparison sort is quicker than three passes over counters.
constexpr std::size_t kRadixFrom = 4096;

/// One stable pass of a radix sort over `bits` bits from `shift`.
void radixPass(const std::vector<Event>& from, std::vector<Event>& to, unsigned shift, unsigned bits) {
    std::array<std::size_t, 4096> next{};
    const std::size_t mask = (std::size_t{1} << bits) - 1;
    for (const Event e : from) ++next[e >> shift & mask];
    std::size_t sum = 0;
    for (std::size_t i = 0; i <= mask; ++i) {
        const std::size_t count = next[i];
        next[i] = sum;
        sum += count;
    }
    for (const Event e : from) to[next[e >> shift & mask]++] = e;
}

} // namespace

void sortEvents(std::vector<Event>& events, std::vector<Event>& scratch) {
    if (events.size() < kRadixFrom) {
        std::sort(events.begin(), events.end());
        return;
    }
    // Kind and position are the upper 34 bits; the triangles below them are in order already.
    scratch.resize(events.size());
    radixPass(events, scratch, 30, 11);
    radixPass(scratch, events, 41, 11);
    radixPass(events, scratch, 52, 12);
    events.swap(scratch);
}

Split cheapestSplit(const Event* events, std::size_t count, std::uint32_t triangles, const Box3& cell,
                    int axis, const CostModel& cost) {
    Split best;
    const AreaOfParts area(cell, axis);
    std::uint32_t lower = 0;
    std::uint32_t upper = triangles;
    std::size_t i = 0;
    while (i < count) {
        const Event position = events[i] >> 32U << 2U;
        std::uint32_t ends = 0;
        std::uint32_t planar = 0;
        std::uint32_t starts = 0;
        for (; i < count && events[i] >> 30U == (position | 0U); ++i) ++ends;
        for (; i < count && events[i] >> 30U == (position | 1U); ++i) ++planar;
        for (; i < count && events[i] >> 30U == (position | 2U); ++i) ++starts;
        upper -= ends + planar;
        const float p = fromOrderedBits(static_cast<std::uint32_t>(position >> 2U));
        if (p > area.lo && p < area.hi) {
            const float lowerArea = area.lower(p);
            const float upperArea = area.upper(p);
            const float planarUpper = cost.split(lowerArea, upperArea, lower, upper + planar);
            if (planarUpper < best.cost) best = {planarUpper, p, axis, false};
            if (planar > 0) {
                const float planarLower = cost.split(lowerArea, upperArea, lower + planar, upper);
                if (planarLower < best.cost) best = {planarLower, p, axis, true};
            }
        }
        lower += starts + planar;
    }
    return best;
}

void classify(const Event* events, std::size_t count, const Split& split, Side* sides,
              std::vector<std::uint32_t>& straddling) {
    const std::uint32_t plane = orderedBits(split.position);
    const Event* const end = events + count;
    const Event* e = events;
    // Before the plane nothing is decided but that a triangle begins; its end or the plane tells the rest.
    for (; e != end && *e >> 32U < plane; ++e) {
        sides[eventTriangle(*e)] = eventKind(*e) == EventKind::Start ? Side::Both : Side::Lower;
    }
    for (; e != end && *e >> 32U == plane; ++e) {
        const EventKind kind = eventKind(*e);
        const bool isLower = kind == EventKind::End || (kind == EventKind::Planar && split.planarLower);
        sides[eventTriangle(*e)] = isLower ? Side::Lower : Side::Upper;
    }
    for (; e != end; ++e) {
        // The end of a triangle that began before the plane leaves it on both sides.
        if (eventKind(*e) != EventKind::End) sides[eventTriangle(*e)] = Side::Upper;
    }
    for (e = events; e != end && *e >> 32U < plane; ++e) {
        if (eventKind(*e) == EventKind::Start && sides[eventTriangle(*e)] == Side::Both) {
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
    while (right > 0) {
        const bool takeOld = left > 0 && events[left - 1] > added[right - 1];
        events[--out] = takeOld ? events[--left] : added[--right];
    }
    return count + added.size();
}

} // namespace rtcore
