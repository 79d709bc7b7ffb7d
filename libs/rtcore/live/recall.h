/// Finds what the frame before knew of a point. (Reprojection: Nehab et al. 2007, "Accelerating Real-Time
/// Shading with Reverse Reprojection Caching"; samples that keep their position: Walter, Drettakis and Parker
/// 1999, "Interactive Rendering using the Render Cache")
#pragma once

#include "rtcore/live/live_points.h"

namespace rtcore {

/// A point of the present frame, as the past may have seen it.
struct Asked {
    Vec3 position;   ///< of a far point: its direction
    Vec3 normal;     ///< unit, on the side of the viewer
    float depth = 0; ///< as in LivePoint
};

/// Gives `point` the light of that point of `past` which lies nearest to it on the same surface, at most
/// about a pixel away, with where it is from. False: there is none, and `point` is as it was.
bool recallLight(const LiveImage& past, const Asked& asked, LivePoint& point);

/// Whether the past saw that surface where the point would have been.
bool wasSeen(const LiveImage& past, const Asked& asked);

} // namespace rtcore
