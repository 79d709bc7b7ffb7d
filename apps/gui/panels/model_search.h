/// A line that looks for parts and materials by their names. Knows no server.
#pragma once

#include <QLineEdit>
#include <QList>
#include <QString>

class QTreeWidget;
class QTreeWidgetItem;

namespace gui {

/// Whether one looks for `text` and `name` is what one means: without * and ? a part of it, with them a
/// pattern for all of it, or for what stands behind its last slash. Upper and lower case are the same. All is
/// meant where there is no text but blanks.
bool isMeant(const QString& text, const QString& name);

/// Shows those items alone whose names are meant, open down to them, and all where nothing is looked for.
/// Names are data of this role; an item without one is a group, and is shown with what is below it. The items
/// that are meant, all of them where nothing is looked for.
QList<QTreeWidgetItem*> showMeant(QTreeWidget& tree, const QString& text, int nameRole);

/// Esc clears it, before it leads out of the panel; Return is QLineEdit::returnPressed.
class ModelSearch : public QLineEdit {
    Q_OBJECT

  public:
    explicit ModelSearch(QWidget* parent = nullptr);

  protected:
    bool event(QEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
};

} // namespace gui
