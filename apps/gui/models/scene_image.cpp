#include "gui/models/scene_image.h"

#include <QtMath>

#include <algorithm>
#include <cmath>

namespace gui {

namespace {

using rtcore::Vec3d;

Vec3d doubles(const QVector3D& v) { return {v.x(), v.y(), v.z()}; }
Vec3d doubles(const rtcore::Vec3& v) { return {v.x, v.y, v.z}; }

/// Keeps the part of 0..1 along which start + t * change <= 0; false: none is left.
bool keepBelow(double start, double change, double& first, double& last) {
    if (change == 0) return start <= 0;
    const double crossing = -start / change;
    if (change > 0)
        last = std::min(last, crossing);
    else
        first = std::max(first, crossing);
    return first <= last;
}

} // namespace

SceneImage::SceneImage(const View& view, double parallelWidth, const QRectF& area, double aspect)
    : eye_(doubles(view.eye)), forward_(normalize(doubles(view.forward))),
      right_(normalize(cross(forward_, doubles(view.up)))), up_(normalize(cross(right_, forward_))),
      area_(area), parallel_(!(view.fieldOfView > 0)),
      perPixel_((parallel_ ? parallelWidth
                           : 2 * std::tan(qDegreesToRadians(static_cast<double>(view.fieldOfView)) / 2)) /
                area.width()),
      perLine_(perPixel_ * area.width() / (aspect * area.height())) {}

std::optional<QPointF> SceneImage::at(const Vec3d& point) const {
    const double ahead = depth(point), scale = parallel_ ? 1 : ahead;
    if (!(ahead > 0) || !(perPixel_ * scale > 0)) return std::nullopt;
    const Vec3d off = point - eye_;
    return area_.center() +
           QPointF(dot(off, right_) / (perPixel_ * scale), -dot(off, up_) / (perLine_ * scale));
}

std::optional<QLineF> SceneImage::line(Vec3d from, Vec3d to) const {
    constexpr double kNear = 1e-4; // of the depth of the farther end
    const double a = depth(from), b = depth(to), near = kNear * std::max(a, b);
    double first = 0, last = 1;
    if (!(near > 0) || !keepBelow(near - a, a - b, first, last)) return std::nullopt;
    const auto start = at(from + (to - from) * first), end = at(from + (to - from) * last);
    return start && end ? inArea({*start, *end}) : std::nullopt;
}

// Lines to far outside are slow to paint.
std::optional<QLineF> SceneImage::inArea(QLineF line) const {
    constexpr double kAround = 20;
    const QRectF box = area_.adjusted(-kAround, -kAround, kAround, kAround);
    double first = 0, last = 1;
    const bool seen = keepBelow(box.left() - line.x1(), -line.dx(), first, last) &&
                      keepBelow(line.x1() - box.right(), line.dx(), first, last) &&
                      keepBelow(box.top() - line.y1(), -line.dy(), first, last) &&
                      keepBelow(line.y1() - box.bottom(), line.dy(), first, last);
    if (!seen) return std::nullopt;
    return QLineF(line.pointAt(first), line.pointAt(last));
}

std::optional<std::pair<Vec3d, Vec3d>> leftOf(const rtcore::SectionPlanes& sections, Vec3d from, Vec3d to,
                                              double slack) {
    double first = 0, last = 1;
    for (const rtcore::SectionPlane& plane : sections.planes) {
        const Vec3d normal = normalize(doubles(plane.normal)), point = doubles(plane.point);
        if (!keepBelow(dot(normal, from - point) - slack, dot(normal, to - from), first, last))
            return std::nullopt;
    }
    return std::pair(from + (to - from) * first, from + (to - from) * last);
}

} // namespace gui
