/// Places that the user keeps, for each scene a folder of its own: a .cam file each, which every program of
/// the suite reads, with a small image beside it. "03 By the altar.cam": the number gives the order.
#pragma once

#include <QByteArray>
#include <QCoreApplication>
#include <QImage>
#include <QList>
#include <QString>
#include <QStringList>

namespace gui {

struct Bookmark {
    QString file; ///< name without its extension: what identifies it
    QString name;
    friend bool operator==(const Bookmark&, const Bookmark&) = default;
};

/// The contents of a bookmark's files, to bring it back.
struct BookmarkFiles {
    QString file;
    QByteArray camera, picture; ///< .cam, .png; the image may be missing
};

/// One thread. Files are written whole or not at all. Functions that change something return what went wrong,
/// in words for the user; empty: nothing.
class BookmarkStore {
    Q_DECLARE_TR_FUNCTIONS(gui::BookmarkStore)

  public:
    /// `folder`: where the folders of all scenes are.
    explicit BookmarkStore(QString folder = usualFolder());
    static QString usualFolder(); ///< in the user's data folder

    /// `scene`: the path of its file; empty: no bookmarks.
    void setScene(const QString& scene);
    const QString& folder() const { return folder_; }
    /// In their order.
    QList<Bookmark> list() const;
    QString cameraPath(const Bookmark& bookmark) const;
    QImage picture(const Bookmark& bookmark) const; ///< null when there is none

    QString add(const QString& name, const QByteArray& camera, const QImage& picture);
    QString remove(const Bookmark& bookmark);
    BookmarkFiles read(const Bookmark& bookmark) const;
    QString write(const BookmarkFiles& files);
    /// Another image, in place of the one that is there.
    QString keepPicture(const Bookmark& bookmark, const QImage& picture);
    /// The files of two after they changed places in the order; none where one has no number there.
    QList<BookmarkFiles> exchanged(const Bookmark& a, const Bookmark& b) const;
    /// The files of one under another name; without a `file` where that is no other one.
    BookmarkFiles renamed(const Bookmark& bookmark, const QString& name) const;
    bool has(const QString& file) const;
    /// "Place 3": a name that none has, nor is among those.
    QString freeName(const QStringList& taken = {}) const;
    /// Copies of all, for another scene.
    QString copyTo(const QString& scene) const;

  private:
    QString path(const QString& file, const char* extension) const;

    QString root_, folder_;
};

/// As BookmarkFiles has it; empty of a null image.
QByteArray pictureBytes(const QImage& picture);

/// The user's name as a part of a file's name: without '/' and what else file systems do not take.
QString fileNameOf(const QString& name);

} // namespace gui
