#include "gui/view/light_handles.h"

#include "gui/session/session.h"
#include "gui/view/frame_view.h"
#include "gui/view/input_capture.h"
#include "gui/view/shown_image.h"

#include <QFontMetrics>
#include <QMouseEvent>
#include <QPainter>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace gui {

namespace {

using rtcore::Vec3d;

constexpr double kMarkRadius = 7, kReach = 11; ///< pixels: of a mark, and how near a click is to it
constexpr double kHandle = 56;                 ///< pixels from the mark to the end of a handle, at most
constexpr double kShortest = 18;               ///< below, an axis that points at the eye has no handle
constexpr double kMinDrag = 3;

const std::array<QColor, 3> kAxisColours{QColor(235, 90, 80), QColor(120, 210, 90), QColor(90, 150, 250)};

Vec3d axisOf(int axis) {
    Vec3d unit{};
    unit[axis] = 1;
    return unit;
}

QVector3D floatsOf(const Vec3d& v) {
    return {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)};
}

double apart(const QPointF& a, const QPointF& b) {
    const QPointF off = a - b;
    return std::hypot(off.x(), off.y());
}

/// A line that is seen on any ground.
void drawLine(QPainter& painter, const QPointF& from, const QPointF& to, const QColor& colour) {
    painter.setPen(QPen(QColor(0, 0, 0, 170), 4, Qt::SolidLine, Qt::RoundCap));
    painter.drawLine(from, to);
    painter.setPen(QPen(colour, 2, Qt::SolidLine, Qt::RoundCap));
    painter.drawLine(from, to);
}

/// Those of a sun, around its mark.
void drawRays(QPainter& painter, const QPointF& centre, const QColor& colour) {
    constexpr int kRays = 8;
    for (int i = 0; i < kRays; ++i) {
        const double angle = 2 * std::numbers::pi * i / kRays;
        const QPointF towards(std::cos(angle), std::sin(angle));
        drawLine(painter, centre + (kMarkRadius + 3) * towards, centre + (kMarkRadius + 8) * towards, colour);
    }
}

} // namespace

LightHandles::LightHandles(FrameView& view, Session& session, QObject* parent)
    : QObject(parent), view_(view), session_(session) {
    view_.installEventFilter(this); // asked before the camera's
    view_.addMarks([this](QPainter& painter) { draw(painter); });
}

void LightHandles::setShown(bool shown) {
    shown_ = shown;
    drag_.reset();
    view_.update();
}

void LightHandles::setMarks(const QList<LightMark>& marks, const SceneState& state) {
    marks_ = marks;
    state_ = state;
    if (!drag_) dropped_.reset();
    view_.update();
}

void LightHandles::setSelected(int id) {
    if (id != selected_ && !drag_) dropped_.reset();
    selected_ = id;
    view_.update();
}

// --- Where they are ---

std::optional<SceneImage> LightHandles::image() const {
    return shown_ ? shownImage(view_, session_, state_) : std::nullopt;
}

const LightMark* LightHandles::find(int id) const {
    const auto found = std::ranges::find(marks_, id, &LightMark::id);
    return found == marks_.end() ? nullptr : &*found;
}

QVector3D LightHandles::positionOf(const LightMark& mark) const {
    return dropped_ && mark.id == selected_ ? *dropped_ : mark.position;
}

std::optional<QPointF> LightHandles::place(int id) const {
    const LightMark* mark = find(id);
    const std::optional<SceneImage> in = image();
    if (mark == nullptr || !in) return std::nullopt;
    if (drag_ && drag_->onSurface && drag_->id == id) return drag_->now;
    return placeOf(*mark, *in);
}

std::optional<QPointF> LightHandles::placeOf(const LightMark& mark, const SceneImage& in) const {
    return mark.far ? in.farAway(exactOf(positionOf(mark))) : in.at(exactOf(positionOf(mark)));
}

std::optional<QPointF> LightHandles::handle(int axis) const {
    const LightMark* mark = find(selected_);
    const std::optional<QPointF> centre = place(selected_);
    if (mark == nullptr || mark->far || !centre) return std::nullopt;
    const std::optional<SceneImage> in = image();
    const Vec3d position = exactOf(positionOf(*mark));
    const double length = kHandle * in->unitsPerPixel(position);
    const auto end = in->at(position + axisOf(axis) * length);
    if (!end || apart(*end, *centre) < kShortest) return std::nullopt;
    return end;
}

const LightMark* LightHandles::markAt(const QPointF& at) const {
    const LightMark* nearest = nullptr;
    double distance = kReach;
    for (const LightMark& mark : marks_) {
        const std::optional<QPointF> there = place(mark.id);
        if (!there || apart(*there, at) > distance) continue;
        distance = apart(*there, at);
        nearest = &mark;
    }
    return nearest;
}

std::optional<int> LightHandles::axisAt(const QPointF& at) const {
    for (int axis = 0; axis < 3; ++axis) {
        const std::optional<QPointF> end = handle(axis);
        if (end && apart(*end, at) <= kReach) return axis;
    }
    return std::nullopt;
}

// --- Mouse ---

bool LightHandles::eventFilter(QObject*, QEvent* event) {
    if (!shown_ || view_.input().captured() || view_.clicksTaken()) return false;
    switch (event->type()) {
    case QEvent::MouseButtonPress:
    case QEvent::MouseButtonDblClick:
        return press(static_cast<const QMouseEvent&>(*event));
    case QEvent::MouseMove:
        if (drag_)
            drag(static_cast<const QMouseEvent&>(*event));
        else
            showPointer(static_cast<const QMouseEvent&>(*event).position());
        return drag_.has_value();
    case QEvent::MouseButtonRelease:
        if (!drag_) return false;
        drag_.reset();
        view_.update();
        return true;
    default:
        return false;
    }
}

