/// How well an image at rest is rendered: progressive rendering and quick render.
#pragma once

#include <QStringList>

namespace gui {

class Preferences;

/// What stands beside ambient occlusion for "on or off".
enum class StillOcclusion { AsLive, On, Off };

struct StillQuality {
    int antialiasing = 1; ///< n x n samples per pixel
    int bloom = -1;       ///< pixels; -1 = as the live frame
    StillOcclusion occlusion = StillOcclusion::AsLive;
    int occlusionSamples = 0; ///< rays per point; 0 = as the live frame
};

/// What the user has chosen.
StillQuality stillQuality(const Preferences& preferences);

/// The Renderer's options; what is the same as in the viewport comes with the exported scene and camera.
QStringList rendererOptions(const StillQuality& quality);

} // namespace gui
