#include "gui/view/corner_plan.h"

#include "gui/models/plain_text.h"
#include "gui/view/frame_view.h"
#include "gui/view/plain_widgets.h"

#include <QEvent>
#include <QGuiApplication>
#include <QHBoxLayout>
#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>
#include <QStyleHints>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>

namespace gui {

namespace {

constexpr int kAround = 10, kInside = 8;   ///< widget pixels: around, and inside
constexpr int kMaxWide = 380, kCube = 210; ///< the latter high, with what is around
constexpr double kWedge = 46;              ///< of the field of view
constexpr int kPaper = 212, kHeavy = 235, kFilled = 120, kLight = 105; ///< of 255: opaque

QColor with(QColor colour, int alpha) {
    colour.setAlpha(alpha);
    return colour;
}

QPainterPath pathOf(const std::vector<app::ToldOutline::Line>& lines, const QTransform& transform) {
    QPainterPath path; // odd-even
    for (const app::ToldOutline::Line& line : lines) {
        for (std::size_t i = 0; i < line.size(); ++i) {
            const QPointF point = transform.map(QPointF(line[i][0], line[i][1]));
            i == 0 ? path.moveTo(point) : path.lineTo(point);
        }
        if (line.front() == line.back()) path.closeSubpath();
    }
    return path;
}

QToolButton* arrow(Qt::ArrowType type, const QString& name) {
    auto* button = new QToolButton;
    button->setArrowType(type);
    button->setAutoRaise(true);
    button->setFocusPolicy(Qt::NoFocus); // the keys stay the camera's
    button->setAccessibleName(name);
    button->setToolTip(plainTip(name));
    return button;
}

} // namespace

CornerPlan::CornerPlan(FrameView& view)
    : QWidget(&view), view_(view), title_(new PlainLabel),
      below_(arrow(Qt::DownArrow, tr("Show the storey below"))),
      above_(arrow(Qt::UpArrow, tr("Show the storey above"))) {
    setObjectName(QStringLiteral("cornerPlan"));
    setAccessibleName(tr("Plan in the corner"));
    setToolTip(plainTip(tr("A click goes there, a drag looks there")));
    auto* row = new QHBoxLayout;
    row->setSpacing(2);
    title_->setMinimumWidth(1);
    row->addWidget(title_, 1);
    row->addWidget(below_);
    row->addWidget(above_);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(kInside, kInside / 2, kInside / 2, kInside);
    column->addLayout(row);
    column->addStretch(1);
    connect(below_, &QToolButton::clicked, this, [this] { emit storeyWanted(outline_.storey - 1); });
    connect(above_, &QToolButton::clicked, this, [this] { emit storeyWanted(outline_.storey + 1); });
    view.installEventFilter(this);
    setCursor(Qt::ArrowCursor);
    showStoreys();
    layOut();
}

void CornerPlan::setOutline(const app::ToldOutline& outline) {
    outline_ = outline;
    known_ = true;
    message_ = outline.size[0] + outline.size[1] > 0 ? QString() : tr("Nothing is cut there.");
    showStoreys();
    layOut();
}

void CornerPlan::setMessage(const QString& text) {
    pressed_.reset();
    known_ = false;
    outline_ = {};
    message_ = text;
    showStoreys();
    layOut();
}

void CornerPlan::setView(const View& view, int storey) {
    if (view == camera_ && storey == storey_) return;
    camera_ = view;
    storey_ = storey;
    update();
}

QString CornerPlan::title() const { return title_->text(); }

void CornerPlan::showStoreys() {
    const int count = static_cast<int>(outline_.floors.size());
    title_->setText(!known_     ? QString()
                    : count > 0 ? tr("Storey %1 of %2").arg(outline_.storey).arg(count)
                                : tr("No storeys: contour lines"));
    for (QToolButton* button : {below_, above_}) button->setVisible(known_ && count > 1);
    below_->setEnabled(outline_.storey > 1);
    above_->setEnabled(outline_.storey < count);
}

QRectF CornerPlan::planArea() const {
    const int top = std::max(title_->sizeHint().height(), above_->sizeHint().height()) + kInside;
    return known_ && message_.isEmpty() ? QRectF(rect().adjusted(kInside, top, -kInside, -kInside))
                                        : QRectF();
}

// As wide as it may be; as high as the plan needs, up to a half of the image, and below the cube.
void CornerPlan::layOut() {
    const int wide = std::min(view_.width() / 4, kMaxWide);
    const int head = std::max(title_->sizeHint().height(), above_->sizeHint().height()) + 2 * kInside;
    const int highest = std::min(view_.height() / 2, std::max(view_.height() - kCube, view_.height() / 4));
    const QSizeF room(std::max(wide - 2 * kInside, 1), std::max(highest - head, 1));
    const bool plan = known_ && message_.isEmpty();
    const double high = plan ? std::max(planSize(outline_, room).height(), room.width() / 4)
                             : 3.0 * fontMetrics().lineSpacing();
    resize(std::max(wide, 1), head + static_cast<int>(std::ceil(high)));
    move(view_.width() - width() - kAround, view_.height() - height() - kAround);
    lines_ = {};
    update();
}

QPixmap CornerPlan::paintedLines() const {
    const double ratio = devicePixelRatioF();
    QPixmap pixmap((QSizeF(size()) * ratio).toSize());
    pixmap.setDevicePixelRatio(ratio);
    pixmap.fill(Qt::transparent);
    QPainter painter(&pixmap);
    painter.setRenderHint(QPainter::Antialiasing);
    const QColor ink = palette().color(QPalette::WindowText);
    painter.setPen(Qt::NoPen);
    painter.setBrush(with(palette().color(QPalette::Window), kPaper));
    painter.drawRoundedRect(rect(), 6, 6);
    if (planArea().isEmpty()) return pixmap;
    const QTransform transform = fit().transform();
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(with(ink, kLight), 1));
    painter.drawPath(pathOf(outline_.light, transform));
    const QPainterPath solids = pathOf(outline_.solids, transform);
    painter.fillPath(solids, with(ink, kFilled));
    painter.setPen(QPen(with(ink, kHeavy), 1.6, Qt::SolidLine, Qt::FlatCap, Qt::MiterJoin));
    painter.drawPath(solids);
    painter.drawPath(pathOf(outline_.lines, transform));
    return pixmap;
}

