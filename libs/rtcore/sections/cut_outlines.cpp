#include "rtcore/sections/cut_outlines.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <span>
#include <utility>

namespace rtcore {

namespace {

/// Where the plane cuts one triangle: from the edge that leads below to the one that leads above.
struct CutLine {
    std::uint64_t from, to; ///< edges
    FlatPoint a, b;
};

Vec3d positionOf(const Mesh& mesh, std::uint32_t vertex) {
    const Vertex& v = mesh.vertices[vertex];
    return {v.x, v.y, v.z};
}

/// By vertex: 1 where it is above.
std::vector<std::uint8_t> sidesOf(const Mesh& mesh, const CutPlane& plane) {
    std::vector<std::uint8_t> above(mesh.vertices.size());
#pragma omp parallel for schedule(static)
    for (std::size_t i = 0; i < above.size(); ++i)
        above[i] = plane.above(positionOf(mesh, static_cast<std::uint32_t>(i))) > 0 ? 1 : 0;
    return above;
}

/// The same for both triangles at the edge.
FlatPoint crossing(const Mesh& mesh, const CutPlane& plane, std::uint32_t a, std::uint32_t b) {
    const auto [low, high] = std::minmax(a, b);
    const Vec3d p = positionOf(mesh, low), q = positionOf(mesh, high);
    const double below = plane.above(p), above = plane.above(q);
    return plane.flat(p + (q - p) * (below / (below - above)));
}

/// Lines by the edges on which they begin.
class LineChains {
  public:
    explicit LineChains(std::span<const CutLine> lines) : lines_(lines), used_(lines.size()) {
        for (const CutLine& line : lines) ends_.push_back(line.to);
        for (std::uint32_t i = 0; i < lines.size(); ++i) begins_.emplace_back(lines[i].from, i);
        std::ranges::sort(ends_);
        std::ranges::sort(begins_);
    }

    void addTo(CutOutline& outline) {
        for (const auto& [edge, line] : begins_)
            if (!std::ranges::binary_search(ends_, edge)) follow(line, outline);
        for (const auto& [edge, line] : begins_) follow(line, outline);
    }

  private:
    static constexpr std::uint32_t kNone = 0xFFFFFFFFU;

    std::uint32_t unusedFrom(std::uint64_t edge) const {
        for (auto at = std::ranges::lower_bound(begins_, std::pair(edge, std::uint32_t{0}));
             at != begins_.end() && at->first == edge; ++at)
            if (used_[at->second] == 0) return at->second;
        return kNone;
    }

    void follow(std::uint32_t first, CutOutline& outline) {
        if (used_[first] != 0) return;
        FlatLoop points;
        const auto add = [&](const FlatPoint& p) {
            if (points.empty() || points.back() != p) points.push_back(p);
        };
        std::uint32_t last = first;
        for (std::uint32_t line = first; line != kNone; line = unusedFrom(lines_[line].to)) {
            used_[line] = 1;
            add(lines_[line].a);
            last = line;
            if (lines_[line].to == lines_[first].from) break;
        }
        const bool closes = lines_[last].to == lines_[first].from;
        if (!closes) add(lines_[last].b);
        if (closes && points.size() > 1 && points.back() == points.front()) points.pop_back();
        if (closes && points.size() > 2) outline.loops.push_back(std::move(points));
        if (!closes && points.size() > 1) outline.chains.push_back(std::move(points));
    }

    std::span<const CutLine> lines_;
    std::vector<std::uint8_t> used_;
    std::vector<std::uint64_t> ends_;
    std::vector<std::pair<std::uint64_t, std::uint32_t>> begins_;
};

class Cutter {
  public:
    Cutter(const Model& model, const CutPlane& plane)
        : mesh_(model.mesh), shading_(model.mesh.shading), plane_(plane), above_(sidesOf(mesh_, plane)) {}

    bool cuts(std::uint32_t triangle) const {
        const Triangle& t = mesh_.triangles[triangle];
        const int count = above_[t.v[0]] + above_[t.v[1]] + above_[t.v[2]];
        return count == 1 || count == 2;
    }

    CutLine line(std::uint32_t triangle) const {
        const Triangle& t = mesh_.triangles[triangle];
        CutLine line{};
        for (int k = 0; k < 3; ++k) {
            const std::uint32_t a = t.v[k], b = t.v[(k + 1) % 3];
            if (above_[a] == above_[b]) continue;
            const std::uint64_t edge = std::uint64_t{std::min(a, b)} << 32U | std::max(a, b);
            (above_[a] != 0 ? line.from : line.to) = edge;
            (above_[a] != 0 ? line.a : line.b) = crossing(mesh_, plane_, a, b);
        }
        return line;
    }

    CutOutline outline(std::size_t range, bool closed, std::span<const std::uint32_t> triangles) const {
        CutOutline outline{static_cast<std::uint32_t>(range), 0, closed, {}, {}};
        std::vector<CutLine> lines;
        std::map<std::uint32_t, double> lengths;
        for (const std::uint32_t t : triangles) {
            const CutLine& line = lines.emplace_back(this->line(t));
            lengths[shading_[t].material] += std::hypot(line.b[0] - line.a[0], line.b[1] - line.a[1]);
        }
        LineChains(lines).addTo(outline);
        outline.material =
            std::ranges::max_element(lengths, {}, [](const auto& entry) { return entry.second; })->first;
        return outline;
    }

  private:
    const Mesh& mesh_;
    std::span<const ShadingTriangle> shading_;
    const CutPlane& plane_;
    std::vector<std::uint8_t> above_;
};

} // namespace

std::vector<CutOutline> cutOutlines(const Model& model, const HiddenParts& hidden, const CutPlane& plane,
                                    ClosedPieces& pieces) {
    const Cutter cutter(model, plane);
    std::vector<CutOutline> outlines;
    for (std::size_t r = 0; r < pieces.ranges().size(); ++r) {
        const PartRange& range = pieces.ranges()[r];
        if (hidden != nullptr && range.part != PartRange::kNoPart && (*hidden)[range.part] != 0) continue;
        std::vector<std::uint32_t> cut;
        for (std::uint32_t t = range.firstTriangle; t < range.firstTriangle + range.triangleCount; ++t)
            if (cutter.cuts(t)) cut.push_back(t);
        if (cut.empty()) continue;
        const std::vector<std::uint8_t>& closed = pieces.of(r);
        const auto open = std::ranges::stable_partition(
            cut, [&](std::uint32_t t) { return closed[t - range.firstTriangle] != 0; });
        const std::span<const std::uint32_t> all(cut);
        const std::size_t solids = all.size() - open.size();
        if (solids > 0) outlines.push_back(cutter.outline(r, true, all.first(solids)));
        if (!open.empty()) outlines.push_back(cutter.outline(r, false, all.subspan(solids)));
    }
    return outlines;
}

double areaOf(const FlatLoop& loop) {
    double twice = 0;
    for (std::size_t i = 0; i < loop.size(); ++i) {
        const FlatPoint &a = loop[i], &b = loop[(i + 1) % loop.size()];
        twice += (a[0] - loop[0][0]) * (b[1] - loop[0][1]) - (b[0] - loop[0][0]) * (a[1] - loop[0][1]);
    }
    return twice / 2;
}

} // namespace rtcore
