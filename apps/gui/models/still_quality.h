/// How well an image at rest is rendered: progressive rendering and quick render.
#pragma once

#include "common/process/resting_image.h"

#include <QString>
#include <QStringList>

namespace gui {

class Preferences;

/// Ambient occlusion of a still image: as in the live frame, on, or off.
enum class StillOcclusion { AsLive, On, Off };

/// How noise is taken from an image by paths.
enum class StillDenoise { Net, Filter, Off };

/// By its stored name: "net", "filter", "off". Else by what was stored before there were nets: no passes of
/// the filter mean that noise stays.
StillDenoise stillDenoise(const Preferences& preferences);
QString nameOf(StillDenoise how);

struct StillQuality {
    bool byPaths = false; ///< with all light that surfaces send to each other
    int paths = 0;        ///< per pixel; 0 = as the scene's settings have it, which its quality sets
    StillDenoise denoise = StillDenoise::Net; ///< of these; without weights by the filter
    int filter = app::kRestingFilter;         ///< its passes
    int antialiasing = 1;                     ///< n x n samples per pixel; not of paths, nor is occlusion
    int bloom = -1;                           ///< pixels; -1 = as the live frame
    StillOcclusion occlusion = StillOcclusion::AsLive;
    int occlusionSamples = 0; ///< rays per point; 0 = as the live frame

    friend bool operator==(const StillQuality&, const StillQuality&) = default;
};

/// The quality that the user has chosen.
StillQuality stillQuality(const Preferences& preferences);

/// The Renderer's options; what is the same as in the viewport comes with the exported scene and camera.
QStringList rendererOptions(const StillQuality& quality);

} // namespace gui
