/// Where points of the scene stand in the image, and where a hand that drags them leads them to.
#pragma once

#include "gui/session/server_status.h"

#include <QPointF>
#include <QRectF>
#include <QVector3D>

#include <optional>

namespace gui {

/// A view in an area of the screen. Points of the area are in its pixels.
class Projection {
  public:
    /// `area`: where the whole image is shown; not empty. The view is known.
    Projection(const View& view, const QRectF& area);

    /// Nothing: it is not in front of the eye.
    std::optional<QPointF> at(const QVector3D& point) const;
    /// Where what is endlessly far away in that direction stands; nothing: not in front of the eye,
    /// or in a view without perspective, which shows nothing of that.
    std::optional<QPointF> farAway(const QVector3D& direction) const;
    /// Scene units by pixel at the depth of the point.
    double unitsPerPixel(const QVector3D& point) const;
    /// The direction of the ray through a point of the area; unit length.
    QVector3D ray(const QPointF& through) const;

    /// The point, moved in the plane parallel to the image as a hand goes there from `from` to `to`.
    QVector3D movedInPlane(const QVector3D& point, const QPointF& from, const QPointF& to) const;
    /// The same along an axis of unit length; where that points at the eye, the point stays.
    QVector3D movedAlong(const QVector3D& point, const QVector3D& axis, const QPointF& from,
                         const QPointF& to) const;

  private:
    std::optional<QPointF> placeOf(const QVector3D& off, double unitsPerPixel) const;
    QVector3D start(const QPointF& through) const;
    double depth(const QVector3D& point) const;
    std::optional<double> alongAxis(const QVector3D& point, const QVector3D& axis, const QPointF& at) const;

    QVector3D eye_, forward_, right_, up_;
    QRectF area_;
    bool parallel_;
    double perPixel_; ///< scene units, with perspective at depth 1
};

} // namespace gui
