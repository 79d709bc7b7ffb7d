/// Handles that turn a section: two arcs beside its arrow, each with a knob, and how they are painted.
#pragma once

#include "gui/models/scene_image.h"
#include "gui/models/section_turn.h"

#include <QColor>
#include <QLineF>
#include <QPointF>
#include <QPolygonF>

#include <optional>
#include <vector>

class QPainter;

namespace gui {

/// A point of a section, its normal, of unit length, and its arrow in the image, of no length where that
/// points at the eye.
struct ArrowInImage {
    rtcore::Vec3d hold, normal;
    QLineF arrow;
};

struct SectionArc {
    int number = 0;    ///< of its axis in TurnAxes
    double side = 1;   ///< of the arrow, on which it stands: 1 or -1
    TurnCircle circle; ///< scene units
    QPolygonF line;    ///< widget pixels, as the knob
    QPointF knob;
};

/// Nothing where it is not in front of the eye.
std::optional<SectionArc> sectionArc(const SceneImage& image, const ArrowInImage& at,
                                     const rtcore::Vec3d& axis, double side);

/// Those of both axes, each on the side where its knob is apart from the arrow and from the other's; none
/// where it is so on neither.
std::vector<SectionArc> sectionArcs(const SceneImage& image, const ArrowInImage& at, const TurnAxes& axes);

void drawArc(QPainter& painter, const SectionArc& arc, const QColor& colour, const QColor& shade);

} // namespace gui
