#include "rtcore/plans/flat_region.h"

#include <algorithm>
#include <cmath>

namespace rtcore {

FlatRegion::FlatRegion(const std::vector<FlatLoop>& loops) {
    constexpr std::size_t kEdgesOfBand = 4, kMaxBands = 1 << 16;
    std::vector<Edge> edges;
    for (const FlatLoop& loop : loops)
        for (std::size_t i = 0; i < loop.size(); ++i) edges.push_back({loop[i], loop[(i + 1) % loop.size()]});
    if (edges.empty()) return;
    low_ = high_ = edges[0].a[1];
    for (const Edge& edge : edges) {
        low_ = std::min(low_, edge.a[1]);
        high_ = std::max(high_, edge.a[1]);
    }
    bands_.resize(std::clamp(edges.size() / kEdgesOfBand, std::size_t{1}, kMaxBands));
    for (const Edge& edge : edges) {
        const auto [from, to] = std::minmax(edge.a[1], edge.b[1]);
        for (std::size_t band = bandOf(from); band <= bandOf(to); ++band) bands_[band].push_back(edge);
    }
}

std::size_t FlatRegion::bandOf(double y) const {
    if (high_ <= low_) return 0;
    const double at = (y - low_) / (high_ - low_) * static_cast<double>(bands_.size());
    return std::min(static_cast<std::size_t>(std::max(at, 0.0)), bands_.size() - 1);
}

bool FlatRegion::contains(const FlatPoint& p) const {
    if (bands_.empty() || !(p[1] >= low_ && p[1] <= high_)) return false;
    bool inside = false;
    for (const auto& [a, b] : bands_[bandOf(p[1])]) {
        if ((a[1] <= p[1]) == (b[1] <= p[1])) continue;
        const double x = a[0] + (b[0] - a[0]) * ((p[1] - a[1]) / (b[1] - a[1]));
        if (x > p[0]) inside = !inside;
    }
    return inside;
}

} // namespace rtcore
