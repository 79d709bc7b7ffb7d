#include "gui/view/section_handles.h"

#include "gui/session/session.h"
#include "gui/view/frame_view.h"
#include "gui/view/input_capture.h"
#include "gui/view/shown_image.h"

#include "rtcore/scene/up_axis.h"

#include <QKeyEvent>
#include <QLineF>
#include <QMouseEvent>
#include <QPainter>
#include <QPolygonF>

#include <algorithm>
#include <cmath>

namespace gui {

namespace {

using rtcore::Vec3d;

constexpr double kArrow = 64;       ///< pixels, seen from the side
constexpr double kShortArrow = 18;  ///< below, it points at the eye
constexpr double kGrab = 10;        ///< pixels: how near a click is to it
constexpr double kFirstMove = 3;    ///< pixels: what moves less is a click
constexpr double kKnobRadius = 6.5; ///< pixels
const QColor kSectionColour(120, 210, 250), kSelectedSection(255, 200, 60), kHoveredSection(255, 255, 255),
    kSectionShade(0, 0, 0, 170);

double fromSegment(const QPointF& at, const QLineF& line) {
    const QPointF along = line.p2() - line.p1(), off = at - line.p1();
    const double square = QPointF::dotProduct(along, along);
    const double part = square > 0 ? std::clamp(QPointF::dotProduct(off, along) / square, 0.0, 1.0) : 0;
    return QLineF(at, line.pointAt(part)).length();
}

/// Axes stay axes.
Vec3d withoutNoise(const Vec3d& unit) {
    constexpr double kDigits = 1e7;
    return {std::round(unit.x * kDigits) / kDigits, std::round(unit.y * kDigits) / kDigits,
            std::round(unit.z * kDigits) / kDigits};
}

/// A head at the end, of a line that is long enough for one.
QPolygonF headOf(const QLineF& arrow) {
    constexpr double kLong = 14, kWide = 6;
    const QPointF along = (arrow.p2() - arrow.p1()) / arrow.length(), aside(-along.y(), along.x());
    const QPointF foot = arrow.p2() - kLong * along;
    return {{arrow.p2(), foot + kWide * aside, foot - kWide * aside}};
}

} // namespace

SectionHandles::SectionHandles(FrameView& view, Session& session, QObject* parent)
    : QObject(parent), view_(view), session_(session) {
    view_.installEventFilter(this); // asked before the camera's
    view_.addMarks([this](QPainter& painter) { draw(painter); });
}

void SectionHandles::setShown(bool shown) {
    if (shown == shown_) return;
    shown_ = shown;
    endDrag();
    hover({-1, -1});
}

// A hand that holds a plane knows better where it is than a server that is asked behind it.
void SectionHandles::setState(const SceneState& state) {
    state_ = state;
    if (drag_ && drag_->number > count()) endDrag();
    if (drag_ && drag_->moves) plane(drag_->number) = drag_->now;
    view_.update();
}

void SectionHandles::setSelected(int number) {
    selected_ = number;
    view_.update();
}

// --- Where they are ---

std::optional<SceneImage> SectionHandles::image() const {
    if (!shown_ || state_.bounds.empty()) return std::nullopt;
    return shownImage(view_, session_, state_);
}

rtcore::SectionPlane& SectionHandles::plane(int number) {
    return state_.sections.planes[static_cast<std::size_t>(number - 1)];
}

SectionMark SectionHandles::mark(int number) const {
    return markOf(state_.sections, static_cast<std::size_t>(number - 1), state_.bounds);
}

// While its plane stays as the drag has left it, and it is seen.
std::optional<Vec3d> SectionHandles::keptFoot(int number, const SectionMark& at, const SceneImage& in) const {
    constexpr double kRounded = 1e-4; // of the box, and of an angle
    if (!foot_ || foot_->number != number) return std::nullopt;
    const double off = std::fabs(dot(at.normal, foot_->hold - at.middle));
    if (off > kRounded * double{state_.bounds.diagonal()}) return std::nullopt;
    if (length(at.normal - foot_->normal) > kRounded) return std::nullopt;
    const auto place = in.at(foot_->hold);
    return place && view_.pictureArea().contains(*place) ? std::optional(foot_->hold) : std::nullopt;
}

// One that is held stays where it was taken.
std::optional<Vec3d> SectionHandles::foot(int number, const SectionMark& at, const SceneImage& in) const {
    if (drag_ && drag_->number == number) return drag_->handle.hold + at.normal * drag_->along;
    const auto kept = keptFoot(number, at, in);
    return kept ? kept : holdOf(at, in);
}

std::optional<SectionHandles::Handle> SectionHandles::handle(int number, const SceneImage& in) const {
    const SectionMark at = mark(number);
    const auto hold = foot(number, at, in);
    if (!hold) return std::nullopt;
    const auto place = in.at(*hold);
    const auto tip = in.at(*hold + at.normal * (kArrow * in.unitsPerPixel(*hold)));
    if (!place || !view_.pictureArea().contains(*place)) return std::nullopt;
    const bool facing = !tip || QLineF(*place, *tip).length() < kShortArrow;
    return Handle{*hold, *place, facing ? *place : *tip, facing};
}

std::optional<QPointF> SectionHandles::place(int number) const {
    const auto in = image();
    const auto at = in && number >= 1 && number <= count() ? handle(number, *in) : std::nullopt;
    return at ? std::optional(at->place) : std::nullopt;
}

std::optional<QPointF> SectionHandles::tip(int number) const {
    const auto in = image();
    const auto at = in && number >= 1 && number <= count() ? handle(number, *in) : std::nullopt;
    return at ? std::optional(at->tip) : std::nullopt;
}

// While one turns its plane, that one alone.
std::vector<SectionArc> SectionHandles::arcs(const SceneImage& in) const {
    if (selected_ < 1 || selected_ > count() || isBox(state_.sections)) return {};
    const auto held = handle(selected_, in);
    if (!held) return {};
    const ArrowInImage at{held->hold, mark(selected_).normal, {held->place, held->tip}};
    if (drag_ && drag_->arc) {
        auto arc = sectionArc(in, at, drag_->arc->circle.axis, drag_->arc->side);
        if (!arc) return {};
        arc->number = drag_->arc->number;
        return {*arc};
    }
    const rtcore::Vec3 up = rtcore::axisNamed(state_.up.toStdString()).value_or(rtcore::Vec3{0, 1, 0});
    return sectionArcs(in, at, turnAxesOf(at.normal, exactOf(up)));
}

std::optional<QPointF> SectionHandles::knob(int axis) const {
    if (const auto in = image())
        for (const SectionArc& arc : arcs(*in))
            if (arc.number == axis) return arc.knob;
    return std::nullopt;
}

std::optional<SectionArc> SectionHandles::arcAt(const QPointF& at) const {
    const auto in = image();
    if (!in) return std::nullopt;
    std::optional<SectionArc> nearest;
    for (const SectionArc& arc : arcs(*in)) {
        const double off = QLineF(at, arc.knob).length();
        if (off < kGrab && (!nearest || off < QLineF(at, nearest->knob).length())) nearest = arc;
    }
    return nearest;
}

/// The nearest one; 0: none.
int SectionHandles::handleAt(const QPointF& at) const {
    const auto in = image();
    int nearest = 0;
    double distance = kGrab;
    for (int number = 1; in && number <= count(); ++number) {
        const auto there = handle(number, *in);
        const double off = there ? fromSegment(at, {there->place, there->tip}) : kGrab;
        if (off >= distance) continue;
        distance = off;
        nearest = number;
    }
    return nearest;
}

// --- Mouse ---

bool SectionHandles::eventFilter(QObject*, QEvent* event) {
    if (!shown_ || view_.input().captured() || view_.clicksTaken()) return false;
    switch (event->type()) {
    case QEvent::MouseButtonPress:
    case QEvent::MouseButtonDblClick:
        return press(static_cast<const QMouseEvent&>(*event));
    case QEvent::MouseMove: {
        const auto& move = static_cast<const QMouseEvent&>(*event);
        if (move.buttons() == Qt::NoButton) {
            if (drag_) endDrag(); // its end was another's
            hover(move.position());
        }
        if (drag_) drag(move);
        return drag_.has_value();
    }
    case QEvent::MouseButtonRelease:
        if (!drag_) return false;
        endDrag();
        return true;
    case QEvent::Leave:
        if (!drag_) hover({-1, -1});
        return false;
    case QEvent::ShortcutOverride:
    case QEvent::KeyPress:
        if (!key(static_cast<const QKeyEvent&>(*event))) return false;
        event->accept();
        return true;
    default:
        return false;
    }
}

bool SectionHandles::press(const QMouseEvent& event) {
    if (drag_) return true;
    if (event.button() != Qt::LeftButton) return false;
    const auto arc = arcAt(event.position());
    const int number = arc ? selected_ : handleAt(event.position());
    if (number == 0) return false;
    drag_ = Drag{.number = number,
                 .mark = mark(number),
                 .handle = *handle(number, *image()),
                 .start = plane(number),
                 .now = plane(number),
                 .from = event.position(),
                 .arc = arc};
    selected_ = number;
    view_.setFocus(Qt::MouseFocusReason);
    view_.update();
    emit picked(number);
    return true;
}

/// How far the hand leads the plane along its normal.
double SectionHandles::led(const SceneImage& in, const QPointF& to) const {
    const Handle& held = drag_->handle;
    const Vec3d& normal = drag_->mark.normal;
    if (!held.facing) return in.distanceAlong(held.hold, normal, drag_->from, to);
    const double away = dot(normal, in.towardsEye(held.hold)) > 0 ? -1 : 1;
    return away * (drag_->from.y() - to.y()) * in.unitsPerPixel(held.hold);
}

void SectionHandles::drag(const QMouseEvent& event) {
    const auto in = image();
    const bool goesOn = drag_->moves;
    if (!in || drag_->over) return;
    if (!goesOn && QLineF(drag_->from, event.position()).length() < kFirstMove) return;
    drag_->moves = true;
    if (drag_->arc)
        turn(*in, event.position(), (event.modifiers() & Qt::ShiftModifier) != 0, goesOn);
    else
        move(*in, event.position(), goesOn);
}

void SectionHandles::move(const SceneImage& in, const QPointF& to, bool goesOn) {
    drag_->along = std::clamp(led(in, to), drag_->mark.back, drag_->mark.on);
    rtcore::FilePoint point = state_.origin.inFile(drag_->start.point);
    for (int axis = 0; axis < 3; ++axis)
        point.at(static_cast<std::size_t>(axis)) += drag_->mark.normal[axis] * drag_->along;
    drag_->now.point = state_.origin.local(point);
    plane(drag_->number) = drag_->now;
    view_.update();
    emit moved(drag_->number, point, goesOn);
}

// About the arrow's foot, so that the plane goes through that from then on.
void SectionHandles::turn(const SceneImage& in, const QPointF& to, bool inSteps, bool goesOn) {
    const TurnCircle& circle = drag_->arc->circle;
    drag_->angle = turnLed(in, circle, drag_->from, to, drag_->angle);
    const Vec3d& start = drag_->mark.normal;
    const double angle = inSteps ? inTurnSteps(start, circle.axis, drag_->angle) : drag_->angle;
    const Vec3d normal = withoutNoise(gui::turned(start, circle.axis, angle));
    rtcore::FilePoint point = state_.origin.at;
    for (int axis = 0; axis < 3; ++axis) point.at(static_cast<std::size_t>(axis)) += circle.middle[axis];
    drag_->now = {state_.origin.local(point),
                  {static_cast<float>(normal.x), static_cast<float>(normal.y), static_cast<float>(normal.z)}};
    plane(drag_->number) = drag_->now;
    view_.update();
    emit turned(drag_->number, point, normal, goesOn);
}

bool SectionHandles::key(const QKeyEvent& event) {
    if (!drag_ || event.key() != Qt::Key_Escape) return false;
    if (event.type() == QEvent::KeyPress) takeBack();
    return true;
}

// What the server was told already belongs to the same step.
void SectionHandles::takeBack() {
    drag_->over = true;
    if (!drag_->moves) return;
    drag_->moves = false;
    drag_->along = 0;
    plane(drag_->number) = drag_->start;
    view_.update();
    const rtcore::FilePoint point = state_.origin.inFile(drag_->start.point);
    if (drag_->arc)
        emit turned(drag_->number, point, exactOf(drag_->start.normal), true);
    else
        emit moved(drag_->number, point, true);
}

void SectionHandles::endDrag() {
    if (drag_ && drag_->moves && drag_->number <= count()) {
        const Vec3d normal = mark(drag_->number).normal;
        foot_ = Foot{drag_->number, drag_->handle.hold + normal * drag_->along, normal};
    }
    drag_.reset();
    view_.update();
}

void SectionHandles::hover(const QPointF& at) {
    const int before = hovered_, arcBefore = hoveredArc_;
    const auto arc = arcAt(at);
    hoveredArc_ = arc ? arc->number : -1;
    hovered_ = arc ? 0 : handleAt(at);
    if (hovered_ == before && hoveredArc_ == arcBefore) return;
    if (hovered_ == 0 && !arc)
        view_.unsetCursor();
    else
        view_.setCursor(Qt::PointingHandCursor);
    view_.update();
}

// --- Drawing ---

QColor SectionHandles::colourOf(int number) const {
    if (number == hovered_) return kHoveredSection;
    return number == selected_ ? kSelectedSection : kSectionColour;
}

// No line over a handle.
void SectionHandles::draw(QPainter& painter) const {
    const auto in = image();
    if (!in) return;
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setClipRect(view_.pictureArea());
    for (int number = 1; number <= count(); ++number) drawOutline(painter, *in, number);
    for (int number = 1; number <= count(); ++number)
        if (const auto at = handle(number, *in)) drawHandle(painter, *at, colourOf(number));
    for (const SectionArc& arc : arcs(*in))
        drawArc(painter, arc, arc.number == hoveredArc_ ? kHoveredSection : kSelectedSection, kSectionShade);
    painter.restore();
}

void SectionHandles::drawOutline(QPainter& painter, const SceneImage& in, int number) const {
    const SpacePolygon outline = mark(number).outline;
    for (const QPen& pen : {QPen(kSectionShade, 3), QPen(colourOf(number), 1.2)}) {
        painter.setPen(pen);
        for (std::size_t i = 0; i < outline.size(); ++i)
            if (const auto line = in.line(outline[i], outline[(i + 1) % outline.size()]))
                painter.drawLine(*line);
    }
}

/// A knob with an arrow, or, where that points at the eye, with a dot in it.
void SectionHandles::drawHandle(QPainter& painter, const Handle& handle, const QColor& colour) const {
    const QLineF arrow(handle.place, handle.tip);
    if (!handle.facing) {
        const QPolygonF head = headOf(arrow);
        painter.setPen(QPen(kSectionShade, 6, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
        painter.drawLine(arrow.p1(), arrow.pointAt(0.85));
        painter.setBrush(kSectionShade);
        painter.drawPolygon(head);
        painter.setPen(QPen(colour, 3, Qt::SolidLine, Qt::RoundCap));
        painter.drawLine(arrow.p1(), arrow.pointAt(0.85));
        painter.setPen(Qt::NoPen);
        painter.setBrush(colour);
        painter.drawPolygon(head);
    }
    painter.setPen(QPen(kSectionShade, 2));
    painter.setBrush(colour);
    painter.drawEllipse(handle.place, kKnobRadius, kKnobRadius);
    if (!handle.facing) return;
    painter.setBrush(kSectionShade);
    painter.drawEllipse(handle.place, kKnobRadius / 3, kKnobRadius / 3);
}

} // namespace gui
