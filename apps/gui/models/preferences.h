/// The preferences of the window: each key of QSettings with its default, once.
#pragma once

#include "common/process/resting_image.h"

#include <QObject>
#include <QSettings>
#include <QSize>
#include <QStringList>
#include <QVariant>

namespace gui {

/// One row: the name in the file, and the value while none is stored.
template <typename T>
struct Preference {
    const char* name;
    T byDefault;
};

namespace pref {
inline const Preference<bool> ignoreAspectRatio{"display/ignoreAspectRatio", false};
inline const Preference<bool> smoothTransformation{"display/smoothTransformation", true};
inline const Preference<bool> showOverlay{"display/showOverlay", true};
inline const Preference<bool> showErrors{"display/showErrors", false};
inline const Preference<bool> showCube{"display/showCube", true};
inline const Preference<bool> planInCorner{"display/planInCorner", false};
inline const Preference<bool> lightMarks{"display/lightMarks", false};
inline const Preference<bool> sectionHandles{"display/sectionHandles", false};
inline const Preference<bool> showMeasures{"display/showMeasures", true};
inline const Preference<bool> showNotes{"display/showNotes", true};
inline const Preference<QString> noteAuthor{"notes/author", QString()};
inline const Preference<QString> theme{"display/theme", QStringLiteral("system")}; ///< system, light, dark
inline const Preference<QString> language{"display/language", QStringLiteral("system")}; ///< system, en, cs
inline const Preference<bool> progressiveRendering{"render/progressive", true};
inline const Preference<bool> globalIllumination{"render/globalIllumination", true}; ///< at rest
inline const Preference<int> stillPathSamples{"render/stillPathSamples", 0};     ///< 0 = as the live frame
inline const Preference<QString> stillDenoise{"render/stillDenoise", QString()}; ///< StillDenoise
inline const Preference<int> stillFilter{"render/stillFilter", app::kRestingFilter}; ///< where no net is
inline const Preference<int> stillAntialiasing{"render/stillAntialiasing", 3};
inline const Preference<int> stillBloom{"render/stillGlow", -1}; ///< -1 = as the live frame
inline const Preference<QString> stillOcclusion{"render/stillOcclusion", QStringLiteral("live")}; ///< on, off
inline const Preference<int> stillOcclusionSamples{"render/stillOcclusionSamples", 0}; ///< 0 = as live
inline const Preference<bool> followWindowSize{"server/followWindowSize", true};
inline const Preference<int> pictureScale{"server/pictureScale", 100}; ///< percent of the window's pixels
inline const Preference<int> frameTime{"server/frameTime", 33}; ///< ms while something moves; 0 = no limit
inline const Preference<bool> keepServers{"server/keepRunning", false};
inline const Preference<QString> instance{"server/instance", QStringLiteral("default")};
inline const Preference<bool> shareDriving{"share/driving", true}; ///< pages may walk
inline const Preference<bool> shareEdits{"share/edits", true};     ///< and change settings and lights
inline const Preference<bool> shareNotes{"share/notes", false};    ///< those who only look may write notes
inline const Preference<QString> shareCertificate{"share/certificate", QString()};
inline const Preference<QString> shareKey{"share/key", QString()};
inline const Preference<double> mouseSensitivity{"input/mouseSensitivity", 0.12}; ///< degrees per pixel
inline const Preference<bool> invertMouse{"input/invertMouse", false};
inline const Preference<QString> mouse{"input/mouse", QStringLiteral("usual")};           ///< f3d, blender
inline const Preference<QString> shortcuts{"input/shortcuts", QStringLiteral("desktop")}; ///< thesis
inline const Preference<QString> bindings{"input/bindings", QString()}; ///< as readBindings() reads it
inline const Preference<QString> pictureFolder{"files/pictureFolder", QString()};
inline const Preference<QString> sceneFolder{"files/sceneFolder", QString()};
inline const Preference<QString> cameraFolder{"files/cameraFolder", QString()};
inline const Preference<int> modelCacheMegabytes{"files/keptModels",
                                                 2048}; ///< size of the model cache; 0 = none
inline const Preference<QString> planFolder{"files/planFolder", QString()};
inline const Preference<QStringList> recentFiles{"files/recent", QStringList()};
inline const Preference<QSize> exportSize{"export/size", QSize()};
inline const Preference<int> exportAntialiasing{"export/antialiasing", 1};
inline const Preference<int> exportBloom{"export/bloom", 0};
inline const Preference<double> planScale{"export/planScale", 100}; ///< 1 to that
inline const Preference<QString> planPaper{"export/planPaper", QStringLiteral("sheet")};
inline const Preference<double> planDpi{"export/planDpi", 300}; ///< pixels to an inch of paper
inline const Preference<QString> planImage{"export/planImage", QStringLiteral("lines")};
inline const Preference<double> planHeight{"export/planHeight", 1.2}; ///< metres above the floor
inline const Preference<QSize> highQualitySize{"export/highQualitySize", QSize(1920, 1080)};
inline const Preference<int> highQualityAntialiasing{"export/highQualityAntialiasing", 4};
inline const Preference<int> highQualityBloom{"export/highQualityBloom", 0};
inline const Preference<QStringList> foldedSettings{"window/foldedSettings", QStringList()}; ///< groups
inline const Preference<bool> advancedSettings{"window/advancedSettings", false};            ///< unfolded
inline const Preference<QByteArray> geometry{"window/geometry", QByteArray()};
inline const Preference<QByteArray> windowState{"window/state", QByteArray()};
} // namespace pref

/// One thread.
class Preferences : public QObject {
    Q_OBJECT

  public:
    explicit Preferences(QObject* parent = nullptr);

    template <typename T>
    T get(const Preference<T>& row) const {
        const QVariant value = settings_.value(QLatin1String(row.name));
        return value.isValid() && value.canConvert<T>() ? value.value<T>() : row.byDefault;
    }
    template <typename T>
    void set(const Preference<T>& row, const T& value) {
        if (get(row) == value) return;
        settings_.setValue(QLatin1String(row.name), QVariant::fromValue(value));
        emit changed();
    }

    /// Newest first, ten at most; files that are gone are left out.
    QStringList recentFiles() const;
    void addRecentFile(const QString& path);
    void clearRecentFiles() { set(pref::recentFiles, QStringList()); }

    /// The folder for images and cameras when none is chosen yet.
    QString picturesFolder() const;

  signals:
    void changed();

  private:
    QSettings settings_;
};

/// "name-0001.png" in the folder: the first number that is free.
QString nextFreeName(const QString& folder, const QString& name, const QString& extension);

} // namespace gui
