#include "gui/models/view_pictures.h"

#include "common/process/private_files.h"

#include <QCryptographicHash>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QSaveFile>
#include <QStandardPaths>

#include <utility>

namespace gui {

ViewPictures::ViewPictures(QString folder) : folder_(std::move(folder)) {}

QString ViewPictures::usualFolder() {
    return QStandardPaths::writableLocation(QStandardPaths::GenericCacheLocation) +
           QStringLiteral("/rtsuite/views");
}

void ViewPictures::setScene(const QString& scene) {
    const QString canonical = QFileInfo(scene).canonicalFilePath();
    scene_ = canonical.isEmpty() ? scene : canonical;
}

QString ViewPictures::path(const QString& view) const {
    constexpr int kDigits = 32;
    const QByteArray key = scene_.toUtf8() + '\0' + view.toUtf8();
    const QByteArray hash = QCryptographicHash::hash(key, QCryptographicHash::Sha256).toHex().left(kDigits);
    return folder_ + QLatin1Char('/') + QString::fromLatin1(hash) + QStringLiteral(".png");
}

QImage ViewPictures::picture(const QString& view) const {
    return scene_.isEmpty() || view.isEmpty() ? QImage() : QImage(path(view));
}

void ViewPictures::keep(const QString& view, const QImage& picture) {
    if (scene_.isEmpty() || view.isEmpty() || picture.isNull()) return;
    app::makePrivateFolder(folder_.toStdString());
    QSaveFile file(path(view));
    if (!file.open(QIODevice::WriteOnly)) return;
    file.setPermissions(QFileDevice::ReadOwner | QFileDevice::WriteOwner);
    if (picture.save(&file, "PNG")) file.commit();
    removeOld();
}

void ViewPictures::removeOld() const {
    const QFileInfoList files =
        QDir(folder_).entryInfoList({QStringLiteral("*.png")}, QDir::Files, QDir::Time); // newest first
    qint64 bytes = 0;
    for (qsizetype i = 0; i < files.size(); ++i) {
        bytes += files[i].size();
        if (i >= kMaxFiles || bytes > kMaxBytes) QFile::remove(files[i].filePath());
    }
}

} // namespace gui
