#include "gui/view/view_cube.h"

#include "gui/view/frame_view.h"

#include "rtcore/scene/up_axis.h"

#include <QButtonGroup>
#include <QEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QPolygonF>
#include <QToolButton>
#include <QTransform>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>

namespace gui {

namespace {

constexpr int kSize = 96, kMargin = 10; ///< widget pixels
constexpr double kScale = 27;           ///< of half a side of the cube
constexpr double kCorner = 8;           ///< around the one that is nearest to the viewer
constexpr float kGrazing = 0.05F;       ///< sides that are seen flatter show nothing
constexpr auto kCornerView = "three-quarter";

QVector3D vectorOf(const rtcore::Vec3& v) { return {v.x, v.y, v.z}; }

/// The label on a side.
QString labelOf(const QString& side) {
    static const std::array<std::pair<const char*, const char*>, 6> kLabels{
        {{"front", QT_TRANSLATE_NOOP("gui::ViewCube", "FRONT")},
         {"back", QT_TRANSLATE_NOOP("gui::ViewCube", "BACK")},
         {"left", QT_TRANSLATE_NOOP("gui::ViewCube", "LEFT")},
         {"right", QT_TRANSLATE_NOOP("gui::ViewCube", "RIGHT")},
         {"top", QT_TRANSLATE_NOOP("gui::ViewCube", "TOP")},
         {"bottom", QT_TRANSLATE_NOOP("gui::ViewCube", "BELOW")}}};
    for (const auto& [name, label] : kLabels)
        if (side == QLatin1String(name)) return ViewCube::tr(label);
    return {};
}

} // namespace

ViewCube::ViewCube(FrameView& view) : QWidget(&view), view_(view), modes_(new QButtonGroup(this)) {
    setMouseTracking(true);
    setCursor(Qt::ArrowCursor);
    setAccessibleName(tr("View cube"));
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, kSize, 0, 0);
    column->setSpacing(2);
    const std::array<std::pair<Mode, QString>, 3> all{
        {{Mode::Orbit, tr("Orbit")}, {Mode::Walk, tr("Walk")}, {Mode::Fly, tr("Fly")}}};
    for (const auto& [mode, text] : all) {
        auto* button = new QToolButton;
        button->setText(text);
        button->setCheckable(true);
        button->setFocusPolicy(Qt::NoFocus); // the keys stay the camera's
        button->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
        button->setStyleSheet(QStringLiteral(
            "QToolButton { color: rgba(255,255,255,230); background: rgba(0,0,0,140); border: none;"
            " border-radius: 5px; padding: 3px; }"
            "QToolButton:hover { background: rgba(60,60,60,200); }"
            "QToolButton:checked { background: rgba(48,110,190,220); }"));
        modes_->addButton(button, static_cast<int>(mode));
        column->addWidget(button);
    }
    connect(modes_, &QButtonGroup::idClicked, this, [this](int id) {
        const auto wanted = static_cast<Mode>(id);
        setMode(mode_); // the server, or the hand, says when it is so
        emit modeChosen(wanted);
    });
    view.installEventFilter(this);
    setFixedWidth(kSize);
    adjustSize();
    place();
}

void ViewCube::setMode(Mode mode) {
    mode_ = mode;
    if (QAbstractButton* button = modes_->button(static_cast<int>(mode))) button->setChecked(true);
}

void ViewCube::setUp(const QVector3D& up) {
    if (up == up_) return;
    up_ = up;
    update();
}

void ViewCube::setView(const View& view) {
    const QVector3D towards = -view.forward.normalized();
    const QVector3D right = QVector3D::crossProduct(view.up, towards).normalized();
    if (right.isNull() || (towards == towards_ && right == right_)) return;
    towards_ = towards;
    right_ = right;
    above_ = QVector3D::crossProduct(towards, right);
    update();
}

std::array<ViewCube::Side, 6> ViewCube::sides() const {
    const rtcore::Vec3 upwards{up_.x(), up_.y(), up_.z()};
    const QVector3D right = vectorOf(rtcore::rightOf(upwards)), front = vectorOf(rtcore::frontOf(upwards));
    return {{{"front", front, right, up_},
             {"back", -front, -right, up_},
             {"left", -right, front, up_},
             {"right", right, -front, up_},
             {"top", up_, right, -front},
             {"bottom", -up_, right, front}}};
}

