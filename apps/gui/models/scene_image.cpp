#include "gui/models/scene_image.h"

#include <QtMath>

#include <algorithm>
#include <array>
#include <cmath>

namespace gui {

namespace {

using rtcore::Vec3d;

constexpr double kNear = 1e-4; ///< of the depth of what is farthest

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
    : eye_(exactOf(view.eye)), forward_(normalize(exactOf(view.forward))),
      right_(normalize(cross(forward_, exactOf(view.up)))), up_(normalize(cross(right_, forward_))),
      area_(area), parallel_(!(view.fieldOfView > 0)),
      perPixel_((parallel_ ? parallelWidth
                           : 2 * std::tan(qDegreesToRadians(static_cast<double>(view.fieldOfView)) / 2)) /
                area.width()),
      perLine_(perPixel_ * area.width() / (aspect * area.height())) {}

std::optional<QPointF> SceneImage::at(const Vec3d& point) const {
    const double ahead = depth(point);
    if (!(ahead > 0)) return std::nullopt;
    return placeOf(point - eye_, scaleAt(ahead));
}

std::optional<QPointF> SceneImage::farAway(const Vec3d& direction) const {
    if (parallel_) return std::nullopt;
    return placeOf(direction, dot(direction, forward_));
}

std::optional<QPointF> SceneImage::placeOf(const Vec3d& off, double scale) const {
    if (!(perPixel_ * scale > 0)) return std::nullopt;
    return area_.center() +
           QPointF(dot(off, right_) / (perPixel_ * scale), -dot(off, up_) / (perLine_ * scale));
}

double SceneImage::unitsPerPixel(const Vec3d& point) const { return perPixel_ * scaleAt(depth(point)); }

/// So many pixels, in scene units.
Vec3d SceneImage::across(const QPointF& off) const {
    return right_ * (perPixel_ * off.x()) - up_ * (perLine_ * off.y());
}

Vec3d SceneImage::ray(const QPointF& through) const {
    return parallel_ ? forward_ : normalize(forward_ + across(through - area_.center()));
}

/// Of the ray.
Vec3d SceneImage::startOf(const QPointF& through) const {
    return parallel_ ? eye_ + across(through - area_.center()) : eye_;
}

Vec3d SceneImage::towardsEye(const Vec3d& point) const {
    return parallel_ ? forward_ * -1.0 : normalize(eye_ - point);
}

// --- Hands ---

Vec3d SceneImage::movedInPlane(const Vec3d& point, const QPointF& from, const QPointF& to) const {
    return point + across(to - from) * scaleAt(depth(point));
}

std::optional<Vec3d> SceneImage::onPlane(const Vec3d& point, const Vec3d& normal,
                                         const QPointF& through) const {
    const Vec3d direction = ray(through), start = startOf(through);
    const double towards = dot(normal, direction);
    if (towards == 0) return std::nullopt;
    const double distance = dot(normal, point - start) / towards;
    return distance > 0 ? std::optional(start + direction * distance) : std::nullopt;
}

// Where the axis through the point is nearest to the ray.
std::optional<double> SceneImage::alongAxis(const Vec3d& point, const Vec3d& axis, const QPointF& at) const {
    constexpr double kMinSine = 0.02;
    const Vec3d direction = ray(at), off = point - startOf(at);
    const double cosine = dot(axis, direction), squareSine = 1 - cosine * cosine;
    if (squareSine < kMinSine * kMinSine) return std::nullopt;
    return (cosine * dot(direction, off) - dot(axis, off)) / squareSine;
}

double SceneImage::distanceAlong(const Vec3d& point, const Vec3d& axis, const QPointF& from,
                                 const QPointF& to) const {
    const std::optional<double> start = alongAxis(point, axis, from), end = alongAxis(point, axis, to);
    return start && end ? *end - *start : 0;
}

// --- Lines and areas ---

// By the planes through the eye and the edges.
SpacePolygon SceneImage::seen(SpacePolygon polygon, double part) const {
    double farthest = 0;
    for (const Vec3d& corner : polygon) farthest = std::max(farthest, depth(corner));
    const double ahead = dot(forward_, eye_) + kNear * farthest;
    polygon = clipped(polygon, forward_ * -1.0, -ahead);
    const std::array<std::pair<Vec3d, double>, 2> sides{
        {{right_, part * perPixel_ * area_.width() / 2}, {up_, part * perLine_ * area_.height() / 2}}};
    for (const auto& [axis, reach] : sides)
        for (const double sign : {1.0, -1.0}) {
            const Vec3d normal = parallel_ ? axis * sign : axis * sign - forward_ * reach;
            polygon = clipped(polygon, normal, dot(normal, eye_) + (parallel_ ? reach : 0));
        }
    return polygon;
}

std::optional<QLineF> SceneImage::line(Vec3d from, Vec3d to) const {
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
        const Vec3d normal = normalize(exactOf(plane.normal)), point = exactOf(plane.point);
        if (!keepBelow(dot(normal, from - point) - slack, dot(normal, to - from), first, last))
            return std::nullopt;
    }
    return std::pair(from + (to - from) * first, from + (to - from) * last);
}

} // namespace gui
