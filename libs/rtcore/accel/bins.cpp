#include "rtcore/accel/bins.h"

#include "rtcore/accel/float4.h"

#include <algorithm>

namespace rtcore {

Bins::Bins(const Box3& cell, std::size_t bins) : bins_(bins) {
    first_.fill(Box3::kHuge);
    last_.fill(-Box3::kHuge);
    for (std::size_t a = 0; a < 3; ++a) {
        const auto axis = static_cast<int>(a);
        const float extent = cell.hi[axis] - cell.lo[axis];
        const float scale = static_cast<float>(bins) / extent;
        lo_[a] = cell.lo[axis];
        scale_[a] = extent > 0 && scale < Box3::kHuge ? scale : 0;
        std::fill_n(starts_[a].begin(), bins, 0U);
        std::fill_n(ends_[a].begin(), bins, 0U);
    }
}

void Bins::add(const BoundedTriangle* triangles, std::size_t count) {
    const Float4 cellLo = load4(lo_.data());
    const Float4 scale = load4(scale_.data());
    const Float4 lastBin = set4(static_cast<float>(bins_ - 1));
    Float4 first = load4(first_.data());
    Float4 last = load4(last_.data());
    const auto bin = [&](Float4 position) {
        return truncate4(min4(max4((position - cellLo) * scale, Float4{}), lastBin));
    };
    for (std::size_t i = 0; i < count; ++i) {
        Float4 lo = load4(triangles[i].lo);
        lo[3] = 0; // the triangle
        const Float4 hi = load4(triangles[i].hi);
        const Int4 start = bin(lo);
        const Int4 end = bin(hi);
        first = min4(first, lo);
        last = max4(last, hi);
        for (int a = 0; a < 3; ++a) {
            const auto axis = static_cast<std::size_t>(a);
            ++starts_[axis][static_cast<std::uint32_t>(start[a])];
            ++ends_[axis][static_cast<std::uint32_t>(end[a])];
        }
    }
    store4(first, first_.data());
    store4(last, last_.data());
}

void Bins::add(const Bins& other) {
    for (std::size_t a = 0; a < 3; ++a) {
        first_[a] = std::min(first_[a], other.first_[a]);
        last_[a] = std::max(last_[a], other.last_[a]);
        for (std::size_t i = 0; i < bins_; ++i) {
            starts_[a][i] += other.starts_[a][i];
            ends_[a][i] += other.ends_[a][i];
        }
    }
}

Split Bins::cheapest(const Box3& cell, std::uint32_t triangles, const CostModel& cost) const {
    Split best;
    for (int axis = 0; axis < 3; ++axis) {
        if (scale_[static_cast<std::size_t>(axis)] <= 0) continue;
        const Split s = cheapestAlong(axis, cell, triangles, cost);
        if (s.cost < best.cost) best = s;
    }
    return best;
}

Split Bins::cheapestAlong(int axis, const Box3& cell, std::uint32_t triangles, const CostModel& cost) const {
    const auto a = static_cast<std::size_t>(axis);
    const AreaOfParts area(cell, axis);
    const float extent = area.hi - area.lo;
    const auto bins = static_cast<float>(bins_);
    std::array<std::int32_t, kMaxBins> lower;
    std::array<std::int32_t, kMaxBins> upper;
    lower[0] = 0;
    upper[0] = static_cast<std::int32_t>(triangles);
    for (std::size_t i = 1; i < bins_; ++i) {
        lower[i] = lower[i - 1] + static_cast<std::int32_t>(starts_[a][i - 1]);
        upper[i] = upper[i - 1] - static_cast<std::int32_t>(ends_[a][i - 1]);
    }
    // Apart from what depends on the one before, so that the compiler makes vectors of it.
    std::array<float, kMaxBins> positions;
    std::array<float, kMaxBins> costs;
    const auto count = static_cast<std::int32_t>(bins_);
    for (std::int32_t i = 1; i < count; ++i) {
        const auto k = static_cast<std::size_t>(i);
        const float position = area.lo + extent * (static_cast<float>(i) / bins);
        positions[k] = position;
        costs[k] = cost.traversal + cost.intersection * (area.lower(position) * static_cast<float>(lower[k]) +
                                                         area.upper(position) * static_cast<float>(upper[k]));
    }
    Split best;
    std::size_t cheapest = 0;
    for (std::size_t i = 1; i < bins_; ++i) {
        const bool inside = positions[i] > area.lo && positions[i] < area.hi;
        const float c = lower[i] == 0 || upper[i] == 0 ? costs[i] * cost.emptyFactor : costs[i];
        const bool better = inside && c < best.cost;
        best.cost = better ? c : best.cost;
        cheapest = better ? i : cheapest;
    }
    if (cheapest > 0) best.position = positions[cheapest];
    const auto consider = [&](float position, float c) {
        if (c < best.cost && position > area.lo && position < area.hi) {
            best.cost = c;
            best.position = position;
        }
    };
    const auto considerEnd = [&](float position, std::uint32_t below, std::uint32_t above) {
        consider(position, cost.split(area.lower(position), area.upper(position), below, above));
    };
    considerEnd(first_[a], 0, triangles);
    considerEnd(last_[a], triangles, 0);
    if (best.cost < Split{}.cost) {
        best.axis = axis;
        best.planarLower = best.position != first_[a];
    }
    return best;
}

} // namespace rtcore
