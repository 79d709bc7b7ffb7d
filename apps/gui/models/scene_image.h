/// Where the image shows points and lines of the scene, by the camera of its frame, and where a hand that
/// drags them leads them to.
#pragma once

#include "gui/models/space_polygon.h"
#include "gui/session/server_status.h"

#include "rtcore/math/vec.h"
#include "rtcore/scene/section_planes.h"

#include <QLineF>
#include <QPointF>
#include <QRectF>
#include <QVector3D>

#include <optional>
#include <utility>

namespace gui {

inline rtcore::Vec3d exactOf(const QVector3D& v) { return {v.x(), v.y(), v.z()}; }
inline rtcore::Vec3d exactOf(const rtcore::Vec3& v) { return {v.x, v.y, v.z}; }

/// A camera with perspective or without, in an area of the screen. Points are in scene units from the scene's
/// zero, those of the area in its pixels.
class SceneImage {
  public:
    /// `area`: where the whole image is shown; not empty. `aspect`: its width over its height, above 0, by
    /// its own pixels, which may be stretched. `parallelWidth`: scene units between the left and right edge
    /// of a view without perspective, whose field of view is 0.
    SceneImage(const View& view, double parallelWidth, const QRectF& area, double aspect);

    /// Nothing: it is not in front of the eye.
    std::optional<QPointF> at(const rtcore::Vec3d& point) const;
    /// What is seen of the line between two points: clipped before the eye and, a little beyond, at the
    /// edges of the area. Nothing: none of it is.
    std::optional<QLineF> line(rtcore::Vec3d from, rtcore::Vec3d to) const;
    /// The part of a polygon that the inner `part`, 0..1, of the area shows; empty: nothing.
    SpacePolygon seen(SpacePolygon polygon, double part) const;
    /// Where what is endlessly far away in that direction stands; nothing: not in front of the eye, or in a
    /// view without perspective, which shows nothing of that.
    std::optional<QPointF> farAway(const rtcore::Vec3d& direction) const;
    /// Scene units by pixel across, at the depth of the point.
    double unitsPerPixel(const rtcore::Vec3d& point) const;
    /// The direction of the ray through a point of the area; unit length.
    rtcore::Vec3d ray(const QPointF& through) const;
    /// The direction from a point to the eye; unit length.
    rtcore::Vec3d towardsEye(const rtcore::Vec3d& point) const;

    /// The point, moved in the plane parallel to the image as a hand goes there from `from` to `to`.
    rtcore::Vec3d movedInPlane(const rtcore::Vec3d& point, const QPointF& from, const QPointF& to) const;
    /// Where the ray through a point of the area meets the plane through `point`, across `normal`; nothing:
    /// behind the eye, or nowhere.
    std::optional<rtcore::Vec3d> onPlane(const rtcore::Vec3d& point, const rtcore::Vec3d& normal,
                                         const QPointF& through) const;
    /// How far the hand leads it along an axis of unit length; 0 where that points at the eye.
    double distanceAlong(const rtcore::Vec3d& point, const rtcore::Vec3d& axis, const QPointF& from,
                         const QPointF& to) const;

  private:
    double depth(const rtcore::Vec3d& point) const { return dot(point - eye_, forward_); }
    double scaleAt(double depth) const { return parallel_ ? 1 : depth; }
    std::optional<QPointF> placeOf(const rtcore::Vec3d& off, double scale) const;
    rtcore::Vec3d across(const QPointF& off) const;
    std::optional<double> alongAxis(const rtcore::Vec3d& point, const rtcore::Vec3d& axis,
                                    const QPointF& at) const;
    rtcore::Vec3d startOf(const QPointF& through) const;
    std::optional<QLineF> inArea(QLineF line) const;

    rtcore::Vec3d eye_, forward_, right_, up_;
    QRectF area_;
    bool parallel_;
    double perPixel_; ///< scene units across; with perspective at depth 1
    double perLine_;  ///< the same downwards
};

/// The part of a line that the sections leave; nothing: none. What lies in a plane, but for `slack` scene
/// units, stays.
std::optional<std::pair<rtcore::Vec3d, rtcore::Vec3d>>
leftOf(const rtcore::SectionPlanes& sections, rtcore::Vec3d from, rtcore::Vec3d to, double slack);

} // namespace gui
