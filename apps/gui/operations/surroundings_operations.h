/// Operations on the light of the scene: lighting presets and environment maps, from menus and dropped files.
#pragma once

#include "gui/operations/gui_context.h"

#include <QObject>
#include <QString>

#include <string>

namespace gui {

class SurroundingsOperations : public QObject {
    Q_OBJECT

  public:
    SurroundingsOperations(const GuiContext& context, QObject* parent);

    /// Shows the environment map of a file.
    void open(const QString& path);

  private:
    /// Says `done` when the server did it.
    void edit(const std::string& line, const QString& done);
    void askForFile();

    GuiContext context_;
    QString folder_; ///< of the last map
};

} // namespace gui
