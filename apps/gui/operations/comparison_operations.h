/// Comparing the shown image with one that was kept.
#pragma once

#include "gui/models/action_table.h"
#include "gui/operations/gui_context.h"

#include <QObject>

namespace gui {

class Comparison;
enum class CompareMode;

class ComparisonOperations : public QObject {
    Q_OBJECT

  public:
    ComparisonOperations(const GuiContext& context, QObject* parent);

  private:
    void keep();
    void toggle(ActionId id, CompareMode mode, bool on);

    GuiContext context_;
    Comparison* comparison_;
};

} // namespace gui
