#include "gui/operations/light_meter_operations.h"

#include "gui/operations/actions.h"
#include "gui/session/session.h"
#include "gui/view/frame_view.h"
#include "gui/view/input_capture.h"
#include "gui/view/plain_widgets.h"
#include "gui/view/shown_image.h"

#include <QMouseEvent>

#include <algorithm>
#include <chrono>
#include <utility>

namespace gui {

namespace {

constexpr auto kRest = std::chrono::milliseconds(200);
constexpr auto kBetweenGlances = std::chrono::milliseconds(400); // each takes the server some 120 ms
constexpr int kAside = 16;                                       // pixels from the pointer

} // namespace

LightMeterOperations::LightMeterOperations(const GuiContext& context, QObject* parent)
    : QObject(parent), context_(context),
      meter_([this](const std::string& line, std::function<void(const Answer&)> done) {
          context_.session.send(line, this, std::move(done));
      }),
      label_(new PlainLabel({}, &context.view)) {
    label_->setObjectName(QStringLiteral("lightMeter"));
    label_->setAttribute(Qt::WA_TransparentForMouseEvents);
    label_->setStyleSheet(QStringLiteral("background: rgba(0, 0, 0, 170); color: white; padding: 5px;"
                                         "border-radius: 6px;"));
    label_->hide();
    rest_.setSingleShot(true);
    rest_.setInterval(kRest);
    glances_.setSingleShot(true);
    glances_.setInterval(kBetweenGlances);
    connect(&rest_, &QTimer::timeout, this, &LightMeterOperations::measure);
    connect(&meter_, &LightMeter::changed, this, &LightMeterOperations::show);
    connect(&context_.session, &Session::statusChanged, this, &LightMeterOperations::noticeStatus);
    connect(&context_.session, &Session::stateChanged, this, &LightMeterOperations::restart);
    context_.view.installEventFilter(this);
    context_.actions.onToggle(ActionId::LightMeter, [this](bool on) { setOn(on); });
}

bool LightMeterOperations::eventFilter(QObject* /*watched*/, QEvent* event) {
    if (!on_) return false;
    if (event->type() == QEvent::MouseMove) {
        // A captured mouse turns the camera: what is in the middle is measured.
        const auto& moved = static_cast<const QMouseEvent&>(*event);
        const QPointF middle = QRectF(context_.view.rect()).center();
        const QPointF at = context_.view.input().captured() ? middle : moved.position();
        // A drag moves the view, too.
        if (moved.buttons() != Qt::NoButton && position_)
            position_ = at;
        else
            pointAt(at);
    }
    if (event->type() == QEvent::Leave) pointAt(std::nullopt);
    return false;
}

void LightMeterOperations::setOn(bool on) {
    on_ = on;
    position_.reset();
    if (on && context_.view.underMouse()) position_ = context_.view.mapFromGlobal(QCursor::pos());
    restart();
}

void LightMeterOperations::pointAt(const std::optional<QPointF>& position) {
    if (position == position_) return;
    position_ = position;
    restart();
}

void LightMeterOperations::noticeStatus() {
    const ServerStatus& status = context_.session.status();
    if (!on_) return;
    if (status.imageRevision != revision_ || status.resolution != size_) return restart();
    if (status.view != view_) goOn();
}

/// The view moves.
void LightMeterOperations::goOn() {
    view_ = context_.session.status().view;
    if (!position_) return;
    rest_.start();
    if (glances_.isActive()) return;
    glances_.start();
    if (const auto point = pointOfImage())
        meter_.glance(*point);
    else
        meter_.forget();
}

void LightMeterOperations::restart() {
    view_ = context_.session.status().view;
    revision_ = context_.session.status().imageRevision;
    size_ = context_.session.status().resolution;
    meter_.forget();
    rest_.stop();
    if (on_ && position_ && context_.session.live()) rest_.start();
    show();
}

/// 0..1 from the left and from the top.
std::optional<QPointF> LightMeterOperations::pointOfImage() const {
    return position_ ? inServersImage(context_.view, context_.session, *position_) : std::nullopt;
}

void LightMeterOperations::measure() {
    if (const auto point = pointOfImage()) meter_.measure(*point);
}

void LightMeterOperations::show() {
    const QString text = on_ && position_ ? lightText(meter_.reading()) : QString();
    label_->setVisible(!text.isEmpty());
    if (text.isEmpty()) return;
    label_->setText(text);
    label_->adjustSize();
    const QSize room = context_.view.size() - label_->size();
    const QPoint beside = position_->toPoint() + QPoint(kAside, kAside);
    const auto fitting = [](int wanted, int pointer, int size, int max) {
        return wanted <= max ? wanted : std::max(0, pointer - kAside - size);
    };
    label_->move(fitting(beside.x(), beside.x() - kAside, label_->width(), room.width()),
                 fitting(beside.y(), beside.y() - kAside, label_->height(), room.height()));
    label_->raise();
}

} // namespace gui
