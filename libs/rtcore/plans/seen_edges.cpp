#include "rtcore/plans/seen_edges.h"

#include "rtcore/kernels/section_clip.h"
#include "rtcore/plans/line_union.h"
#include "rtcore/platform/task_errors.h"
#include "rtcore/scene/sharp_edges.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <utility>

namespace rtcore {

namespace {

struct SpaceLine {
    Vec3d a, b;
};

/// A point on each line: `part` of the way along it.
struct Probe {
    std::uint32_t line;
    double part;
};

Vec3 rounded(Vec3d v) { return {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)}; }

/// Edges that are drawn where nothing hides them.
class EdgeFinder {
  public:
    EdgeFinder(const Scene& scene, const CutPlane& plane)
        : mesh_(scene.model.mesh), plane_(plane), hidden_(partTriangles(scene.model, scene.hiddenParts)) {}

    std::vector<SpaceLine> lines() {
        Indices triangles, corners;
        for (std::uint32_t t = 0; t < mesh_.triangles.size(); ++t) {
            if ((!hidden_.empty() && hidden_[t] != 0) || !reachesBelow(t)) continue;
            triangles.push_back(t);
            for (const std::uint32_t v : mesh_.triangles[t].v) corners.push_back(v);
        }
        std::vector<HalfEdge> edges = halfEdges(corners, false);
        std::vector<SpaceLine> lines;
        visitEdges(edges, [&](std::span<const HalfEdge> sides) {
            if (isDrawn(sides, triangles)) addBelow(sides[0].low, sides[0].high, lines);
        });
        return lines;
    }

  private:
    Vec3d position(std::uint32_t vertex) const { return exact(mesh_.vertices[vertex].position()); }

    bool reachesBelow(std::uint32_t t) const {
        return std::ranges::any_of(mesh_.triangles[t].v,
                                   [&](std::uint32_t v) { return plane_.above(position(v)) < 0; });
    }

    bool isDrawn(std::span<const HalfEdge> sides, const Indices& triangles) const {
        return isSharp(mesh_, sides, triangles) || turnsAway(sides, triangles);
    }

    bool turnsAway(std::span<const HalfEdge> sides, const Indices& triangles) const {
        constexpr double kEdgeOn = 1e-3;
        bool towards = false, away = false;
        for (std::size_t i = 0; i < sides.size(); ++i) {
            const bool turned = i > 0 && sides[i].forward == sides[0].forward;
            const double facing =
                dot(exactNormal(mesh_, triangles[sides[i].triangle]), plane_.normal) * (turned ? -1 : 1);
            towards |= facing > kEdgeOn;
            away |= facing < -kEdgeOn;
        }
        return towards && away;
    }

    void addBelow(std::uint32_t low, std::uint32_t high, std::vector<SpaceLine>& lines) const {
        Vec3d a = position(low), b = position(high);
        const double aboveA = plane_.above(a), aboveB = plane_.above(b);
        if (aboveA >= 0 && aboveB >= 0) return;
        const Vec3d cut = a + (b - a) * (aboveA / (aboveA - aboveB));
        if (aboveA > 0) a = cut;
        if (aboveB > 0) b = cut;
        lines.push_back({a, b});
    }

    const Mesh& mesh_;
    const CutPlane& plane_;
    std::vector<std::uint8_t> hidden_;
};

/// What is seen of lines.
class LineViewer {
  public:
    LineViewer(const RayTracer& tracer, const CutPlane& plane, const FlatRegion& solids, double step)
        : tracer_(tracer), plane_(plane), solids_(solids), step_(step),
          clearance_(4 * roundingOf(tracer.bounds())) {}

    /// Of some lines, in their order.
    std::vector<FlatLine> seen(std::span<const SpaceLine> lines) const {
        std::vector<Probe> probes;
        for (std::uint32_t i = 0; i < lines.size(); ++i) {
            const int count = stepsOf(lines[i]);
            for (int k = 0; k < count; ++k) probes.push_back({i, (k + 0.5) / count});
        }
        const std::vector<std::uint8_t> sees = look(lines, probes);
        std::vector<Change> changes;
        for (std::size_t i = 1; i < probes.size(); ++i)
            if (probes[i].line == probes[i - 1].line && sees[i] != sees[i - 1])
                changes.push_back({probes[i].line, probes[i - 1].part, probes[i].part, sees[i] != 0});
        narrow(lines, changes);
        return between(lines, probes, sees, changes);
    }

  private:
    /// Somewhere between `low` and `high` the line begins to be seen, or ends.
    struct Change {
        std::uint32_t line;
        double low, high;
        bool begins;
    };

