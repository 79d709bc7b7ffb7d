/// Keys and mouse of the image, handed to the server; what the server's keys do; the wheel's speed.
#pragma once

#include "gui/operations/gui_context.h"

#include <QObject>
#include <QPointF>

namespace gui {

class MotionOperations : public QObject {
    Q_OBJECT

  public:
    MotionOperations(const GuiContext& context, QObject* parent);

  private:
    void changeSpeed(double steps);
    void bindOrbit();
    void takeHold(const QPointF& position);
    void askForBindings();

    GuiContext context_;
    bool live_ = false;
    double steps_ = 0; ///< of the wheel, from the usual speed
};

} // namespace gui
