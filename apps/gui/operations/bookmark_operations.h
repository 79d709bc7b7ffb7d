/// Bookmarks: those of the scene, which the server has, and those that the window keeps in files for it;
/// shown in a panel, reached by keys. Saving the scene makes them its own.
#pragma once

#include "gui/models/bookmark_store.h"
#include "gui/operations/gui_context.h"

#include <QObject>

#include <functional>
#include <optional>

namespace gui {

class BookmarksPanel;

class BookmarkOperations : public QObject {
    Q_OBJECT

  public:
    BookmarkOperations(const GuiContext& context, QObject* parent);

    /// Adds to the scene what only the window keeps.
    void giveToScene();
    /// The scene goes on under another name.
    void follow(const QString& scene);

  private:
    /// Those of the scene come first, with the images of the window's bookmarks of the same names.
    struct Entry {
        QString name;
        bool ofScene = false;
        std::optional<Bookmark> kept;
    };
    QList<Entry> entries() const;
    void onState();
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
    QStringList shown_; ///< of the scene, in the panel
    BookmarksPanel* panel_;
};

} // namespace gui