    int stepsOf(const SpaceLine& line) const {
        constexpr double kMax = 10'000;
        const FlatPoint a = plane_.flat(line.a), b = plane_.flat(line.b);
        const double length = std::hypot(b[0] - a[0], b[1] - a[1]);
        return length > 0 ? static_cast<int>(std::clamp(std::ceil(length / step_), 1.0, kMax)) : 0;
    }

    static Vec3d pointOf(std::span<const SpaceLine> lines, const Probe& probe) {
        const SpaceLine& line = lines[probe.line];
        return line.a + (line.b - line.a) * probe.part;
    }

    /// 1 where a probe is seen.
    std::vector<std::uint8_t> look(std::span<const SpaceLine> lines, std::span<const Probe> probes) const {
        RayWave rays;
        rays.reserve(probes.size());
        const Vec3 direction = rounded(plane_.normal);
        for (const Probe& probe : probes) {
            const Vec3d point = pointOf(lines, probe);
            rays.push({rounded(point), clearance_, direction,
                       static_cast<float>(-plane_.above(point)) - clearance_});
        }
        std::vector<std::uint8_t> seen;
        tracer_.occluded(RayKind::Occlusion, rays, seen);
        for (std::size_t i = 0; i < probes.size(); ++i)
            seen[i] = seen[i] == 0 && !solids_.contains(plane_.flat(pointOf(lines, probes[i]))) ? 1 : 0;
        return seen;
    }

    void narrow(std::span<const SpaceLine> lines, std::vector<Change>& changes) const {
        constexpr int kHalvings = 6;
        std::vector<Probe> middles(changes.size());
        for (int i = 0; i < kHalvings; ++i) {
            for (std::size_t k = 0; k < changes.size(); ++k)
                middles[k] = {changes[k].line, (changes[k].low + changes[k].high) / 2};
            const std::vector<std::uint8_t> sees = look(lines, middles);
            for (std::size_t k = 0; k < changes.size(); ++k)
                ((sees[k] != 0) == changes[k].begins ? changes[k].high : changes[k].low) = middles[k].part;
        }
    }

    std::vector<FlatLine> between(std::span<const SpaceLine> lines, std::span<const Probe> probes,
                                  std::span<const std::uint8_t> sees, std::span<const Change> changes) const {
        std::vector<FlatLine> seen;
        std::size_t change = 0;
        for (std::size_t first = 0; first < probes.size();) {
            const std::uint32_t line = probes[first].line;
            double begin = sees[first] != 0 ? 0 : 2; // 2: nothing has begun
            const auto add = [&](double end) {
                if (begin < end)
                    seen.push_back({plane_.flat(pointOf(lines, {line, begin})),
                                    plane_.flat(pointOf(lines, {line, end}))});
            };
            for (; change < changes.size() && changes[change].line == line; ++change) {
                const double at = (changes[change].low + changes[change].high) / 2;
                if (changes[change].begins) {
                    begin = at;
                } else {
                    add(at);
                    begin = 2;
                }
            }
            add(1);
            while (first < probes.size() && probes[first].line == line) ++first;
        }
        return seen;
    }

    const RayTracer& tracer_;
    const CutPlane& plane_;
    const FlatRegion& solids_;
    double step_;
    float clearance_;
};

} // namespace

std::vector<FlatLine> seenEdges(const Scene& scene, const RayTracer& tracer, const CutPlane& plane,
                                const FlatRegion& solids, double step, const std::atomic<bool>& cancel) {
    constexpr std::size_t kLinesAtOnce = 256;
    constexpr double kTolerance = 0.05; // of a step
    const std::vector<SpaceLine> lines = EdgeFinder(scene, plane).lines();
    const LineViewer viewer(tracer, plane, solids, step);
    std::vector<std::vector<FlatLine>> pieces((lines.size() + kLinesAtOnce - 1) / kLinesAtOnce);
    TaskErrors errors;
#pragma omp parallel for schedule(dynamic)
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        if (cancel.load() || errors.any()) continue;
        const std::size_t first = i * kLinesAtOnce;
        errors.guard([&] {
            pieces[i] =
                viewer.seen(std::span(lines).subspan(first, std::min(kLinesAtOnce, lines.size() - first)));
        });
    }
    errors.rethrow();
    std::vector<FlatLine> seen;
    if (cancel.load()) return seen;
    for (const std::vector<FlatLine>& some : pieces) seen.insert(seen.end(), some.begin(), some.end());
    return unionOfLines(seen, kTolerance * step);
}

} // namespace rtcore
