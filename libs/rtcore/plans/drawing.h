/// A drawing to scale: where a plane cuts a model, and what is seen of it beyond.
#pragma once

#include "rtcore/sections/cut_plane.h"
#include "rtcore/sections/section_caps.h"

#include <optional>
#include <vector>

namespace rtcore {

/// What is free between cut solids and surfaces, and nowhere leads outside.
struct RoomArea {
    FlatLoop outline;              ///< anticlockwise
    std::vector<FlatLoop> islands; ///< of what stands in it
    double area = 0;               ///< square metres, without the islands
    FlatPoint label{};             ///< inside of it, far from its outline
};

/// All in metres, to the right and up as seen from the side that was taken away.
struct Drawing {
    std::vector<FlatLoop> solids; ///< outlines of what is cut of closed parts, anticlockwise; holes clockwise
    std::vector<FlatLoop> loops;  ///< lines along which open parts are cut, those that close
    std::vector<FlatLoop> chains; ///< and those that have two ends
    std::vector<FlatLine> seen;   ///< visible edges of what is beyond the plane
    std::vector<RoomArea> rooms;  ///< the largest first
    std::optional<double> north;  ///< radians from up to the right; of plans from above under a sky alone
    FlatPoint low{}, high{};      ///< bounds of all that is there; equal where there is nothing

    bool empty() const { return solids.empty() && loops.empty() && chains.empty() && seen.empty(); }
};

} // namespace rtcore
