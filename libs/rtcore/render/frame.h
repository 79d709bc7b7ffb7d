/// What rendering leaves behind.
#pragma once

#include "rtcore/kernels/ray_statistics.h"
#include "rtcore/render/layers.h"
#include "rtcore/scene/image.h"

#include <cstdint>
#include <vector>

namespace rtcore {

struct Frame {
    HdrImage radiance; ///< settings.width x settings.height, averaged over the samples of each pixel
    std::vector<std::uint8_t>
        covered;        ///< per pixel: 255 where all samples hit geometry, 0 where all saw the background
    FrameLayers layers; ///< empty unless they were asked for
    RayStatistics statistics;
};

} // namespace rtcore
