/// How a storey's outline lies in an area of the screen, and the storeys by their heights.
#pragma once

#include "gui/session/server_status.h"

#include "common/commands/outline_text.h"

#include <QLineF>
#include <QPointF>
#include <QRectF>
#include <QSizeF>
#include <QTransform>

#include <array>
#include <vector>

namespace gui {

/// Positions of the model are in the coordinates of its file; points of the area in its pixels.
class PlanFit {
  public:
    /// As large as it fits, in the middle.
    PlanFit(const app::ToldOutline& outline, const QRectF& area);

    /// From steps of the outline to points.
    const QTransform& transform() const { return fromSteps_; }
    QPointF at(const std::array<double, 3>& position) const;
    /// On the storey's floor.
    std::array<double, 3> floorAt(const QPointF& point) const;
    /// Where an eye at the point is: a person's on the storey's floor, or, without storeys, one at that
    /// height along the up axis.
    std::array<double, 3> eyeAt(const QPointF& point, double height) const;
    /// From the camera one pixel in the direction of its view, or, where it looks straight up or down, in
    /// that of the upper edge of its image; points at the camera alone where even that is none.
    QLineF directionOf(const View& view) const;
    /// The direction of that view, turned around the up axis until it leads towards the point; level, where
    /// it is nearly upright. The view as it is where the point is the camera's own.
    std::array<float, 3> turnedTo(const QPointF& point, const View& view) const;

  private:
    app::ToldOutline outline_; ///< without its lines
    QTransform fromSteps_, toSteps_;
};

/// The size of a plan in an area: as large as it fits; empty where nothing is cut.
QSizeF planSize(const app::ToldOutline& outline, const QSizeF& area);

/// Of a position along the up axis of the outline.
double heightOf(const std::array<double, 3>& position, const app::ToldOutline& outline);

/// The number of the ground floor, by floors in metres: the one nearest to the zero of the model's file,
/// where drawings of buildings have it, within 1.5 m; else the lowest. 0 without storeys.
int groundFloor(const std::vector<double>& floors);

} // namespace gui
