#include "gui/models/preferences.h"

#include "common/process/private_files.h"

#include <QDir>
#include <QFileInfo>
#include <QStandardPaths>

namespace gui {

namespace {
constexpr qsizetype kMaxRecent = 10;
}

Preferences::Preferences(QObject* parent)
    : QObject(parent), settings_(QSettings::IniFormat, QSettings::UserScope, QStringLiteral("rtsuite"),
                                 QStringLiteral("GUI")) {
    app::makePrivateFolder(QFileInfo(settings_.fileName()).absolutePath().toStdString());
    app::makePrivateFile(settings_.fileName().toStdString()); // which keeps its mode when it is written
}

QStringList Preferences::recentFiles() const {
    QStringList files = get(pref::recentFiles);
    files.removeIf([](const QString& path) { return !QFileInfo::exists(path); });
    return files.mid(0, kMaxRecent);
}

void Preferences::addRecentFile(const QString& path) {
    QStringList files = get(pref::recentFiles);
    files.removeAll(path);
    files.prepend(path);
    set(pref::recentFiles, files.mid(0, kMaxRecent));
}

QString Preferences::picturesFolder() const {
    const QString chosen = get(pref::pictureFolder);
    if (!chosen.isEmpty() && QFileInfo(chosen).isDir()) return chosen;
    const QString usual = QStandardPaths::writableLocation(QStandardPaths::PicturesLocation);
    return QFileInfo(usual).isDir() ? usual : QDir::homePath();
}

QString nextFreeName(const QString& folder, const QString& name, const QString& extension) {
    for (int number = 1;; ++number) {
        const QString path = QDir(folder).filePath(
            QStringLiteral("%1-%2.%3").arg(name).arg(number, 4, 10, QLatin1Char('0')).arg(extension));
        if (!QFileInfo::exists(path)) return path;
    }
}

} // namespace gui
