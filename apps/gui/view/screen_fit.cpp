#include "gui/view/screen_fit.h"

#include <QCoreApplication>
#include <QDialog>
#include <QEvent>
#include <QScreen>
#include <QStyle>

namespace gui {

void fitIntoScreen(QWidget& window) {
    const QRect room = window.screen()->availableGeometry();
    const QSize max = room.size() - QSize(0, window.style()->pixelMetric(QStyle::PM_TitleBarHeight));
    window.resize(window.size().boundedTo(max));
    const bool placed = window.testAttribute(Qt::WA_Moved); // else the desktop finds a place
    if (placed && !room.contains(window.geometry()))
        window.move(qBound(room.left(), window.x(), room.right() + 1 - window.width()),
                    qBound(room.top(), window.y(), room.bottom() + 1 - window.height()));
}

ScreenFit::ScreenFit(QObject* parent) : QObject(parent) {
    QCoreApplication::instance()->installEventFilter(this);
}

bool ScreenFit::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() != QEvent::Polish) return false;
    auto* dialog = qobject_cast<QDialog*>(watched);
    if (dialog != nullptr && dialog->isWindow() && dialog->testAttribute(Qt::WA_Resized))
        fitIntoScreen(*dialog);
    return false;
}

} // namespace gui
