/// The saved views of the scene beside each other, as images. Knows neither files nor servers.
#pragma once

#include "gui/panels/view_list.h"

#include <QList>
#include <QStringList>
#include <QWidget>

class QAction;
class QListWidget;
class QListWidgetItem;
class QMenu;
class QToolButton;

namespace gui {

class ViewsStrip : public QWidget {
    Q_OBJECT

  public:
    explicit ViewsStrip(QWidget* parent = nullptr);

    void show(const QList<BookmarkRow>& rows);
    using QWidget::show;
    /// Whether there is a server to go and to add.
    void setServerThere(bool there);
    QListWidget& list() { return *list_; }
    QToolButton& adder() { return *add_; }
    /// What a right click on a view offers; its entries are for the current one.
    QMenu& menu() { return *menu_; }
    QSize sizeHint() const override;

  signals:
    // Rows are counted from 0.
    void addWanted();
    void goWanted(int row);
    void renameWanted(int row, const QString& name);
    void replaceWanted(int row);      ///< by the current view
    void moveWanted(int row, int by); ///< -1: to the left, 1: to the right
    void deleteWanted(int row);

  private:
    QAction* addEntry(const QString& text, const QKeySequence& key, void (ViewsStrip::*act)());
    void fillMenu();
    void go();
    void beginRename();
    void replace();
    void moveLeft();
    void moveRight();
    void moveBy(int by);
    void remove();
    void onEdited(QListWidgetItem* item);
    void enable();

    QListWidget* list_;
    QToolButton* add_;
    QMenu* menu_;
    QAction *go_ = nullptr, *rename_ = nullptr, *replace_ = nullptr, *left_ = nullptr, *right_ = nullptr,
            *delete_ = nullptr;
    QStringList names_;
    QString moving_; ///< the view that has been asked to move; empty: none
    bool server_ = false;
};

} // namespace gui
