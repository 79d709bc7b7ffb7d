/// Sections of the model, by their panel and by their handles in the image.
#pragma once

#include "gui/operations/gui_context.h"

#include <QObject>

#include <optional>
#include <string>

namespace gui {

class SectionHandles;
class SectionsPanel;

class SectionOperations : public QObject {
    Q_OBJECT

  public:
    SectionOperations(const GuiContext& context, QObject* parent);

  private:
    void connectPanel();
    void connectHandles();
    void showHandles();
    void follow(const QString& step, const std::string& line, std::optional<bool> goesOn);

    GuiContext context_;
    SectionsPanel* panel_;
    SectionHandles* handles_;
    bool panelSeen_ = false;
};

} // namespace gui
