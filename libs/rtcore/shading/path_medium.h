/// The medium that a path is in.
#pragma once

#include "rtcore/shading/paths/path_queue.h"
#include "rtcore/shading/surface/medium.h"

namespace rtcore {

/// The path goes on in the solid, or in air (null); `media` as of Path.
inline void enterMedium(const Material* solid, MediaList media, Path& path) {
    path.extinction = solid != nullptr ? extinctionOf(*solid) : Colour{};
    path.inside = solid != nullptr;
    path.media = media;
}

} // namespace rtcore
