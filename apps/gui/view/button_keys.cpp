#include "gui/view/button_keys.h"

#include <QCoreApplication>
#include <QDialog>
#include <QKeyEvent>
#include <QPushButton>
#include <QToolButton>

namespace gui {

ButtonKeys::ButtonKeys(QObject* parent) : QObject(parent) {
    QCoreApplication::instance()->installEventFilter(this);
}

bool ButtonKeys::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() != QEvent::KeyPress) return false;
    const bool is =
        qobject_cast<QPushButton*>(watched) != nullptr || qobject_cast<QToolButton*>(watched) != nullptr;
    if (!is) return false;
    auto* button = static_cast<QAbstractButton*>(watched);
    const auto& key = static_cast<const QKeyEvent&>(*event);
    const bool enters = key.key() == Qt::Key_Return || key.key() == Qt::Key_Enter;
    // Dialogs have a button of their own for it.
    if (!enters || (key.modifiers() & ~Qt::KeypadModifier) != 0 ||
        qobject_cast<QDialog*>(button->window()) != nullptr)
        return false;
    if (!key.isAutoRepeat()) button->click();
    return true;
}

} // namespace gui
