#include "gui/view/section_arcs.h"

#include <QPainter>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace gui {

namespace {

using rtcore::Vec3d;

constexpr double kArcRadius = 62; ///< pixels, seen from the axis
constexpr double kArcKnob = 4.5;  ///< pixels
constexpr double kApart = 14;     ///< pixels: knobs that are nearer are hard to tell apart

double offLine(const QPointF& at, const QLineF& line) {
    const QPointF along = line.p2() - line.p1();
    const double square = QPointF::dotProduct(along, along);
    const double part = square > 0 ? QPointF::dotProduct(at - line.p1(), along) / square : 0;
    return QLineF(at, line.pointAt(std::clamp(part, 0.0, 1.0))).length();
}

bool isOnArrow(const SectionArc& arc, const QLineF& arrow) {
    return arrow.length() > 0 && offLine(arc.knob, arrow) < kApart;
}

} // namespace

std::optional<SectionArc> sectionArc(const SceneImage& image, const ArrowInImage& at, const Vec3d& axis,
                                     double side) {
    constexpr int kPieces = 10;
    constexpr double kFirst = std::numbers::pi / 10, kLast = std::numbers::pi * 4 / 10;
    const Vec3d across = cross(axis, at.normal) * side;
    SectionArc arc{.side = side,
                   .circle = {at.hold, axis, kArcRadius * image.unitsPerPixel(at.hold), {}},
                   .line = {},
                   .knob = {}};
    const auto direction = [&](double angle) {
        return at.normal * std::cos(angle) + across * std::sin(angle);
    };
    const auto point = [&](double angle) { return image.at(at.hold + direction(angle) * arc.circle.radius); };
    for (int i = 0; i <= kPieces; ++i) {
        const auto here = point(kFirst + (kLast - kFirst) * i / kPieces);
        if (!here) return std::nullopt;
        arc.line << *here;
    }
    arc.circle.held = direction((kFirst + kLast) / 2);
    arc.knob = *point((kFirst + kLast) / 2);
    return arc;
}

std::vector<SectionArc> sectionArcs(const SceneImage& image, const ArrowInImage& at, const TurnAxes& axes) {
    std::vector<SectionArc> arcs;
    const auto isFree = [&](const SectionArc& arc) {
        const bool taken = !arcs.empty() && QLineF(arcs[0].knob, arc.knob).length() < kApart;
        return !taken && !isOnArrow(arc, at.arrow);
    };
    for (int number = 0; number < 2; ++number)
        for (const double side : {1.0, -1.0}) {
            auto arc = sectionArc(image, at, axes.at(static_cast<std::size_t>(number)), side);
            if (!arc || !isFree(*arc)) continue;
            arc->number = number;
            arcs.push_back(*arc);
            break;
        }
    return arcs;
}

void drawArc(QPainter& painter, const SectionArc& arc, const QColor& colour, const QColor& shade) {
    painter.setBrush(Qt::NoBrush);
    for (const QPen& pen : {QPen(shade, 5, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin),
                            QPen(colour, 2, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin)}) {
        painter.setPen(pen);
        painter.drawPolyline(arc.line);
    }
    painter.setPen(QPen(shade, 2));
    painter.setBrush(colour);
    painter.drawEllipse(arc.knob, kArcKnob, kArcKnob);
}

} // namespace gui
