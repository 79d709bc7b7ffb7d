/// The panels for settings and lights, and what takes changes back.
#pragma once

#include "gui/operations/desk.h"

#include <QObject>

class QDockWidget;
class QWidget;

namespace gui {

enum class ActionId;

/// A panel at the right of the window, hidden at first, shown and hidden by a checkable action; Esc leads
/// from it back to the picture.
QDockWidget* addPanel(const Desk& desk, QWidget* panel, const QString& title, const QString& name,
                      ActionId action);

class PanelOperations : public QObject {
    Q_OBJECT

  public:
    PanelOperations(const Desk& desk, QObject* parent);

  private:
    void addSettings();
    void addLights();
    void addUndo();
    void showUndo();

    Desk desk_;
};

} // namespace gui