std::optional<QPointF> CornerPlan::mark() const {
    const QRectF area = planArea();
    if (area.isEmpty() || !camera_.known()) return std::nullopt;
    const QPointF at = fit().at(positionOf(camera_.eye, camera_));
    return QPointF(std::clamp(at.x(), area.left(), area.right()),
                   std::clamp(at.y(), area.top(), area.bottom()));
}

// Hollow where it is not on this storey.
void CornerPlan::drawCamera(QPainter& painter) const {
    const std::optional<QPointF> at = mark();
    if (!at) return;
    const QColor colour =
        palette().color(QPalette::Window).lightness() > 127 ? QColor(200, 60, 0) : QColor(255, 160, 60);
    QLineF ahead = fit().directionOf(camera_);
    ahead.translate(*at - ahead.p1());
    if (ahead.length() > 0 && camera_.fieldOfView > 0) {
        const double angle = std::min(double{camera_.fieldOfView}, 360.0);
        QPainterPath wedge(*at);
        const QRectF circle(*at - QPointF(kWedge, kWedge), QSizeF(2 * kWedge, 2 * kWedge));
        wedge.arcTo(circle, ahead.angle() - angle / 2, angle);
        wedge.closeSubpath();
        QRadialGradient fading(*at, kWedge);
        fading.setColorAt(0, with(colour, 190));
        fading.setColorAt(1, with(colour, 25));
        painter.fillPath(wedge, fading);
    } else if (ahead.length() > 0) {
        ahead.setLength(kWedge / 2);
        painter.setPen(QPen(colour, 2));
        painter.drawLine(ahead);
    }
    const bool here = outline_.storey == storey_;
    painter.setPen(QPen(here ? palette().color(QPalette::Window) : colour, 1.6));
    painter.setBrush(here ? QBrush(colour) : QBrush(palette().color(QPalette::Window)));
    painter.drawEllipse(*at, 4.5, 4.5);
}

void CornerPlan::paintEvent(QPaintEvent*) {
    if (lines_.isNull() || lines_.devicePixelRatio() != devicePixelRatioF()) lines_ = paintedLines();
    QPainter painter(this);
    painter.drawPixmap(0, 0, lines_);
    painter.setRenderHint(QPainter::Antialiasing);
    if (!message_.isEmpty()) {
        painter.setPen(palette().color(QPalette::WindowText));
        painter.drawText(
            rect().adjusted(kInside, kInside + (known_ ? title_->height() : 0), -kInside, -kInside),
            static_cast<int>(Qt::AlignCenter) | static_cast<int>(Qt::TextWordWrap), message_);
    }
    painter.setClipRect(planArea().adjusted(-kInside, -kInside, kInside, kInside));
    drawCamera(painter);
}

void CornerPlan::changeEvent(QEvent* event) {
    if (event->type() == QEvent::PaletteChange || event->type() == QEvent::FontChange ||
        event->type() == QEvent::StyleChange)
        layOut();
    QWidget::changeEvent(event);
}

void CornerPlan::mousePressEvent(QMouseEvent* event) {
    drags_ = false;
    pressed_.reset();
    if (event->button() == Qt::LeftButton && planArea().contains(event->position()))
        pressed_ = event->position();
}

void CornerPlan::mouseMoveEvent(QMouseEvent* event) {
    if (!pressed_ || !camera_.known()) return;
    const double from = QLineF(*pressed_, event->position()).length();
    if (!drags_ && from < QGuiApplication::styleHints()->startDragDistance()) return;
    emit lookWanted(fit().turnedTo(event->position(), camera_), drags_);
    drags_ = true;
}

void CornerPlan::mouseReleaseEvent(QMouseEvent* event) {
    const bool clicked = pressed_ && !drags_ && event->button() == Qt::LeftButton;
    pressed_.reset();
    if (clicked && camera_.known())
        emit goWanted(fit().eyeAt(event->position(), heightOf(positionOf(camera_.eye, camera_), outline_)));
}

bool CornerPlan::eventFilter(QObject* watched, QEvent* event) {
    if (watched == &view_ && event->type() == QEvent::Resize) layOut();
    return false;
}

} // namespace gui
