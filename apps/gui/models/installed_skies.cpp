#include "gui/models/installed_skies.h"

#include "gui/models/example_scenes.h"

#include <QCoreApplication>
#include <QFileInfo>
#include <QStringList>

namespace gui {

namespace {

struct KnownSky {
    const char* file; ///< without its suffix
    const char* name;
};
constexpr KnownSky kKnownSkies[]{
    {"day", QT_TRANSLATE_NOOP("Skies", "Day")},
    {"sunset", QT_TRANSLATE_NOOP("Skies", "Sunset")},
    {"night", QT_TRANSLATE_NOOP("Skies", "Night")},
};

} // namespace

QList<InstalledSky> installedSkiesIn(const QString& folder) {
    QList<InstalledSky> skies;
    for (const KnownSky& each : kKnownSkies) {
        const QString path =
            QStringLiteral("%1/environments/generated/%2.hdr").arg(folder, QString::fromLatin1(each.file));
        if (QFileInfo(path).isReadable())
            skies.append({QCoreApplication::translate("Skies", each.name), path});
    }
    return skies;
}

QList<InstalledSky> installedSkies() {
    for (const QString& folder : sceneFolders()) {
        if (QList<InstalledSky> skies = installedSkiesIn(folder); !skies.isEmpty()) return skies;
    }
    return {};
}

bool isEnvironmentFile(const QString& path) {
    static const QStringList suffixes{QStringLiteral("hdr"), QStringLiteral("exr"), QStringLiteral("pfm"),
                                      QStringLiteral("png"), QStringLiteral("jpg"), QStringLiteral("jpeg")};
    return suffixes.contains(QFileInfo(path).suffix().toLower());
}

} // namespace gui
