#include "gui/view/measure_marks.h"

#include "gui/session/session.h"
#include "gui/view/frame_view.h"
#include "gui/view/hidden_measures.h"
#include "gui/view/input_capture.h"
#include "gui/view/shown_image.h"

#include <QFontMetrics>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace gui {

namespace {

using rtcore::MeasureKind;
using rtcore::Vec3d;

constexpr int kMinMeasureDrag = 4; ///< pixels: what moves less is a click
const QColor kMeasureColour(255, 200, 60), kPendingColour(120, 210, 250), kDark(0, 0, 0, 170),
    kPaleText(255, 255, 255, 170);

void drawOnAny(QPainter& painter, const QLineF& line, const QColor& colour) {
    painter.setPen(QPen(kDark, 4, Qt::SolidLine, Qt::RoundCap));
    painter.drawLine(line);
    painter.setPen(QPen(colour, 2, Qt::SolidLine, Qt::RoundCap));
    painter.drawLine(line);
}

QColor paler(QColor colour, float by = 0.5F) {
    colour.setAlphaF(by * colour.alphaF());
    return colour;
}

void drawDashed(QPainter& painter, const QLineF& line) {
    QPen pen(paler(kDark), 4, Qt::SolidLine, Qt::FlatCap);
    painter.setPen(pen);
    painter.drawLine(line);
    pen = QPen(paler(kMeasureColour, 0.8F), 2, Qt::CustomDashLine, Qt::FlatCap);
    pen.setDashPattern({3, 3}); // widths of the line
    painter.setPen(pen);
    painter.drawLine(line);
}

/// A square for corners, a triangle for middles, a circle for all else.
void drawCaught(QPainter& painter, const QPointF& at, const QString& kind) {
    constexpr double kSize = 6;
    painter.setBrush(Qt::NoBrush);
    for (const QPen& pen : {QPen(kDark, 4), QPen(kPendingColour, 2)}) {
        painter.setPen(pen);
        if (kind == QLatin1String("corner"))
            painter.drawRect(QRectF(at.x() - kSize, at.y() - kSize, 2 * kSize, 2 * kSize));
        else if (kind == QLatin1String("middle"))
            painter.drawPolygon(QPolygonF(
                {at + QPointF(0, -kSize), at + QPointF(kSize, kSize), at + QPointF(-kSize, kSize)}));
        else
            painter.drawEllipse(at, kSize - 1, kSize - 1);
    }
}

std::array<double, 3> inFile(const Vec3d& p, const rtcore::LocalOrigin& origin) {
    return {p.x + origin.at[0], p.y + origin.at[1], p.z + origin.at[2]};
}

} // namespace

std::optional<CaughtPoint> readCaught(const QString& answer, const rtcore::LocalOrigin& origin) {
    const QStringList words = answer.split(QLatin1Char(' '));
    if (words.size() != 4) return std::nullopt;
    std::array<double, 3> p{};
    for (std::size_t i = 0; i < 3; ++i) {
        bool good = false;
        p.at(i) = words[static_cast<qsizetype>(i) + 1].toDouble(&good) - origin.at.at(i);
        if (!good) return std::nullopt;
    }
    return CaughtPoint{words[0], {p[0], p[1], p[2]}};
}

MeasureMarks::MeasureMarks(FrameView& view, Session& session, QObject* parent)
    : QObject(parent), view_(view), session_(session), hidden_(new HiddenMeasures(session, this)) {
    view_.installEventFilter(this); // asked before the camera's
    view_.addMarks([this](QPainter& painter) { draw(painter); });
    connect(&session_, &Session::frameChanged, this, &MeasureMarks::onFrame);
    connect(hidden_, &HiddenMeasures::changed, &view_, qOverload<>(&QWidget::update));
}

void MeasureMarks::setShown(bool shown) {
    shown_ = shown;
    askWhatIsHidden();
    view_.update();
}

void MeasureMarks::setState(const SceneState& state) {
    state_ = state;
    askWhatIsHidden();
    view_.update();
}

void MeasureMarks::askWhatIsHidden() {
    hidden_->setWanted((shown_ || kind_) && !state_.measures.all.empty());
}

