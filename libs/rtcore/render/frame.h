/// The result of rendering.
#pragma once

#include "rtcore/kernels/ray_statistics.h"
#include "rtcore/render/aovs.h"
#include "rtcore/render/guides.h"
#include "rtcore/render/sample_halves.h"
#include "rtcore/render/seen_point.h"
#include "rtcore/scene/image.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace rtcore {

/// A pixel that was chosen blindly, what was kept of it, and what it is.
struct CheckedPixel {
    float kept, traced;                      ///< luminances
    std::uint8_t keptCovered, tracedCovered; ///< as Frame::covered
};

struct Frame {
    HdrImage radiance; ///< settings.width x settings.height, averaged over the samples of each pixel
    std::vector<std::uint8_t>
        covered; ///< per pixel: 255 where all samples hit geometry, 0 where all saw the background
    /// Per pixel, the part of the background that is seen, where radiance is without it; else empty.
    HdrImage transmitted;
    std::optional<Colour> behind;   ///< the background that effects are to put there; none: it stays hidden
    Aovs aovs;                      ///< empty unless they were asked for
    Guides guides;                  ///< the same
    std::vector<SeenPoint> seen;    ///< per pixel; empty unless they were asked for
    std::vector<SeenMatter> matter; ///< of the same points; empty also where there is no indirect light
    /// Per pixel, the luminance that decides the exposure; at most 0: none does. Empty: that of radiance.
    std::vector<float> metered;
    /// Pixels traced for comparison in a frame that reuses samples: they stand for all of its pixels.
    std::vector<CheckedPixel> checked;
    SampleHalves halves; ///< of radiance; empty but for images by paths that are mixed with a net's
    /// The same view with all light by Whitted's rays and irradiance records (steady_image.h): without noise,
    /// but wrong here and there. Empty but for images by paths that are mixed with it.
    HdrImage steady;
    RayStatistics statistics;

    bool hidesBackground() const { return !transmitted.empty() && !behind; }
};

} // namespace rtcore
