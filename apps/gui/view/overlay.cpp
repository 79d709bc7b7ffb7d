#include "gui/view/overlay.h"

#include "gui/models/translated.h"

#include <QFontMetrics>
#include <QLocale>
#include <QPainter>

namespace gui {

namespace {

constexpr int kMargin = 10, kPadding = 7;
constexpr double kRadius = 6;

QString activity(const ServerStatus& status, bool refining) {
    if (status.paused) return tr("paused");
    if (status.idle) return tr("complete");
    return refining ? tr("sharpening") : tr("drawing");
}

void drawBox(QPainter& painter, const QRect& box) {
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(Qt::NoPen);
    painter.setBrush(QColor(0, 0, 0, 140));
    painter.drawRoundedRect(box, kRadius, kRadius);
    painter.setPen(QColor(255, 255, 255, 230));
}

} // namespace

QString overlayText(const ServerStatus& status, const QSize& frame, bool still, const QString& rendering,
                    const QString& sharing, bool orbits) {
    if (status.resolution.isEmpty()) return {};
    QString size = QStringLiteral("%1 × %2").arg(status.resolution.width()).arg(status.resolution.height());
    constexpr int kPercent = 100;
    const int fraction = kPercent * frame.width() / status.resolution.width();
    const bool coarse = fraction > 0 && fraction < kPercent;
    if (coarse) size += tr(" (%1 %)").arg(fraction);
    const QString mode = orbits ? tr("Orbit") : status.view.walking ? tr("Walk") : tr("Fly");
    QStringList parts{size, mode};
    const bool complete = status.idle && !status.paused;
    if (!complete || rendering.isEmpty()) parts.append(activity(status, coarse && still));
    const bool counts = !status.idle && !status.paused && status.framesPerSecond >= 1;
    if (counts) parts.prepend(tr("%1 fps").arg(QLocale().toString(status.framesPerSecond, 'f', 0)));
    if (!status.idle && status.indirectError > 0)
        parts.append(
            tr("indirect light ±%1 %").arg(QLocale().toString(kPercent * status.indirectError, 'f', 0)));
    if (status.recording) parts.append(tr("● recording"));
    if (!sharing.isEmpty()) parts.append(sharing);
    if (!rendering.isEmpty()) parts.append(rendering);
    return parts.join(QStringLiteral("  ·  "));
}

QString stateText(const Session& session) {
    switch (session.state()) {
    case SessionState::Disconnected:
        return {}; // the start page says it
    case SessionState::Connecting:
        return tr("Waiting for the server “%1”…").arg(session.instance());
    case SessionState::Busy:
        return tr("The server is busy…");
    case SessionState::Lost:
        return tr("The server has ended.");
    case SessionState::Refused:
        return session.reason();
    case SessionState::Connected:
        break;
    }
    if (session.status().progress < 1) {
        constexpr double kHundred = 100;
        return tr("Loading… %1 %").arg(QLocale().toString(session.status().progress * kHundred, 'f', 0));
    }
    return session.frame().isNull() ? tr("Rendering first frame…") : QString();
}

int overlayHeight(const QFontMetrics& metrics) { return 2 * kMargin + kPadding + metrics.height(); }

void drawOverlay(QPainter& painter, const QRect& area, const QString& text) {
    if (text.isEmpty()) return;
    const QFontMetrics metrics(painter.font());
    const QRect words = metrics.boundingRect(text);
    const QRect box(area.left() + kMargin, area.top() + kMargin, words.width() + 2 * kPadding,
                    metrics.height() + kPadding);
    drawBox(painter, box);
    painter.drawText(box, Qt::AlignCenter, text);
}

void drawWords(QPainter& painter, const QRect& area, const QString& text) {
    if (text.isEmpty()) return;
    constexpr int kFlags = Qt::AlignCenter | Qt::TextWordWrap;
    const QRect room = area.adjusted(4 * kMargin, kMargin, -4 * kMargin, -kMargin);
    const QRect words = painter.boundingRect(room, kFlags, text);
    drawBox(painter, words.adjusted(-2 * kPadding, -kPadding, 2 * kPadding, kPadding));
    painter.drawText(words, kFlags, text);
}

} // namespace gui
