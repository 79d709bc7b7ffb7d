#include "rtcore/plans/level_outline.h"

#include "rtcore/plans/flat_areas.h"
#include "rtcore/sections/cut_outlines.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <tuple>
#include <utility>

namespace rtcore {

namespace {

constexpr double kCut = 1.2, kLowCut = 0.3; ///< metres above the floor
constexpr int kContours = 6;

CutPlane levelPlane(const Scene& scene, const Box3& bounds, double height) {
    const Vec3 middle = 0.5F * (bounds.lo + bounds.hi);
    const Vec3 point = middle + (static_cast<float>(height) - dot(middle, scene.up)) * scene.up;
    return cutPlaneOf({point, scene.up}, bounds, scene.up);
}

void close(std::vector<FlatLoop>& loops) {
    for (FlatLoop& loop : loops)
        if (!loop.empty()) loop.push_back(FlatPoint(loop.front()));
}

void move(std::vector<FlatLoop>& from, std::vector<FlatLoop>& to) {
    std::ranges::move(from, std::back_inserter(to));
}

/// What is open of them.
std::vector<FlatLoop> openLines(std::vector<CutOutline>& outlines) {
    std::vector<FlatLoop> lines;
    for (CutOutline& outline : outlines) {
        if (outline.closed) continue;
        close(outline.loops);
        move(outline.loops, lines);
        move(outline.chains, lines);
    }
    return lines;
}

void findBounds(LevelOutline& outline) {
    bool any = false;
    for (const auto* lines : {&outline.solids, &outline.lines, &outline.light}) {
        for (const FlatLoop& line : *lines) {
            for (const FlatPoint& p : line) {
                if (!std::exchange(any, true)) outline.low = outline.high = p;
                for (std::size_t axis = 0; axis < 2; ++axis) {
                    outline.low[axis] = std::min(outline.low[axis], p[axis]);
                    outline.high[axis] = std::max(outline.high[axis], p[axis]);
                }
            }
        }
    }
}

double distance(const FlatPoint& p, const FlatPoint& a, const FlatPoint& b) {
    const double x = b[0] - a[0], y = b[1] - a[1], length = x * x + y * y;
    const double along =
        length > 0 ? std::clamp(((p[0] - a[0]) * x + (p[1] - a[1]) * y) / length, 0.0, 1.0) : 0;
    return std::hypot(p[0] - a[0] - along * x, p[1] - a[1] - along * y);
}

} // namespace

LevelOutline outlineOfStorey(const Scene& scene, const Box3& bounds, double floor, ClosedPieces& pieces,
                             const std::atomic<bool>& cancel) {
    const double metre = 1 / double{scene.metresPerUnit};
    LevelOutline outline{.plane = levelPlane(scene, bounds, floor + kCut * metre)};
    std::vector<CutOutline> cut = cutOutlines(scene.model, scene.hiddenParts, outline.plane, pieces);
    outline.solids = coveredBy(cut);
    close(outline.solids);
    outline.lines = openLines(cut);
    if (cancel.load()) return {};
    cut = cutOutlines(scene.model, scene.hiddenParts, levelPlane(scene, bounds, floor + kLowCut * metre),
                      pieces);
    outline.light = coveredBy(cut);
    close(outline.light);
    std::vector<FlatLoop> open = openLines(cut);
    move(open, outline.light);
    findBounds(outline);
    return outline;
}

LevelOutline contourLines(const Scene& scene, const Box3& bounds, ClosedPieces& pieces,
                          const std::atomic<bool>& cancel) {
    const double a = double{dot(bounds.lo, scene.up)}, b = double{dot(bounds.hi, scene.up)};
    LevelOutline outline{.plane = levelPlane(scene, bounds, std::min(a, b))};
    for (int i = 0; i < kContours && !cancel.load(); ++i) {
        const double height = std::min(a, b) + std::fabs(b - a) * (i + 0.5) / kContours;
        for (CutOutline& cut :
             cutOutlines(scene.model, scene.hiddenParts, levelPlane(scene, bounds, height), pieces)) {
            close(cut.loops);
            move(cut.loops, outline.light);
            move(cut.chains, outline.light);
        }
    }
    findBounds(outline);
    return outline;
}

// The farthest point between two that stay does so, too, where it is too far from the line between them.
FlatLoop simplified(const FlatLoop& line, double tolerance) {
    if (line.size() < 2) return {};
    std::vector<std::uint8_t> stays(line.size());
    std::vector<std::pair<std::size_t, std::size_t>> spans{{0, line.size() - 1}};
    stays.front() = stays.back() = 1;
    while (!spans.empty()) {
        const auto [first, last] = spans.back();
        spans.pop_back();
        std::size_t farthest = first;
        double largest = tolerance;
        for (std::size_t i = first + 1; i < last; ++i) {
            const double away = distance(line[i], line[first], line[last]);
            if (away > largest) std::tie(farthest, largest) = std::pair(i, away);
        }
        if (farthest == first) continue;
        stays[farthest] = 1;
        spans.emplace_back(first, farthest);
        spans.emplace_back(farthest, last);
    }
    FlatLoop kept;
    for (std::size_t i = 0; i < line.size(); ++i)
        if (stays[i] != 0) kept.push_back(line[i]);
    if (kept.size() == 2 && distance(kept[0], kept[1], kept[1]) <= tolerance) return {};
    return kept;
}

} // namespace rtcore
