/// The opening of a lens.
#pragma once

#include "rtcore/math/vec.h"
#include "rtcore/sampling/sample_id.h"

#include <vector>

namespace rtcore {

/// The point of the unit disc for one of the unit square: areas keep their ratio, neighbours stay neighbours
/// (Shirley and Chiu 1997).
Vec2 onDisc(SquarePoint point);

/// A disc of radius 1, or the regular polygon inside of it with one corner at (0, 1).
class Aperture {
  public:
    /// `corners` below 3: round.
    void prepare(int corners);
    bool round() const { return corners_.empty(); }
    /// Evenly spread over the opening as the point is over the unit square.
    Vec2 at(SquarePoint point) const;

  private:
    std::vector<Vec2> corners_; ///< empty: round; else the first once more at the end
};

} // namespace rtcore
