/// Better pictures than the live ones: quick render, and where progressive rendering belongs.
#pragma once

#include "gui/operations/desk.h"
#include "gui/processes/still_process.h"

#include <QObject>

namespace gui {

class RenderOperations : public QObject {
    Q_OBJECT

  public:
    RenderOperations(const Desk& desk, QObject* parent);

  private:
    void quickRender(int antialiasing);
    /// The picture is out of date: back to the live frames.
    void interrupt();

    Desk desk_;
    StillProcess still_;
    View shown_; ///< the view of the still
};

} // namespace gui
