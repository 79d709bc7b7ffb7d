/// Variants: a menu that switches them, keeps what is shown as one, and changes the one that is shown.
#pragma once

#include "gui/operations/gui_context.h"

#include <QObject>
#include <QString>
#include <QStringList>

#include <functional>
#include <string>

namespace gui {

class VariantOperations : public QObject {
    Q_OBJECT

  public:
    VariantOperations(const GuiContext& context, QObject* parent);

  private:
    void fill();
    void addChoices();
    void addChanges();
    void askForName(const QString& title, const QString& proposed,
                    const std::function<void(const QString&)>& act);
    /// Says `done` when the server did it.
    void edit(const std::string& line, const QString& done);

    GuiContext context_;
    QStringList names_; ///< in the menu
    QString active_;
};

} // namespace gui
