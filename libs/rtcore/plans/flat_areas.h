/// Areas in a plane: what solids cover together, and what is free between them.
#pragma once

#include "rtcore/plans/drawing.h"
#include "rtcore/sections/cut_outlines.h"

#include <vector>

namespace rtcore {

/// The outline of what closed parts cover together, however they wind, overlap and touch: outer lines run
/// anticlockwise, those of holes clockwise. To a millionth of a millionth of the size of all.
std::vector<FlatLoop> coveredBy(const std::vector<CutOutline>& outlines);

/// Openings that count as closed, in the plane of the wall that they are in.
struct Openings {
    double door;   ///< up to that width between two rooms
    double window; ///< up to that width to the outside
};

/// Bounds of rooms, in the unit of their lines.
struct RoomBounds {
    double area;
    double width; ///< at its widest: what is narrower lies between the skins of a wall
};

/// The rooms between solids and lines: what is left in one piece when all that is nearer to a wall than half
/// of an opening's width is taken off it, and grown again. Those of less than `bounds` are left out, as are
/// such that are narrower than what leads from them outside. A line whose ends are one point is closed.
/// Lengths in one unit, areas in its square; the largest first.
std::vector<RoomArea> roomsBetween(const std::vector<FlatLoop>& solids, const std::vector<FlatLoop>& lines,
                                   Openings openings, RoomBounds bounds);

} // namespace rtcore
