/// Clues to a model's up axis and kind in its triangles.
#pragma once

#include "rtcore/scene/mesh.h"

namespace rtcore {

/// Numbers of one axis, as if it were up.
struct AxisShape {
    float low = 0, high = 0;  ///< where the model begins and ends; scene units
    double footprint = 0;     ///< area of the box across the axis
    double base = 0, lid = 0; ///< area of flat pieces that face down at its very bottom, up at its very top;
                              ///< of `footprint`
    double floor = 0, roof = 0; ///< largest flat piece that faces up in the lower half, down in the upper
                                ///< half; of `footprint`
    double asymmetry = 0;       ///< 0..1: how much of the surface has no counterpart at the mirrored height
    double centroid = 0.5;      ///< of the surface, 0 at the bottom, 1 at the top

    float extent() const { return high - low; }
};

struct ModelShape {
    AxisShape axes[3];
    double boxy = 0; ///< 0..1: share of the surface that is at right angles to an axis
};

/// Looks at a sample of at most some hundred thousand triangles: the same for the same mesh.
ModelShape shapeOf(const Mesh& mesh);

} // namespace rtcore
