/// Drawings to scale.
#pragma once

#include "gui/operations/gui_context.h"

#include <QObject>

namespace gui {

class PlanDialog;
struct PlanWish;
struct RenderWish;

class PlanOperations : public QObject {
    Q_OBJECT

  public:
    PlanOperations(const GuiContext& context, QObject* parent);

  signals:
    /// The Renderer is to add light to the image.
    void lightWanted(const gui::RenderWish& wish);

  private:
    void ask();
    void draw(const PlanWish& plan);
    void onDrawn(const PlanWish& plan, const QString& file);

    GuiContext context_;
};

} // namespace gui
