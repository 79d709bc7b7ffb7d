#include "gui/models/still_quality.h"

#include "gui/models/preferences.h"

namespace gui {

StillQuality stillQuality(const Preferences& preferences) {
    StillQuality quality;
    quality.byPaths = preferences.get(pref::globalIllumination);
    quality.paths = preferences.get(pref::stillPathSamples);
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
        options.append(QStringLiteral("--integrator=path"));
        if (quality.paths > 0) options.append(QStringLiteral("--samples=%1").arg(quality.paths));
        // There is more light than in the live frame, whose exposure comes with the camera. Noise is filtered
        // from the first sample to the last, so that the image never gets worse.
        return options << QStringLiteral("--setting=exposure.recorded=automatic")
                       << QStringLiteral("--setting=path.filter=%1").arg(quality.filter)
                       << QStringLiteral("--setting=denoise.net=%1")
                              .arg(quality.filter > 0 ? QLatin1String("automatic") : QLatin1String("off"));
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
