/// How a section turns: about two axes in its plane, one at a time, by a hand that goes around its arrow.
#pragma once

#include "gui/models/scene_image.h"

#include "rtcore/math/vec.h"
#include "rtcore/scene/section_planes.h"

#include <QPointF>

#include <array>

namespace gui {

/// Two axes of unit length across a normal of unit length, the first of them level; of a level plane both
/// are. `up` of unit length.
using TurnAxes = std::array<rtcore::Vec3d, 2>;
TurnAxes turnAxesOf(const rtcore::Vec3d& normal, const rtcore::Vec3d& up);

/// A direction, turned about an axis of unit length.
rtcore::Vec3d turned(const rtcore::Vec3d& direction, const rtcore::Vec3d& axis, double radians);

/// The turn of a normal, of unit length, nearest to `radians` after which it stands at a multiple of 15
/// degrees from an axis of the scene, as seen along `axis`.
double inTurnSteps(const rtcore::Vec3d& normal, const rtcore::Vec3d& axis, double radians);

/// The six planes around a box, in any order: what they leave would be none if one was turned.
bool isBox(const rtcore::SectionPlanes& sections);

/// A circle around an axis, and where on it a hand has taken hold; scene units.
struct TurnCircle {
    rtcore::Vec3d middle, axis; ///< of unit length
    double radius = 0;
    rtcore::Vec3d held; ///< the direction from the middle to the hand's hold, of unit length
};

/// So many radians the hand turns it, that has gone from `from` to `to`, by way of `before`: as the hand goes
/// around the axis, or, where the image shows the circle from its side, as far along that as the circle's
/// nearest, or farthest, point goes.
double turnLed(const SceneImage& image, const TurnCircle& circle, const QPointF& from, const QPointF& to,
               double before);

} // namespace gui
