/// Bookmarks: kept in files for each scene, shown in a panel, reached by keys.
#pragma once

#include "gui/models/bookmark_store.h"
#include "gui/operations/gui_context.h"

#include <QObject>

#include <functional>

namespace gui {

class BookmarksPanel;

class BookmarkOperations : public QObject {
    Q_OBJECT

  public:
    BookmarkOperations(const GuiContext& context, QObject* parent);

  private:
    void addKeys();
    void addBookmark();
    void keepWithPicture(const QByteArray& camera);
    void keep(const QByteArray& camera, const QImage& picture);
    void go(int row);
    void rename(int row, const QString& name);
    void remove(int row);
    void refill();
    void tellTrouble(const QString& text);

    GuiContext context_;
    BookmarkStore store_;
    BookmarksPanel* panel_;
};

} // namespace gui
