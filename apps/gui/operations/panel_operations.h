/// The panel for settings, and what takes changes back.
#pragma once

#include "gui/operations/gui_context.h"

#include <QObject>

class QDockWidget;
class QWidget;

namespace gui {

enum class ActionId;

/// A panel at the right of the window, hidden at first, shown and hidden by a checkable action, which brings
/// one that is behind another to the front; Esc leads from it back to the image.
QDockWidget* addPanel(const GuiContext& context, QWidget* panel, const QString& title, const QString& name,
                      ActionId action);

class PanelOperations : public QObject {
    Q_OBJECT

  public:
    PanelOperations(const GuiContext& context, QObject* parent);

  private:
    void addSettings();
    void addUndo();
    void showUndo();

    GuiContext context_;
};

} // namespace gui
