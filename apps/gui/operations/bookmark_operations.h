/// Bookmarks: those of the scene, which the server has, and those that the window keeps in files for it;
/// shown in a panel and in a strip, reached by keys. Saving the scene makes them its own.
#pragma once

#include "gui/models/bookmark_store.h"
#include "gui/models/view_pictures.h"
#include "gui/operations/gui_context.h"

#include <QObject>

#include <functional>
#include <optional>
#include <string>

namespace gui {

class BookmarksPanel;
class ViewsStrip;
class VisitPicture;

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
        QString view; ///< SceneState::bookmarkViews, of the scene's own
        std::optional<Bookmark> kept;
    };
    QList<Entry> entries() const;
    QImage pictureOf(const Entry& entry) const;
    void addPanels();
    void setScene(const QString& scene);
    void onState();
    void addKeys();
    void addBookmark();
    /// The camera as a .cam, and what is seen by it.
    using Keep = std::function<void(const QByteArray& camera, const QImage& picture)>;
    void takeView(const Keep& keep);
    void takePicture(const QByteArray& camera, const Keep& keep);
    void keep(const QByteArray& camera, const QImage& picture);
    void keepPicture(const QString& name, const QImage& picture);
    QString viewOf(const QString& name) const;
    void keepReplaced(const Entry& before, const QImage& picture);
    void takeReplaced();
    void go(int row);
    void rename(int row, const QString& name);
    bool renameKept(const Bookmark& bookmark, const QString& name, const std::string& line);
    void replace(int row);
    void replaceKept(const Entry& entry, const QByteArray& camera, const QImage& picture);
    void move(int row, int by);
    void moveKept(const Bookmark& bookmark, const Bookmark& other);
    void remove(int row);
    /// `line`: the edit of the scene that belongs to it; "": none.
    void change(const QString& text, const QList<BookmarkFiles>& before, const QList<BookmarkFiles>& after,
                const std::string& line = {});
    void refill();
    void tellTrouble(const QString& text);

    GuiContext context_;
    BookmarkStore store_;
    ViewPictures pictures_; ///< of the scene's own
    QStringList shown_;     ///< of the scene, in the panel: names, then views
    /// The image of a view of the scene that was replaced, until the state has that.
    struct Replaced {
        QString name, before; ///< before: its view
        QImage picture;
    };
    std::optional<Replaced> replaced_;
    BookmarksPanel* panel_;
    ViewsStrip* strip_;
    VisitPicture* visit_;
};

} // namespace gui
