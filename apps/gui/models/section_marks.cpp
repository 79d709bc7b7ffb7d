#include "gui/models/section_marks.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace gui {

namespace {

using rtcore::Vec3d;

constexpr double kSlackOfDiagonal = 1e-5; ///< a plane along a face of the box is in it

SpacePolygon inBox(SpacePolygon polygon, const Vec3d& lo, const Vec3d& hi, double slack) {
    for (int axis = 0; axis < 3; ++axis) {
        Vec3d normal{};
        normal[axis] = 1;
        polygon = clipped(polygon, normal, hi[axis] + slack);
        polygon = clipped(polygon, normal * -1.0, slack - lo[axis]);
    }
    return polygon;
}

SpacePolygon leftByOthers(SpacePolygon polygon, const rtcore::SectionPlanes& sections, std::size_t number,
                          double slack) {
    for (std::size_t i = 0; i < sections.planes.size(); ++i) {
        if (i == number) continue;
        const Vec3d normal = normalize(exactOf(sections.planes[i].normal));
        polygon = clipped(polygon, normal, dot(normal, exactOf(sections.planes[i].point)) + slack);
    }
    return polygon;
}

} // namespace

SectionMark markOf(const rtcore::SectionPlanes& sections, std::size_t number, const rtcore::Box3& bounds) {
    const rtcore::SectionPlane& plane = sections.planes[number];
    const Vec3d lo = exactOf(bounds.lo), hi = exactOf(bounds.hi), centre = (lo + hi) * 0.5;
    const double diagonal = length(hi - lo), slack = kSlackOfDiagonal * diagonal;
    SectionMark mark{.outline = {}, .normal = normalize(exactOf(plane.normal)), .middle = {}};
    const double away = dot(mark.normal, exactOf(plane.point) - centre);
    mark.middle = centre + mark.normal * away;
    double reach = 0;
    for (int axis = 0; axis < 3; ++axis) reach += std::fabs(mark.normal[axis]) * (hi[axis] - lo[axis]) / 2;
    mark.back = std::min(0.0, -reach - away);
    mark.on = std::max(0.0, reach - away);
    const SpacePolygon whole = inBox(squareAround(mark.middle, mark.normal, diagonal), lo, hi, slack);
    mark.outline = leftByOthers(whole, sections, number, slack);
    if (mark.outline.empty()) mark.outline = whole;
    return mark;
}

std::optional<Vec3d> holdOf(const SectionMark& mark, const SceneImage& image) {
    constexpr double kInner = 0.9; // of the image
    if (mark.outline.empty()) return mark.middle;
    const SpacePolygon seen = image.seen(mark.outline, kInner);
    return seen.empty() ? std::nullopt : std::optional(centroidOf(seen));
}

} // namespace gui
