/// Keys and mouse of the picture, handed to the server; what the server's keys do; the wheel's speed.
#pragma once

#include "gui/operations/desk.h"

#include <QObject>

namespace gui {

class MotionOperations : public QObject {
    Q_OBJECT

  public:
    MotionOperations(const Desk& desk, QObject* parent);

  private:
    void changeSpeed(double steps);
    void askForBindings();

    Desk desk_;
    bool live_ = false;
    double steps_ = 0; ///< of the wheel, from the usual speed
};

} // namespace gui
