/// Where the image shows points and lines of the scene, by the camera of its frame.
#pragma once

#include "gui/session/server_status.h"

#include "rtcore/math/vec.h"
#include "rtcore/scene/section_planes.h"

#include <QLineF>
#include <QPointF>
#include <QRectF>

#include <optional>
#include <utility>

namespace gui {

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

  private:
    double depth(const rtcore::Vec3d& point) const { return dot(point - eye_, forward_); }
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
