/// The panel for settings, what all panels have in common, and what takes changes back.
#pragma once

#include "gui/operations/gui_context.h"

#include <QList>
#include <QObject>

class QDockWidget;
class QWidget;

namespace gui {

enum class ActionId;
class FrameView;
class SettingsPanel;

/// Esc leads from the panel back to the image, and so does closing it, in whatever way.
void leadBack(QDockWidget& dock, FrameView& view);

/// A panel at the right of the window, or at its lower edge, hidden at first, shown and hidden by a checkable
/// action, which brings one that is behind another to the front. It leads back.
QDockWidget* addPanel(const GuiContext& context, QWidget* panel, const QString& title, const QString& name,
                      ActionId action, Qt::DockWidgetArea area = Qt::RightDockWidgetArea);

class PanelOperations : public QObject {
    Q_OBJECT

  public:
    PanelOperations(const GuiContext& context, QObject* parent);

  private:
    void addSettings();
    void addAtRest(SettingsPanel& panel);
    void addUndo();
    void showUndo();
    void switchAll();

    GuiContext context_;
    QList<QDockWidget*> hidden_; ///< by switchAll(); those in front last
};

} // namespace gui
