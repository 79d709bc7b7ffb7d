/// The bookmarks of the scene with their images. Knows neither files nor servers.
#pragma once

#include "gui/panels/view_list.h"

#include <QList>
#include <QStringList>
#include <QWidget>

class QListWidget;
class QListWidgetItem;
class QPushButton;

namespace gui {

class BookmarksPanel : public QWidget {
    Q_OBJECT

  public:
    explicit BookmarksPanel(QWidget* parent = nullptr);

    void show(const QList<BookmarkRow>& rows);
    using QWidget::show;
    /// Whether there is a server to go and to add.
    void setServerThere(bool there);
    QListWidget& list() { return *list_; }
    /// Lets the user type the name of a row.
    void beginRename(int row);

  signals:
    // Rows are counted from 0.
    void addWanted();
    void goWanted(int row);
    void renameWanted(int row, const QString& name);
    void deleteWanted(int row);

  private:
    void onEdited(QListWidgetItem* item);
    void enable();

    QListWidget* list_;
    QPushButton *add_, *go_, *rename_, *delete_;
    QStringList names_;
    bool server_ = false;
};

} // namespace gui
