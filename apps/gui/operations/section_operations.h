/// Sections of the model, by their panel.
#pragma once

#include "gui/operations/gui_context.h"

#include <QObject>

namespace gui {

class SectionsPanel;

class SectionOperations : public QObject {
    Q_OBJECT

  public:
    SectionOperations(const GuiContext& context, QObject* parent);

  private:
    GuiContext context_;
    SectionsPanel* panel_;
};

} // namespace gui
