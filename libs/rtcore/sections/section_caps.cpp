#include "rtcore/sections/section_caps.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <set>
#include <utility>

namespace rtcore {

namespace {

/// The part of the loop that lies below `plane`; pieces of it may hang together by lines in that plane.
FlatLoop clipped(const FlatLoop& loop, const CutPlane& of, const CutPlane& plane) {
    FlatLoop kept;
    for (std::size_t i = 0; i < loop.size(); ++i) {
        const FlatPoint &p = loop[i], &q = loop[(i + 1) % loop.size()];
        const double a = plane.above(of.point(p)), b = plane.above(of.point(q));
        if (a <= 0) kept.push_back(p);
        if ((a <= 0) == (b <= 0)) continue;
        const double part = a / (a - b);
        kept.push_back({p[0] + (q[0] - p[0]) * part, p[1] + (q[1] - p[1]) * part});
    }
    return kept;
}

/// Without those that run to and fro.
std::vector<FlatLine> edgesOf(const std::vector<FlatLoop>& loops) {
    std::vector<FlatLine> lines, edges;
    for (const FlatLoop& loop : loops)
        for (std::size_t i = 0; i < loop.size(); ++i) lines.push_back({loop[i], loop[(i + 1) % loop.size()]});
    std::ranges::sort(lines);
    std::ranges::copy_if(lines, std::back_inserter(edges), [&](const FlatLine& line) {
        return !std::ranges::binary_search(lines, FlatLine{line.b, line.a});
    });
    return edges;
}

CapShape shapeOf(const CutOutline& outline, std::size_t number, const std::vector<CutPlane>& planes) {
    CapShape shape{outline.material, {}, {}};
    for (FlatLoop loop : outline.loops) {
        for (std::size_t other = 0; other < planes.size() && !loop.empty(); ++other)
            if (other != number) loop = clipped(loop, planes[number], planes[other]);
        if (loop.size() > 2) shape.loops.push_back(std::move(loop));
    }
    shape.edges = edgesOf(shape.loops);
    return shape;
}

double sizeOf(const CapShape& shape) {
    double sum = 0;
    for (const FlatLoop& loop : shape.loops) sum += areaOf(loop);
    return std::fabs(sum);
}

} // namespace

SectionCaps sectionCapsOf(const Scene& scene, ClosedPieces& pieces) {
    Box3 bounds;
    for (const Vertex& vertex : scene.model.mesh.vertices) bounds.extend(vertex.position());
    std::vector<CutPlane> planes;
    for (const SectionPlane& plane : scene.sections.planes)
        planes.push_back(cutPlaneOf(plane, bounds, scene.up));
    SectionCaps caps;
    std::set<std::string> open;
    const PartSet uncut = eitherParts(scene.hiddenParts, scene.uncutParts);
    for (std::size_t i = 0; i < planes.size(); ++i) {
        PlaneCaps cut{planes[i], {}};
        for (const CutOutline& outline : cutOutlines(scene.model, uncut, planes[i], pieces)) {
            if (!outline.closed) {
                const std::uint32_t part = pieces.ranges()[outline.range].part;
                const bool named = part != PartRange::kNoPart;
                open.emplace(named ? scene.model.name(scene.model.parts[part].nameOffset)
                                   : std::string_view());
                continue;
            }
            if (CapShape shape = shapeOf(outline, i, planes); !shape.loops.empty())
                cut.shapes.push_back(std::move(shape));
        }
        std::ranges::stable_sort(cut.shapes, std::greater(), sizeOf);
        if (!cut.shapes.empty()) caps.planes.push_back(std::move(cut));
    }
    caps.openParts.assign(open.begin(), open.end());
    return caps;
}

} // namespace rtcore
