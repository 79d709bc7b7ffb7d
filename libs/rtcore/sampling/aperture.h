/// The opening of a lens.
#pragma once

#include "rtcore/math/vec.h"
#include "rtcore/sampling/sample_id.h"

#include <array>
#include <vector>

namespace rtcore {

/// The point of the unit disc for one of the unit square: areas keep their ratio, neighbours stay neighbours
/// (Shirley and Chiu 1997).
Vec2 onDisc(SquarePoint point);

/// What onDisc() is made of, for its counterpart in vector code: an angle of up to 45 degrees, and
/// polynomials of its square for sin(angle) / angle and cos(angle), from the last term to the first; errors
/// below 1e-7.
inline constexpr float kDiscAngle = 0.785398163397F;
inline constexpr std::array<float, 5> kDiscSine{1.0F / 362880, -1.0F / 5040, 1.0F / 120, -1.0F / 6, 1};
inline constexpr std::array<float, 6> kDiscCosine{-1.0F / 3628800, 1.0F / 40320, -1.0F / 720,
                                                  1.0F / 24,       -1.0F / 2,    1};

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