bool LightHandles::press(const QMouseEvent& event) {
    if (event.button() != Qt::LeftButton) return false;
    const QPointF at = event.position();
    const LightMark* mark = markAt(at);
    const std::optional<int> axis = mark != nullptr ? std::nullopt : axisAt(at);
    if (axis) mark = find(selected_);
    if (mark == nullptr) return false;
    const int id = mark->id;
    const QVector3D start = positionOf(*mark);
    drag_ = Drag{.id = id, .axis = axis, .start = start, .from = at, .now = at};
    if (id != selected_) {
        dropped_.reset();
        selected_ = id;
    }
    view_.setFocus(Qt::MouseFocusReason);
    view_.update();
    emit picked(id);
    return true;
}

void LightHandles::drag(const QMouseEvent& event) {
    const std::optional<SceneImage> in = image();
    drag_->now = event.position();
    const bool goesOn = drag_->moves;
    if (!in || (!goesOn && apart(drag_->from, drag_->now) < kMinDrag)) return;
    drag_->moves = true;
    const int id = drag_->id;
    const LightMark* mark = find(id);
    if (mark != nullptr && mark->far) return dragFar(*in, goesOn);
    drag_->onSurface = !drag_->axis && (event.modifiers() & Qt::ShiftModifier) != 0;
    view_.update();
    if (drag_->onSurface) {
        dropped_.reset();
        const std::optional<QPointF> point = inServersImage(view_, session_, drag_->now);
        if (point) emit movedOntoSurface(id, *point, goesOn);
        return;
    }
    dropped_ = floatsOf(dragged(*in));
    emit moved(id, *dropped_, goesOn);
}

Vec3d LightHandles::dragged(const SceneImage& in) const {
    const Vec3d start = exactOf(drag_->start);
    if (!drag_->axis) return in.movedInPlane(start, drag_->from, drag_->now);
    const Vec3d axis = axisOf(*drag_->axis);
    return start + axis * in.distanceAlong(start, axis, drag_->from, drag_->now);
}

// As far as the hand goes, the mark goes.
void LightHandles::dragFar(const SceneImage& in, bool goesOn) {
    const std::optional<QPointF> start = in.farAway(exactOf(drag_->start));
    if (!start) return;
    dropped_ = floatsOf(in.ray(*start + drag_->now - drag_->from));
    view_.update();
    emit turned(drag_->id, *dropped_, goesOn);
}

void LightHandles::showPointer(const QPointF& at) {
    const bool pointing = markAt(at) != nullptr || axisAt(at).has_value();
    if (pointing == std::exchange(pointing_, pointing)) return;
    if (pointing)
        view_.setCursor(Qt::PointingHandCursor);
    else
        view_.unsetCursor();
}

// --- Drawing ---

void LightHandles::draw(QPainter& painter) const {
    const std::optional<SceneImage> in = image();
    if (!in) return;
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setClipRect(view_.pictureArea());
    for (const LightMark& mark : marks_) drawMark(painter, *in, mark);
    painter.restore();
}

void LightHandles::drawMark(QPainter& painter, const SceneImage& in, const LightMark& mark) const {
    const std::optional<QPointF> centre = place(mark.id);
    if (!centre) return;
    if (mark.direction) {
        const Vec3d position = exactOf(positionOf(mark));
        const double length = 0.6 * kHandle * in.unitsPerPixel(position);
        const std::optional<QPointF> end = in.at(position + exactOf(*mark.direction) * length);
        if (end) drawLine(painter, *centre, *end, mark.colour);
    }
    const bool selected = mark.id == selected_;
    if (mark.far) drawRays(painter, *centre, mark.colour);
    if (selected) drawHandles(painter, *centre);
    painter.setPen(QPen(QColor(0, 0, 0, 190), selected ? 5 : 4));
    painter.setBrush(Qt::NoBrush);
    painter.drawEllipse(*centre, kMarkRadius, kMarkRadius);
    painter.setPen(QPen(selected ? QColor(255, 200, 60) : QColor(Qt::white), selected ? 2.5 : 1.5));
    painter.setBrush(mark.on ? QBrush(mark.colour) : QBrush(QColor(0, 0, 0, 120)));
    painter.drawEllipse(*centre, kMarkRadius, kMarkRadius);
    if (selected) drawName(painter, mark, *centre);
}

void LightHandles::drawName(QPainter& painter, const LightMark& mark, const QPointF& centre) const {
    const QRect words = painter.fontMetrics().boundingRect(mark.name).adjusted(-4, -2, 4, 2);
    const QRectF box(centre.x() - words.width() / 2.0, centre.y() + kMarkRadius + 6, words.width(),
                     words.height());
    painter.setPen(Qt::NoPen);
    painter.setBrush(QColor(0, 0, 0, 140));
    painter.drawRoundedRect(box, 4, 4);
    painter.setPen(Qt::white);
    painter.drawText(box, Qt::AlignCenter, mark.name);
}

void LightHandles::drawHandles(QPainter& painter, const QPointF& centre) const {
    constexpr double kKnob = 4.5;
    for (int axis = 0; axis < 3; ++axis) {
        const std::optional<QPointF> end = handle(axis);
        if (!end) continue;
        const QColor& colour = kAxisColours.at(static_cast<std::size_t>(axis));
        drawLine(painter, centre, *end, colour);
        painter.setPen(QPen(QColor(0, 0, 0, 170), 1));
        painter.setBrush(colour);
        painter.drawEllipse(*end, kKnob, kKnob);
    }
}

} // namespace gui