QPointF ViewCube::projected(const QVector3D& point) const {
    const double x = static_cast<double>(QVector3D::dotProduct(point, right_)),
                 y = static_cast<double>(QVector3D::dotProduct(point, above_));
    return {kSize / 2.0 + kScale * x, kSize / 2.0 - kScale * y};
}

/// From the upper left on, clockwise.
std::array<QPointF, 4> ViewCube::cornersOf(const Side& side) const {
    return {projected(side.normal - side.right + side.up), projected(side.normal + side.right + side.up),
            projected(side.normal + side.right - side.up), projected(side.normal - side.right - side.up)};
}

bool ViewCube::isSeen(const Side& side) const {
    return QVector3D::dotProduct(side.normal, towards_) > kGrazing;
}

QString ViewCube::sideAt(const QPointF& position) const {
    const std::array<Side, 6> all = sides();
    const QVector3D corner = all[0].normal + all[3].normal + all[4].normal; // front, right, top
    if (QVector3D::dotProduct(corner, towards_) > 0 &&
        QLineF(projected(corner), position).length() <= kCorner)
        return QLatin1String(kCornerView);
    for (const Side& side : all) {
        const std::array<QPointF, 4> corners = cornersOf(side);
        if (isSeen(side) && QPolygonF(QList<QPointF>(corners.begin(), corners.end()))
                                .containsPoint(position, Qt::OddEvenFill))
            return QLatin1String(side.name);
    }
    return {};
}

std::optional<QPointF> ViewCube::middleOf(const QString& side) const {
    for (const Side& each : sides())
        if (side == QLatin1String(each.name) && isSeen(each)) return projected(each.normal);
    return std::nullopt;
}

void ViewCube::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    QFont font = painter.font();
    font.setPixelSize(11);
    font.setBold(true);
    for (const Side& side : sides()) {
        if (!isSeen(side)) continue;
        const std::array<QPointF, 4> corners = cornersOf(side);
        const QPolygonF outline(QList<QPointF>(corners.begin(), corners.end()));
        const float lit = 0.75F + 0.25F * QVector3D::dotProduct(side.normal, towards_);
        const bool hovered = hovered_ == QLatin1String(side.name);
        const auto level = static_cast<int>(235 * lit);
        painter.setPen(QPen(QColor(40, 44, 50, 220), 1.2));
        painter.setBrush(hovered ? QColor(120, 180, 250, 235) : QColor(level, level, level, 215));
        painter.drawPolygon(outline);
        // The label lies on the side.
        constexpr double kLabel = 64;
        const QPolygonF square(QList<QPointF>{{0, 0}, {kLabel, 0}, {kLabel, kLabel}, {0, kLabel}});
        QTransform onSide;
        if (!QTransform::quadToQuad(square, outline, onSide)) continue;
        painter.save();
        painter.setTransform(onSide, true);
        painter.setFont(font);
        painter.setPen(QColor(30, 34, 40));
        painter.drawText(QRectF(0, 0, kLabel, kLabel), Qt::AlignCenter, labelOf(QLatin1String(side.name)));
        painter.restore();
    }
    if (hovered_ == QLatin1String(kCornerView)) {
        const std::array<Side, 6> all = sides();
        painter.setPen(Qt::NoPen);
        painter.setBrush(QColor(48, 110, 190, 235));
        painter.drawEllipse(projected(all[0].normal + all[3].normal + all[4].normal), kCorner / 2,
                            kCorner / 2);
    }
}

// A press beside the cube goes on to the image, where a drag turns the model.
void ViewCube::mousePressEvent(QMouseEvent* event) {
    pressed_ = event->button() == Qt::LeftButton ? sideAt(event->position()) : QString();
    event->setAccepted(!pressed_.isEmpty());
}

void ViewCube::mouseReleaseEvent(QMouseEvent* event) {
    const QString side = sideAt(event->position());
    if (event->button() == Qt::LeftButton && !side.isEmpty() && side == pressed_) emit sideChosen(side);
    pressed_.clear();
}

void ViewCube::mouseMoveEvent(QMouseEvent* event) {
    const QString side = sideAt(event->position());
    if (side != hovered_) {
        hovered_ = side;
        update();
    }
    event->ignore();
}

void ViewCube::leaveEvent(QEvent*) {
    hovered_.clear();
    update();
}

bool ViewCube::eventFilter(QObject* watched, QEvent* event) {
    if (watched == &view_ && event->type() == QEvent::Resize) place();
    return false;
}

void ViewCube::place() { move(view_.width() - width() - kMargin, kMargin); }

} // namespace gui
