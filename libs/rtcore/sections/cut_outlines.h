/// The lines along which a plane cuts the parts of a model.
#pragma once

#include "rtcore/scene/part_list.h"
#include "rtcore/sections/closed_pieces.h"
#include "rtcore/sections/cut_plane.h"

#include <cstdint>
#include <vector>

namespace rtcore {

/// Of one part: of its closed pieces, or of what is open. The closed ones wind once around a point inside of
/// a solid whose faces look outwards, to the left as seen from where the plane's normal points, and not at
/// all around one in a hollow; -1 times where faces look inwards.
struct CutOutline {
    std::uint32_t range = 0;    ///< number in ClosedPieces::ranges()
    std::uint32_t material = 0; ///< that along which the longest lines lie
    bool closed = false;        ///< the pieces are
    std::vector<FlatLoop> loops;
    std::vector<FlatLoop> chains; ///< lines with two ends; none of closed pieces
};

/// Exact but for the rounding of doubles; a point on an edge has the same bits for all triangles around.
/// Those of triangles that are not hidden, where they lie on both sides of the plane: what lies in it is
/// below.
std::vector<CutOutline> cutOutlines(const Model& model, const HiddenParts& hidden, const CutPlane& plane,
                                    ClosedPieces& pieces);

/// What a line encloses; below 0 where it runs clockwise.
double areaOf(const FlatLoop& loop);

} // namespace rtcore
