#include "gui/view/note_marks.h"

#include "gui/models/note_texts.h"
#include "gui/session/session.h"
#include "gui/view/frame_view.h"
#include "gui/view/input_capture.h"
#include "gui/view/shown_image.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>

#include <algorithm>
#include <utility>

namespace gui {

namespace {

constexpr double kDiscRadius = 10, kReachOfDisc = 13; ///< pixels
constexpr int kMinNoteDrag = 4;                       ///< pixels: what moves less is a click
const QColor kDiscColour(255, 255, 255, 235), kDiscEdge(20, 60, 120), kPendingDisc(120, 210, 250),
    kPaper(0, 0, 0, 190);

void drawDisc(QPainter& painter, const QPointF& at, const QColor& colour, const QString& number) {
    painter.setPen(QPen(kDiscEdge, 2));
    painter.setBrush(colour);
    painter.drawEllipse(at, kDiscRadius, kDiscRadius);
    const QRectF box(at - QPointF(2 * kDiscRadius, kDiscRadius), QSizeF(4 * kDiscRadius, 2 * kDiscRadius));
    painter.drawText(box, Qt::AlignCenter, number);
}

} // namespace

NoteMarks::NoteMarks(FrameView& view, Session& session, QObject* parent)
    : QObject(parent), view_(view), session_(session) {
    view_.installEventFilter(this); // asked before the camera's
    view_.addMarks([this](QPainter& painter) { draw(painter); });
}

void NoteMarks::setShown(bool shown) {
    shown_ = shown;
    hover(-1);
    view_.update();
}

void NoteMarks::setState(const SceneState& state) {
    state_ = state;
    if (hovered_ >= std::ssize(state_.notes)) hovered_ = -1;
    grasped_ = -1;
    view_.update();
}

void NoteMarks::setAdding(bool adding) {
    if (adding == adding_) return;
    adding_ = adding;
    pressed_.reset();
    view_.takeClicks(adding_);
    if (adding_)
        view_.setCursor(Qt::CrossCursor);
    else
        view_.unsetCursor();
    view_.update();
}

void NoteMarks::setPending(const std::optional<rtcore::Vec3d>& point) {
    pending_ = point;
    view_.update();
}

// --- Where they are ---

std::optional<QPointF> NoteMarks::placeIn(const SceneImage& image, const rtcore::Vec3d& point) const {
    if (!leftOf(state_.sections, point, point, cutSlack(state_))) return std::nullopt;
    const auto at = image.at(point);
    return at && view_.pictureArea().contains(*at) ? at : std::nullopt;
}

std::optional<QPointF> NoteMarks::place(int index) const {
    const auto image = shownImage(view_, session_, state_);
    if (!image || !shown_ || index < 0 || index >= std::ssize(state_.notes)) return std::nullopt;
    return placeIn(*image, state_.notes[static_cast<std::size_t>(index)].point);
}

/// The one that is painted last there.
int NoteMarks::at(const QPointF& position) const {
    const auto image = shownImage(view_, session_, state_);
    if (!image || !shown_) return -1;
    for (int i = static_cast<int>(state_.notes.size()) - 1; i >= 0; --i) {
        const auto place = placeIn(*image, state_.notes[static_cast<std::size_t>(i)].point);
        if (!place) continue;
        const QPointF off = *place - position;
        if (QPointF::dotProduct(off, off) <= kReachOfDisc * kReachOfDisc) return i;
    }
    return -1;
}

// --- Mouse and keys ---

bool NoteMarks::eventFilter(QObject*, QEvent* event) {
    if (view_.input().captured()) {
        hover(-1);
        return false;
    }
    switch (event->type()) {
    case QEvent::MouseButtonPress:
        return press(static_cast<const QMouseEvent&>(*event));
    case QEvent::MouseButtonDblClick:
        if (!adding_) return press(static_cast<const QMouseEvent&>(*event));
        return static_cast<const QMouseEvent&>(*event).button() == Qt::LeftButton;
    case QEvent::MouseMove: {
        const auto& move = static_cast<const QMouseEvent&>(*event);
        if (move.buttons() == Qt::NoButton) hover(at(move.position()));
        if (adding_ && move.buttons() == Qt::NoButton) view_.setCursor(Qt::CrossCursor);
        return false;
    }
    case QEvent::MouseButtonRelease:
        return release(static_cast<const QMouseEvent&>(*event));
    case QEvent::Leave:
        hover(-1);
        return false;
    case QEvent::ShortcutOverride:
    case QEvent::KeyPress:
        if (!adding_ || static_cast<const QKeyEvent&>(*event).key() != Qt::Key_Escape) return false;
        if (event->type() == QEvent::KeyPress) emit left();
        event->accept();
        return true;
    default:
        return false;
    }
}

void NoteMarks::hover(int index) {
    if (std::exchange(hovered_, index) != index) view_.update();
}

// While a drag turns the model it goes on doing so; a click captures no mouse.
bool NoteMarks::press(const QMouseEvent& event) {
    if (event.button() != Qt::LeftButton) return false;
    if (adding_) {
        pressed_ = event.position();
        if (view_.input().hand() == Hand::Turns) return false;
        view_.setFocus(Qt::MouseFocusReason);
        return true;
    }
    if (view_.clicksTaken()) return false;
    grasped_ = at(event.position());
    return grasped_ >= 0;
}

bool NoteMarks::release(const QMouseEvent& event) {
    if (event.button() != Qt::LeftButton) return false;
    if (const int index = std::exchange(grasped_, -1); index >= 0) {
        if (at(event.position()) == index) emit picked(index);
        return true;
    }
    if (!adding_ || !pressed_) return false;
    const QPointF from = *std::exchange(pressed_, std::nullopt);
    if ((event.position() - from).manhattanLength() >= kMinNoteDrag) return false;
    if (const auto there = inServersImage(view_, session_, event.position())) emit placed(*there);
    return false;
}

// --- Drawing ---

void NoteMarks::draw(QPainter& painter) const {
    const auto image = shownImage(view_, session_, state_);
    if (!image) return;
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setClipRect(view_.pictureArea());
    const int count = shown_ ? static_cast<int>(state_.notes.size()) : 0;
    for (int i = 0; i < count; ++i)
        if (const auto at = placeIn(*image, state_.notes[static_cast<std::size_t>(i)].point))
            drawDisc(painter, *at, kDiscColour, QString::number(i + 1));
    if (pending_)
        if (const auto at = image->at(*pending_)) drawDisc(painter, *at, kPendingDisc, QStringLiteral("+"));
    if (const auto at = place(hovered_))
        drawText(painter, *at, wholeNote(state_.notes[static_cast<std::size_t>(hovered_)]));
    painter.restore();
}

/// Beside the disc, within the image.
void NoteMarks::drawText(QPainter& painter, const QPointF& at, const QString& text) const {
    constexpr double kWidest = 320, kPadding = 6, kRound = 4, kOff = kDiscRadius + 4;
    constexpr int kFlags = Qt::AlignLeft | Qt::AlignTop | Qt::TextWordWrap | Qt::TextWrapAnywhere;
    const QRectF area = view_.pictureArea().adjusted(kPadding, kPadding, -kPadding, -kPadding);
    const QSizeF room(std::min(kWidest, area.width()) - 2 * kPadding, area.height() - 2 * kPadding);
    if (!(room.width() > 0 && room.height() > 0)) return;
    const QRectF needed = painter.fontMetrics().boundingRect(QRectF(QPointF(), room).toRect(), kFlags, text);
    QRectF box(at + QPointF(kOff, kOff), needed.size().boundedTo(room) + QSizeF(2, 2) * kPadding);
    if (box.right() > area.right()) box.moveRight(std::max(at.x() - kOff, area.left() + box.width()));
    if (box.bottom() > area.bottom()) box.moveBottom(std::max(at.y() - kOff, area.top() + box.height()));
    painter.setPen(Qt::NoPen);
    painter.setBrush(kPaper);
    painter.drawRoundedRect(box, kRound, kRound);
    painter.setClipRect(box, Qt::IntersectClip);
    painter.setPen(Qt::white);
    painter.drawText(box.adjusted(kPadding, kPadding, -kPadding, -kPadding), kFlags, text);
}

} // namespace gui
