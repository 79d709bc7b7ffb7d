#include "gui/view/recording_mark.h"

#include "gui/view/frame_view.h"
#include "gui/view/overlay.h"

#include <QEvent>
#include <QPainter>

#include <chrono>

namespace gui {

namespace {

using namespace std::chrono_literals;

constexpr int kPadding = 7, kDot = 12; ///< widget pixels
constexpr auto kTick = 200ms;
const QColor kRed(224, 49, 49);

QString timeText(qint64 seconds) {
    constexpr qint64 kMinute = 60, kHour = 3600;
    const QString rest = QStringLiteral(":%1").arg(seconds % kMinute, 2, 10, QLatin1Char('0'));
    const qint64 minutes = seconds / kMinute % kMinute;
    if (seconds < kHour) return QString::number(minutes) + rest;
    return QStringLiteral("%1:%2").arg(seconds / kHour).arg(minutes, 2, 10, QLatin1Char('0')) + rest;
}

} // namespace

RecordingMark::RecordingMark(FrameView& view) : QWidget(&view) {
    setAttribute(Qt::WA_TransparentForMouseEvents);
    setFocusPolicy(Qt::NoFocus);
    hide();
    view.installEventFilter(this);
    timer_.setInterval(kTick);
    connect(&timer_, &QTimer::timeout, this, &RecordingMark::fit);
}

void RecordingMark::start(double seconds) {
    before_ = seconds;
    clock_.start();
    timer_.start();
    fit();
    show();
    raise();
}

void RecordingMark::stop() {
    timer_.stop();
    clock_.invalidate();
    hide();
}

QString RecordingMark::time() const {
    constexpr double kMilliseconds = 1000;
    const double now = clock_.isValid() ? static_cast<double>(clock_.elapsed()) / kMilliseconds : 0;
    return timeText(static_cast<qint64>(before_ + now));
}

bool RecordingMark::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::Resize && !isHidden()) fit();
    return QWidget::eventFilter(watched, event);
}

void RecordingMark::fit() {
    const int wide = kDot + 3 * kPadding + fontMetrics().horizontalAdvance(time());
    setGeometry((parentWidget()->width() - wide) / 2, overlayHeight(fontMetrics()), wide,
                fontMetrics().height() + kPadding);
    setAccessibleName(tr("Recording, %1").arg(time()));
    update();
}

void RecordingMark::paintEvent(QPaintEvent* /*event*/) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(Qt::NoPen);
    painter.setBrush(QColor(0, 0, 0, 170));
    painter.drawRoundedRect(rect(), kPadding, kPadding);
    painter.setBrush(kRed);
    painter.drawEllipse(QRectF(kPadding, (height() - kDot) / 2.0, kDot, kDot));
    painter.setPen(Qt::white);
    painter.drawText(rect().adjusted(kDot + 2 * kPadding, 0, -kPadding, 0), Qt::AlignVCenter | Qt::AlignLeft,
                     time());
}

} // namespace gui
