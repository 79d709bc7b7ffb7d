/// Drawings to scale.
#pragma once

#include "gui/operations/gui_context.h"

#include <QObject>

namespace gui {

class PlanDialog;
struct PlanWish;

class PlanOperations : public QObject {
    Q_OBJECT

  public:
    PlanOperations(const GuiContext& context, QObject* parent);

  private:
    void ask();
    void draw(const PlanWish& plan);

    GuiContext context_;
};

} // namespace gui
