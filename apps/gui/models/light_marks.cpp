#include "gui/models/light_marks.h"

#include <QtMath>

#include <cmath>

namespace gui {

namespace {

double widthAtOne(const View& view) {
    if (view.parallelWidth > 0) return static_cast<double>(view.parallelWidth);
    return 2 * std::tan(qDegreesToRadians(static_cast<double>(view.fieldOfView)) / 2);
}

} // namespace

Projection::Projection(const View& view, const QRectF& area)
    : eye_(view.eye), forward_(view.forward.normalized()),
      right_(QVector3D::crossProduct(view.forward, view.up).normalized()),
      up_(QVector3D::crossProduct(right_, forward_).normalized()), area_(area),
      parallel_(view.parallelWidth > 0), perPixel_(widthAtOne(view) / area.width()) {}

double Projection::depth(const QVector3D& point) const {
    return static_cast<double>(QVector3D::dotProduct(point - eye_, forward_));
}

double Projection::unitsPerPixel(const QVector3D& point) const {
    return parallel_ ? perPixel_ : perPixel_ * depth(point);
}

std::optional<QPointF> Projection::at(const QVector3D& point) const {
    if (!(depth(point) > 0)) return std::nullopt;
    return placeOf(point - eye_, unitsPerPixel(point));
}

std::optional<QPointF> Projection::farAway(const QVector3D& direction) const {
    if (parallel_) return std::nullopt;
    return placeOf(direction, perPixel_ * static_cast<double>(QVector3D::dotProduct(direction, forward_)));
}

std::optional<QPointF> Projection::placeOf(const QVector3D& off, double unitsPerPixel) const {
    if (!(unitsPerPixel > 0)) return std::nullopt;
    const QPointF place(static_cast<double>(QVector3D::dotProduct(off, right_)) / unitsPerPixel,
                        -static_cast<double>(QVector3D::dotProduct(off, up_)) / unitsPerPixel);
    return area_.center() + place;
}

QVector3D Projection::start(const QPointF& through) const {
    if (!parallel_) return eye_;
    const QPointF off = perPixel_ * (through - area_.center());
    return eye_ + static_cast<float>(off.x()) * right_ - static_cast<float>(off.y()) * up_;
}

QVector3D Projection::ray(const QPointF& through) const {
    if (parallel_) return forward_;
    const QPointF off = perPixel_ * (through - area_.center());
    return (forward_ + static_cast<float>(off.x()) * right_ - static_cast<float>(off.y()) * up_).normalized();
}

QVector3D Projection::movedInPlane(const QVector3D& point, const QPointF& from, const QPointF& to) const {
    const QPointF off = unitsPerPixel(point) * (to - from);
    return point + static_cast<float>(off.x()) * right_ - static_cast<float>(off.y()) * up_;
}

// Where the axis through the point is nearest to the ray.
std::optional<double> Projection::alongAxis(const QVector3D& point, const QVector3D& axis,
                                            const QPointF& at) const {
    constexpr double kMinSine = 0.02;
    const QVector3D direction = ray(at), off = point - start(at);
    const double cosine = static_cast<double>(QVector3D::dotProduct(axis, direction));
    const double squareSine = 1 - cosine * cosine;
    if (squareSine < kMinSine * kMinSine) return std::nullopt;
    const auto dot = [](const QVector3D& a, const QVector3D& b) {
        return static_cast<double>(QVector3D::dotProduct(a, b));
    };
    return (cosine * dot(direction, off) - dot(axis, off)) / squareSine;
}

QVector3D Projection::movedAlong(const QVector3D& point, const QVector3D& axis, const QPointF& from,
                                 const QPointF& to) const {
    const std::optional<double> start = alongAxis(point, axis, from), end = alongAxis(point, axis, to);
    if (!start || !end) return point;
    return point + static_cast<float>(*end - *start) * axis;
}

} // namespace gui