void MeasureMarks::setMeasuring(std::optional<MeasureKind> kind) {
    kind_ = kind;
    askWhatIsHidden();
    view_.takeClicks(kind_.has_value());
    caught_.reset();
    if (kind_)
        view_.setCursor(Qt::CrossCursor);
    else
        view_.unsetCursor();
    forgetPoints();
}

void MeasureMarks::forgetPoints() {
    ++round_;
    ends_ = false;
    waiting_ = 0;
    points_.clear();
    view_.update();
    emit pointsChanged();
}

// --- Where they are ---

std::optional<SceneImage> MeasureMarks::image() const { return shownImage(view_, session_, state_); }

std::optional<QPointF> MeasureMarks::place(const Vec3d& point) const {
    const auto in = image();
    return in ? in->at(point) : std::nullopt;
}

bool MeasureMarks::isLeft(Vec3d point) const {
    return leftOf(state_.sections, point, point, cutSlack(state_)).has_value();
}

bool MeasureMarks::isDimmed(std::size_t measure, std::size_t leg) const {
    return hidden_->isHidden(measure, leg) || hidden_->isHidden(measure, leg + 1);
}

bool MeasureMarks::isDimmed(std::size_t measure) const {
    for (std::size_t i = 0; i < state_.measures.all.at(measure).points.size(); ++i)
        if (hidden_->isHidden(measure, i)) return true;
    return false;
}

std::vector<QPointF> MeasureMarks::labelPlaces() const {
    std::vector<QPointF> places;
    const auto in = image();
    if (!in || !shown_) return places;
    for (const rtcore::KeptMeasure& measure : state_.measures.all)
        for (const MeasureLabel& label : labelsOf(measure, state_))
            if (const auto at = in->at(label.point); at && isLeft(label.point)) places.push_back(*at);
    return places;
}

// --- What the pointer catches ---

// Another view has other points under the pointer; they are asked for once it rests.
void MeasureMarks::onFrame() {
    const View now = session_.status().view, before = std::exchange(seen_, now);
    if (!kind_ || !pointer_ || now == askedAt_) return;
    caught_.reset();
    if (now == before) look(*pointer_);
}

void MeasureMarks::look(const QPointF& at) {
    pointer_ = at;
    asksAgain_ = true;
    ask();
}

// One question at a time: a hand that moves asks again, where it is by then.
void MeasureMarks::ask() {
    if (asking_ || !asksAgain_ || !kind_ || !pointer_) return;
    const auto there = inServersImage(view_, session_, *pointer_);
    asksAgain_ = false;
    if (!there) return caught_.reset();
    asking_ = true;
    const View view = askedAt_ = session_.status().view;
    session_.send(command::measurePoint(there->x(), there->y()), this,
                  [this, at = *pointer_, view](const Answer& answer) {
                      asking_ = false;
                      onCaught(at, view, answer.done ? answer.text : QString());
                      ask();
                  });
}

// The answer to a question of long ago is dropped.
void MeasureMarks::onCaught(const QPointF& at, const View& view, const QString& answer) {
    const bool current =
        pointer_ && (*pointer_ - at).manhattanLength() < kMinMeasureDrag && view == session_.status().view;
    caught_ = current ? readCaught(answer, state_.origin) : std::nullopt;
    view_.update();
}

Vec3d MeasureMarks::heldTo(Vec3d point, bool onAxis) const {
    if (!onAxis || points_.empty()) return point;
    const Vec3d from = points_.back(), off = point - from;
    int axis = 0;
    for (int i = 1; i < 3; ++i)
        if (std::fabs(off[i]) > std::fabs(off[axis])) axis = i;
    Vec3d held = from;
    held[axis] = point[axis];
    return held;
}

// --- Mouse and keys ---

