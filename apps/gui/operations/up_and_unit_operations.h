/// The model's up axis and unit, which the user may know better than the server's guess.
#pragma once

#include "gui/operations/gui_context.h"

#include <QObject>

namespace gui {

class UpAndUnitOperations : public QObject {
    Q_OBJECT

  public:
    UpAndUnitOperations(const GuiContext& context, QObject* parent);

  private:
    void ask();

    GuiContext context_;
};

} // namespace gui
