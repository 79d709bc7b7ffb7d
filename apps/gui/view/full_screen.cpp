#include "gui/view/full_screen.h"

#include <QDockWidget>
#include <QEvent>
#include <QMainWindow>
#include <QMenuBar>
#include <QToolBar>

namespace gui {

FullScreen::FullScreen(QMainWindow& window) : QObject(&window), window_(window) {
    window.installEventFilter(this);
}

void FullScreen::set(bool on) {
    window_.setWindowState(on ? window_.windowState() | Qt::WindowFullScreen
                              : window_.windowState() & ~Qt::WindowFullScreen);
}

bool FullScreen::eventFilter(QObject*, QEvent* event) {
    if (event->type() != QEvent::WindowStateChange || window_.isFullScreen() == on_) return false;
    on_ ? leave() : enter();
    emit changed(on_);
    return false;
}

void FullScreen::enter() {
    panels_ = window_.saveState();
    on_ = true;
    window_.menuBar()->hide();
    for (QToolBar* bar : window_.findChildren<QToolBar*>()) bar->hide();
    for (QDockWidget* panel : window_.findChildren<QDockWidget*>()) panel->hide();
}

void FullScreen::leave() {
    on_ = false;
    window_.menuBar()->show();
    window_.restoreState(panels_);
}

} // namespace gui
