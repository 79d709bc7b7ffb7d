/// Orbit, walk and fly: which of them it is, and the cube that shows it and the direction of the view.
#pragma once

#include "gui/operations/gui_context.h"
#include "gui/view/view_cube.h"

#include <QObject>

namespace gui {

class ModeOperations : public QObject {
    Q_OBJECT

  public:
    ModeOperations(const GuiContext& context, QObject* parent);

  private:
    void choose(Mode mode);
    void showMode();
    void showCube();
    void setOrbits(bool orbits);

    GuiContext context_;
    ViewCube* cube_;
    bool walks_ = false; ///< at the last frame
};

} // namespace gui
