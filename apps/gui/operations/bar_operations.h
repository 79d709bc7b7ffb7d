/// The tool bar below the menus: the most wanted actions as icons. It has none of its own; which buttons are
/// enabled, and what they say, comes from the actions.
#pragma once

#include "gui/operations/gui_context.h"

#include <QObject>

class QToolBar;

namespace gui {

enum class ActionId;

class BarOperations : public QObject {
    Q_OBJECT

  public:
    BarOperations(const GuiContext& context, QObject* parent);

  private:
    void add(ActionId id, const char* symbol);
    void addLight();
    bool eventFilter(QObject* watched, QEvent* event) override;

    GuiContext context_;
    QToolBar* bar_;
};

} // namespace gui
