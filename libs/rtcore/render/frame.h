/// The result of rendering.
#pragma once

#include "rtcore/kernels/ray_statistics.h"
#include "rtcore/render/aovs.h"
#include "rtcore/render/seen_point.h"
#include "rtcore/scene/image.h"

#include <cstdint>
#include <vector>

namespace rtcore {

struct Frame {
    HdrImage radiance; ///< settings.width x settings.height, averaged over the samples of each pixel
    std::vector<std::uint8_t>
        covered; ///< per pixel: 255 where all samples hit geometry, 0 where all saw the background
    Aovs aovs;   ///< empty unless they were asked for
    std::vector<SeenPoint> seen; ///< per pixel; empty unless they were asked for
    RayStatistics statistics;
};

} // namespace rtcore