bool MeasureMarks::eventFilter(QObject*, QEvent* event) {
    if (!kind_ || view_.input().captured()) return false;
    switch (event->type()) {
    case QEvent::MouseButtonPress:
        return press(static_cast<const QMouseEvent&>(*event));
    case QEvent::MouseButtonDblClick:
        if (static_cast<const QMouseEvent&>(*event).button() != Qt::LeftButton) return false;
        if (kind_ == MeasureKind::Chain) end();
        return true;
    case QEvent::MouseMove: {
        const auto& move = static_cast<const QMouseEvent&>(*event);
        shift_ = (move.modifiers() & Qt::ShiftModifier) != 0;
        if (move.buttons() == Qt::NoButton) {
            view_.setCursor(Qt::CrossCursor); // a drag takes it away
            look(move.position());
        }
        return false;
    }
    case QEvent::MouseButtonRelease:
        return release(static_cast<const QMouseEvent&>(*event));
    case QEvent::Leave:
        pointer_.reset();
        caught_.reset();
        view_.update();
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

// While a drag turns the model it goes on doing so; a click captures no mouse.
bool MeasureMarks::press(const QMouseEvent& event) {
    if (event.button() != Qt::LeftButton) return false;
    pressed_ = event.position();
    if (view_.input().hand() == Hand::Turns) return false;
    view_.setFocus(Qt::MouseFocusReason);
    return true;
}

bool MeasureMarks::release(const QMouseEvent& event) {
    if (event.button() != Qt::LeftButton || !pressed_) return false;
    const QPointF from = *std::exchange(pressed_, std::nullopt);
    if ((event.position() - from).manhattanLength() < kMinMeasureDrag)
        click(event.position(), (event.modifiers() & Qt::ShiftModifier) != 0);
    return false;
}

bool MeasureMarks::key(const QKeyEvent& event) {
    if ((event.modifiers() & (Qt::ControlModifier | Qt::AltModifier | Qt::MetaModifier)) != 0) return false;
    const bool acts = event.type() == QEvent::KeyPress;
    switch (event.key()) {
    case Qt::Key_Return:
    case Qt::Key_Enter:
        if (acts && !points_.empty()) end();
        return true;
    case Qt::Key_Escape:
        if (!acts) return true;
        if (points_.empty()) {
            emit left();
        } else {
            end();
        }
        return true;
    case Qt::Key_Backspace:
    case Qt::Key_Delete:
        if (!acts || event.isAutoRepeat()) return true;
        if (points_.empty()) {
            if (event.key() == Qt::Key_Delete) emit removalWanted();
        } else {
            points_.pop_back();
            view_.update();
            emit pointsChanged();
        }
        return true;
    default:
        return false;
    }
}

void MeasureMarks::click(const QPointF& at, bool onAxis) {
    const auto there = inServersImage(view_, session_, at);
    if (!there) return;
    if (kind_ == MeasureKind::Area) return emit faceWanted(*there);
    if (kind_ == MeasureKind::Volume) return emit partWanted(*there);
    ++waiting_;
    session_.send(command::measurePoint(there->x(), there->y()), this,
                  [this, onAxis, round = round_](const Answer& answer) {
                      if (round == round_) onClicked(answer.done ? answer.text : QString(), onAxis);
                  });
}

std::size_t MeasureMarks::wantedPoints() const {
    switch (*kind_) {
    case MeasureKind::Chain:
        return rtcore::kMaxChainPoints;
    case MeasureKind::Angle:
        return 3;
    case MeasureKind::Height:
        return 1;
    default:
        return 2;
    }
}

void MeasureMarks::onClicked(const QString& answer, bool onAxis) {
    --waiting_;
    if (const auto caught = readCaught(answer, state_.origin))
        setPoint(caught->point, onAxis);
    else
        emit nothingCaught();
    if (ends_ && waiting_ == 0) end();
}

void MeasureMarks::setPoint(Vec3d point, bool onAxis) {
    point = heldTo(point, onAxis);
    if (points_.empty() || !(points_.back() == point)) points_.push_back(point);
    view_.update();
    emit pointsChanged();
    if (points_.size() >= wantedPoints()) keep();
}

// A chain waits for the point of the last click.
void MeasureMarks::end() {
    ends_ = kind_ == MeasureKind::Chain && waiting_ > 0;
    if (ends_) return;
    if (kind_ == MeasureKind::Chain && points_.size() > 1) return keep();
    forgetPoints();
}

void MeasureMarks::keep() {
    std::vector<command::Position> p;
    for (const Vec3d& point : points_) p.push_back(inFile(point, state_.origin));
    std::string line;
    if (kind_ == MeasureKind::Height)
        line = command::measureKeepHeight(p[0]);
    else if (kind_ == MeasureKind::Angle)
        line = command::measureKeepAngle(p[0], p[1], p[2]);
    else
        line = p.size() == 2 ? command::measureKeepDistance(p[0], p[1]) : command::measureKeepChain(p);
    points_.clear(); // clicks whose points are still asked for begin the next
    ends_ = false;
    view_.update();
    emit pointsChanged();
    emit kept(line);
}

// --- Drawing ---

void MeasureMarks::draw(QPainter& painter) const {
    const auto in = image();
    if (!in) return;
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setClipRect(view_.pictureArea());
    if (shown_ || kind_) drawMeasures(painter, *in);
    if (kind_) drawPending(painter, *in);
    painter.restore();
}

void MeasureMarks::drawLines(QPainter& painter, const SceneImage& in, std::size_t measure) const {
    const std::vector<Vec3d>& points = state_.measures.all[measure].points;
    for (std::size_t i = 1; i < points.size(); ++i) {
        const auto part = leftOf(state_.sections, points[i - 1], points[i], cutSlack(state_));
        const auto line = part ? in.line(part->first, part->second) : std::nullopt;
        if (!line) continue;
        if (isDimmed(measure, i - 1))
            drawDashed(painter, *line);
        else
            drawOnAny(painter, *line, kMeasureColour);
    }
}

// That of the whole comes first.
void MeasureMarks::drawLabels(QPainter& painter, const SceneImage& in, std::size_t measure) const {
    std::size_t leg = 0;
    bool dimmed = isDimmed(measure);
    for (const MeasureLabel& label : labelsOf(state_.measures.all[measure], state_)) {
        if (isLeft(label.point)) drawLabel(painter, in, label, dimmed);
        dimmed = isDimmed(measure, leg++);
    }
}

// No line over a label.
void MeasureMarks::drawMeasures(QPainter& painter, const SceneImage& in) const {
    const std::size_t count = state_.measures.all.size();
    for (std::size_t i = 0; i < count; ++i) drawLines(painter, in, i);
    for (std::size_t i = 0; i < count; ++i) drawLabels(painter, in, i);
}

void MeasureMarks::drawPending(QPainter& painter, const SceneImage& in) const {
    std::vector<Vec3d> points = points_;
    if (caught_) points.push_back(heldTo(caught_->point, shift_));
    for (std::size_t i = 1; i < points.size(); ++i)
        if (const auto line = in.line(points[i - 1], points[i])) drawOnAny(painter, *line, kPendingColour);
    for (const Vec3d& point : points_)
        if (const auto at = in.at(point)) {
            painter.setPen(QPen(kDark, 1));
            painter.setBrush(kPendingColour);
            painter.drawEllipse(*at, 4, 4);
        }
    if (!caught_) return;
    if (const auto at = in.at(points.back())) drawCaught(painter, *at, caught_->kind);
    if (points_.empty() || kind_ == MeasureKind::Angle) return;
    const rtcore::KeptMeasure leg{.points = {points_.back(), points.back()}};
    const rtcore::MeasureValue value = valueOf(leg, state_.measures, metresPerUnitOf(state_));
    drawLabel(painter, in, {labelPoint(leg), measureText(value, state_.measures.unit)});
}

void MeasureMarks::drawLabel(QPainter& painter, const SceneImage& in, const MeasureLabel& label,
                             bool dimmed) const {
    const auto at = in.at(label.point);
    if (!at || !view_.pictureArea().contains(*at)) return;
    constexpr double kPadding = 4, kRound = 4;
    const QSizeF size = painter.fontMetrics().size(Qt::TextSingleLine, label.text);
    QRectF box(QPointF(), size + QSizeF(2 * kPadding, kPadding));
    box.moveCenter(*at + QPointF(0, label.below ? 1.2 * box.height() : 0));
    painter.setPen(Qt::NoPen);
    painter.setBrush(dimmed ? paler(kDark) : kDark);
    painter.drawRoundedRect(box, kRound, kRound);
    painter.setPen(dimmed ? kPaleText : QColor(Qt::white));
    painter.drawText(box, Qt::AlignCenter, label.text);
}

} // namespace gui
