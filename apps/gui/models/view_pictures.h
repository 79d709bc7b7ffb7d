/// Images of the views that a scene has of its own: kept in the cache of the user, since its file has none.
#pragma once

#include <QImage>
#include <QString>

namespace gui {

/// By scene and view, whatever its name, so that one that comes back has its image again; at most 500 files
/// and 32 MB, from which the oldest ones are removed. Any of them may be missing, or go. One thread. Trouble
/// with files is none: an image comes again.
class ViewPictures {
  public:
    /// `folder`: where the images of all scenes are.
    explicit ViewPictures(QString folder = usualFolder());
    static QString usualFolder(); ///< in the user's cache folder

    /// `scene`: the path of its file; empty: no images.
    void setScene(const QString& scene);
    /// `view`: SceneState::bookmarkViews; "": not known, without an image. Null where there is none.
    QImage picture(const QString& view) const;
    void keep(const QString& view, const QImage& picture);

    static constexpr int kMaxFiles = 500;
    static constexpr qint64 kMaxBytes = 32'000'000;

  private:
    QString path(const QString& view) const;
    void removeOld() const;

    QString folder_, scene_;
};

} // namespace gui
