#include "gui/models/still_quality.h"

#include "gui/models/preferences.h"

#include "common/process/resting_image.h"

namespace gui {

StillDenoise stillDenoise(const Preferences& preferences) {
    const QString stored = preferences.get(pref::stillDenoise);
    for (const StillDenoise each : {StillDenoise::Net, StillDenoise::Filter, StillDenoise::Off})
        if (stored == nameOf(each)) return each;
    return preferences.get(pref::stillFilter) > 0 ? StillDenoise::Net : StillDenoise::Off;
}

QString nameOf(StillDenoise how) {
    switch (how) {
    case StillDenoise::Net:
        return QStringLiteral("net");
    case StillDenoise::Filter:
        return QStringLiteral("filter");
    case StillDenoise::Off:
        break;
    }
    return QStringLiteral("off");
}

StillQuality stillQuality(const Preferences& preferences) {
    StillQuality quality;
    quality.byPaths = preferences.get(pref::globalIllumination);
    quality.paths = preferences.get(pref::stillPathSamples);
    quality.denoise = stillDenoise(preferences);
    quality.filter = preferences.get(pref::stillFilter);
    quality.antialiasing = preferences.get(pref::stillAntialiasing);
    quality.bloom = preferences.get(pref::stillBloom);
    const QString occlusion = preferences.get(pref::stillOcclusion);
    if (occlusion == QLatin1String("on")) quality.occlusion = StillOcclusion::On;
    if (occlusion == QLatin1String("off")) quality.occlusion = StillOcclusion::Off;
    quality.occlusionSamples = preferences.get(pref::stillOcclusionSamples);
    return quality;
}

QStringList rendererOptions(const StillQuality& quality) {
    QStringList options;
    if (quality.bloom >= 0) options.append(QStringLiteral("--bloom=%1").arg(quality.bloom));
    if (quality.byPaths) {
        if (quality.paths > 0) options.append(QStringLiteral("--samples=%1").arg(quality.paths));
        const bool off = quality.denoise == StillDenoise::Off, byNet = quality.denoise == StillDenoise::Net;
        for (const std::string& each : app::restingPathOptions(off ? 0 : quality.filter, byNet))
            options.append(QString::fromStdString(each));
        return options;
    }
    options.prepend(QStringLiteral("--antialiasing=%1").arg(quality.antialiasing));
    if (quality.occlusion == StillOcclusion::On) options.append(QStringLiteral("--ambient-occlusion"));
    if (quality.occlusion == StillOcclusion::Off) options.append(QStringLiteral("--no-ambient-occlusion"));
    // By its name, since --ao-samples switches it on.
    if (quality.occlusionSamples > 0)
        options.append(QStringLiteral("--setting=ambientOcclusion.samples=%1").arg(quality.occlusionSamples));
    return options;
}

} // namespace gui
