/// The lines of a level cut by themselves: exact, without a ray, for small plans that are there at once.
#pragma once

#include "rtcore/scene/scene.h"
#include "rtcore/sections/closed_pieces.h"
#include "rtcore/sections/cut_plane.h"

#include <atomic>
#include <vector>

namespace rtcore {

/// In scene units, to the right and up as seen from above. The first point of a line that closes is its last,
/// too.
struct LevelOutline {
    CutPlane plane; ///< of the positions, wherever the model is cut
    std::vector<FlatLoop> solids =
        {}; ///< outlines of what is cut of closed parts, anticlockwise; holes clockwise
    std::vector<FlatLoop> lines = {}; ///< along which open parts are cut
    std::vector<FlatLoop> light = {}; ///< the same of further cuts, which may lie on those
    FlatPoint low{}, high{};          ///< bounds of all that is there; equal where there is nothing

    bool empty() const { return solids.empty() && lines.empty() && light.empty(); }
};

/// A storey by the height of its floor (Storey): cut 1.2 m above, as a plan is (PlanChoice), and once more
/// 0.3 m above, by light lines: parapets, steps and furniture. The scene's sections do not count, nor do
/// hidden parts. `bounds` and `pieces` are of its model. By the calling thread but for threads of OpenMP, of
/// no use once `cancel` is set.
LevelOutline outlineOfStorey(const Scene& scene, const Box3& bounds, double floor, ClosedPieces& pieces,
                             const std::atomic<bool>& cancel);

/// Of a model without storeys: its contour lines at six heights, one like the other, all of them light.
LevelOutline contourLines(const Scene& scene, const Box3& bounds, ClosedPieces& pieces,
                          const std::atomic<bool>& cancel);

/// A line of fewer points, from which those that are left out are `tolerance` away at most; the ends stay.
/// Empty where nothing but a point is left. (D. Douglas, T. Peucker 1973)
FlatLoop simplified(const FlatLoop& line, double tolerance);

} // namespace rtcore
