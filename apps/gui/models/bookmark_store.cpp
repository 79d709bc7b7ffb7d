#include "gui/models/bookmark_store.h"

#include "common/process/private_files.h"

#include <QBuffer>
#include <QCryptographicHash>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QSaveFile>
#include <QStandardPaths>

#include <algorithm>

namespace gui {

namespace {

constexpr qsizetype kLongestName = 60;
constexpr int kHashDigits = 12;

// "03 Altar": 3. A file without a number, put there by hand, comes last.
int numberOf(const QString& file) {
    bool good = false;
    const int number = file.section(QLatin1Char(' '), 0, 0).toInt(&good);
    return good && number > 0 ? number : 1'000'000;
}

QString nameOf(const QString& file) {
    return numberOf(file) < 1'000'000 ? file.section(QLatin1Char(' '), 1) : file;
}

QString save(const QString& path, const QByteArray& bytes) {
    QSaveFile file(path);
    const bool open = file.open(QIODevice::WriteOnly) &&
                      file.setPermissions(QFileDevice::ReadOwner | QFileDevice::WriteOwner);
    const bool done = open && file.write(bytes) == bytes.size() && file.commit();
    return done ? QString() : BookmarkStore::tr("%1 cannot be written: %2").arg(path, file.errorString());
}

QByteArray load(const QString& path) {
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

} // namespace

QString fileNameOf(const QString& name) {
    QString clean;
    for (const QChar letter : name.simplified()) {
        const bool bad = !letter.isPrint() || QStringLiteral("/\\:*?\"<>|").contains(letter);
        clean += bad ? QLatin1Char('-') : letter;
    }
    return clean.left(kLongestName).trimmed();
}

QByteArray pictureBytes(const QImage& picture) {
    QByteArray bytes;
    QBuffer buffer(&bytes);
    if (!picture.isNull() && buffer.open(QIODevice::WriteOnly)) picture.save(&buffer, "PNG");
    return bytes;
}

BookmarkStore::BookmarkStore(QString folder) : root_(std::move(folder)) {}

QString BookmarkStore::usualFolder() {
    return QStandardPaths::writableLocation(QStandardPaths::GenericDataLocation) +
           QStringLiteral("/rtsuite/bookmarks");
}

// The name for people, the hash for scenes of the same name in other folders.
void BookmarkStore::setScene(const QString& scene) {
    folder_.clear();
    if (scene.isEmpty()) return;
    const QFileInfo file(scene);
    const QString canonical = file.canonicalFilePath();
    const QByteArray hash =
        QCryptographicHash::hash((canonical.isEmpty() ? scene : canonical).toUtf8(), QCryptographicHash::Sha1)
            .toHex()
            .left(kHashDigits);
    folder_ = QDir(root_).filePath(fileNameOf(file.completeBaseName()) + QLatin1Char('-') +
                                   QString::fromLatin1(hash));
}

QString BookmarkStore::path(const QString& file, const char* extension) const {
    return folder_ + QLatin1Char('/') + file + QLatin1String(extension);
}

QString BookmarkStore::cameraPath(const Bookmark& bookmark) const { return path(bookmark.file, ".cam"); }

QList<Bookmark> BookmarkStore::list() const {
    QList<Bookmark> all;
    if (folder_.isEmpty()) return all;
    const QStringList files = QDir(folder_).entryList({QStringLiteral("*.cam")}, QDir::Files, QDir::Name);
    for (const QString& name : files) {
        const QString file = name.chopped(4);
        all.append({file, nameOf(file)});
    }
    std::stable_sort(all.begin(), all.end(), [](const Bookmark& a, const Bookmark& b) {
        return numberOf(a.file) < numberOf(b.file);
    });
    return all;
}

QImage BookmarkStore::picture(const Bookmark& bookmark) const { return QImage(path(bookmark.file, ".png")); }

QString BookmarkStore::copyTo(const QString& scene) const {
    BookmarkStore other(root_);
    other.setScene(scene);
    if (other.folder() == folder_) return {};
    for (const Bookmark& bookmark : list()) {
        const QString trouble = other.write(read(bookmark));
        if (!trouble.isEmpty()) return trouble;
    }
    return {};
}

QString BookmarkStore::freeName(const QStringList& names) const {
    const QList<Bookmark> all = list();
    for (int number = 1;; ++number) {
        const QString name = tr("Place %1").arg(number);
        const bool taken = std::any_of(all.begin(), all.end(),
                                       [&](const Bookmark& bookmark) { return bookmark.name == name; });
        if (!taken && !names.contains(name)) return name;
    }
}

QString BookmarkStore::add(const QString& name, const QByteArray& camera, const QImage& picture) {
    int number = 0;
    for (const Bookmark& bookmark : list()) {
        if (numberOf(bookmark.file) < 1'000'000) number = std::max(number, numberOf(bookmark.file));
    }
    BookmarkFiles files;
    files.file = QStringLiteral("%1 %2").arg(number + 1, 2, 10, QLatin1Char('0')).arg(fileNameOf(name));
    files.camera = camera;
    files.picture = pictureBytes(picture);
    return write(files);
}

QString BookmarkStore::keepPicture(const Bookmark& bookmark, const QImage& picture) {
    if (!QFile::exists(cameraPath(bookmark)) || picture.isNull()) return {};
    return save(path(bookmark.file, ".png"), pictureBytes(picture));
}

QList<BookmarkFiles> BookmarkStore::exchanged(const Bookmark& a, const Bookmark& b) const {
    if (std::max(numberOf(a.file), numberOf(b.file)) == 1'000'000) return {};
    const auto named = [](const Bookmark& number, const Bookmark& name) {
        return number.file.section(QLatin1Char(' '), 0, 0) + QLatin1Char(' ') + nameOf(name.file);
    };
    BookmarkFiles first = read(a), second = read(b);
    first.file = named(b, a);
    second.file = named(a, b);
    return {first, second};
}

// The image first: a camera without one would stay so.
QString BookmarkStore::write(const BookmarkFiles& files) {
    if (folder_.isEmpty()) return tr("No scene is shown.");
    for (const QString& folder : {root_, folder_}) app::makePrivateFolder(folder.toStdString());
    if (!QFileInfo(folder_).isDir()) return tr("%1 cannot be written: %2").arg(folder_, tr("no such folder"));
    if (!files.picture.isEmpty()) {
        const QString trouble = save(path(files.file, ".png"), files.picture);
        if (!trouble.isEmpty()) return trouble;
    }
    return save(path(files.file, ".cam"), files.camera);
}

BookmarkFiles BookmarkStore::renamed(const Bookmark& bookmark, const QString& name) const {
    const QString clean = fileNameOf(name);
    if (clean.isEmpty() || clean == bookmark.name) return {};
    BookmarkFiles files = read(bookmark);
    const bool numbered = numberOf(bookmark.file) < 1'000'000;
    files.file = numbered ? bookmark.file.section(QLatin1Char(' '), 0, 0) + QLatin1Char(' ') + clean : clean;
    return files;
}

bool BookmarkStore::has(const QString& file) const { return QFile::exists(path(file, ".cam")); }

BookmarkFiles BookmarkStore::read(const Bookmark& bookmark) const {
    return {bookmark.file, load(cameraPath(bookmark)), load(path(bookmark.file, ".png"))};
}

QString BookmarkStore::remove(const Bookmark& bookmark) {
    QFile camera(cameraPath(bookmark));
    if (!camera.remove()) return camera.errorString();
    QFile::remove(path(bookmark.file, ".png"));
    return {};
}

} // namespace gui
