#include "rtcore/io/import/scan/point_tree.h"

#include "rtcore/math/box.h"
#include "rtcore/platform/large_vector.h"

#include <algorithm>

namespace rtcore {

namespace {

constexpr std::size_t kLeafPoints = 12;
constexpr std::size_t kTaskPoints = 20'000; ///< fewer are not worth a task

void take(std::uint32_t point, float square, Neighbours& nearest) {
    const auto isNearer = [&](std::size_t other) {
        return square < nearest.squares[other] ||
               (square == nearest.squares[other] && point < nearest.points[other]);
    };
    if (nearest.count == kNeighbours && !isNearer(kNeighbours - 1)) return;
    if (nearest.count < kNeighbours) ++nearest.count;
    std::size_t at = nearest.count - 1;
    for (; at > 0 && isNearer(at - 1); --at) {
        nearest.points[at] = nearest.points[at - 1];
        nearest.squares[at] = nearest.squares[at - 1];
    }
    nearest.points[at] = point;
    nearest.squares[at] = square;
}

} // namespace

PointTree::PointTree(std::span<const Vec3> positions) {
    resizeLarge(entries_, positions.size());
    axes_.resize(positions.size(), 0);
    for (std::size_t i = 0; i < positions.size(); ++i)
        entries_[i] = {positions[i], static_cast<std::uint32_t>(i)};
#pragma omp parallel
#pragma omp single
    split(0, entries_.size());
}

void PointTree::split(std::size_t begin, std::size_t end) {
    while (end - begin > kLeafPoints) {
        Box3 bounds;
        for (std::size_t i = begin; i < end; ++i) bounds.extend(entries_[i].position);
        const Vec3 size = bounds.size();
        const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
        const std::size_t middle = begin + (end - begin) / 2;
        const auto at = [this](std::size_t i) { return entries_.begin() + static_cast<std::ptrdiff_t>(i); };
        std::nth_element(at(begin), at(middle), at(end), [axis](const Entry& a, const Entry& b) {
            return a.position[axis] < b.position[axis] ||
                   (a.position[axis] == b.position[axis] && a.point < b.point);
        });
        axes_[middle] = static_cast<std::uint8_t>(axis);
        if (end - begin > kTaskPoints) {
#pragma omp task firstprivate(begin, middle)
            split(begin, middle);
        } else {
            split(begin, middle);
        }
        begin = middle + 1;
    }
}

void PointTree::search(std::size_t begin, std::size_t end, const Entry& entry, Neighbours& nearest) const {
    const auto look = [&](const Entry& other) {
        const Vec3 apart = other.position - entry.position;
        if (other.point != entry.point) take(other.point, dot(apart, apart), nearest);
    };
    if (end - begin <= kLeafPoints) {
        for (std::size_t i = begin; i < end; ++i) look(entries_[i]);
        return;
    }
    const std::size_t middle = begin + (end - begin) / 2;
    const Entry& splitter = entries_[middle];
    const int axis = axes_[middle];
    const float offset = entry.position[axis] - splitter.position[axis];
    const bool below = offset < 0 || (offset == 0 && entry.point < splitter.point);
    search(below ? begin : middle + 1, below ? middle : end, entry, nearest);
    look(splitter);
    if (nearest.count == kNeighbours && offset * offset > nearest.squares[kNeighbours - 1]) return;
    search(below ? middle + 1 : begin, below ? end : middle, entry, nearest);
}

Neighbours PointTree::nearestOf(const Entry& entry) const {
    Neighbours nearest;
    search(0, entries_.size(), entry, nearest);
    return nearest;
}

void PointTree::forEach(const UseNeighbours& use, const std::function<void()>& alive) const {
    constexpr std::size_t kAtOnce = 1'000'000;
    for (std::size_t first = 0; first < entries_.size(); first += kAtOnce) {
        const std::size_t end = std::min(first + kAtOnce, entries_.size());
#pragma omp parallel for schedule(dynamic, 4096)
        for (std::size_t i = first; i < end; ++i) use(entries_[i].point, nearestOf(entries_[i]));
        alive();
    }
}

} // namespace rtcore
