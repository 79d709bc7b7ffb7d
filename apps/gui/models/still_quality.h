/// How well a picture at rest is rendered: progressive rendering and quick render.
#pragma once

#include <QStringList>

namespace gui {

class Preferences;

/// What stands beside ambient occlusion for "on or off".
enum class StillOcclusion { AsLive, On, Off };

struct StillQuality {
    int antialiasing = 1; ///< n x n samples a pixel
    int bloom = -1;       ///< pixels; -1 = as the live picture
    StillOcclusion occlusion = StillOcclusion::AsLive;
    int occlusionSamples = 0; ///< rays a point; 0 = as the live picture
};

/// What the user has chosen.
StillQuality stillQuality(const Preferences& preferences);

/// The Renderer's options; what is as the live picture is left to the exported scene and camera.
QStringList rendererOptions(const StillQuality& quality);

} // namespace gui
