/// What lights the scene: looks and environment maps, of menus and of files that are dropped.
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
