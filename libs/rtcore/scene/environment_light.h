/// The light that an environment throws on surfaces: a small copy of it, for rays that are few.
#pragma once

#include "rtcore/math/colour.h"
#include "rtcore/math/vec.h"

#include <span>
#include <vector>

namespace rtcore {

/// A small part of all directions, in which the radiance counts as even.
struct EnvironmentCell {
    Vec3 direction;       ///< of its middle, unit
    float solidAngle = 0; ///< steradian
    Colour radiance;
};

/// A copy of side x side texels on an unfolded octahedron (math/octahedron-inl.h): 3 degrees each. Of spots
/// that are brighter than four times the mean of all directions, what exceeds that is spread over a wider
/// cone, of 5 to 80 degrees around them, so that a few rays do not find them in one pixel and miss them in
/// the next. correction() makes up for what a surface gains or loses by that: with nothing in the way its
/// irradiance is that of the environment itself. What is lost are shadows of such spots: theirs are as soft
/// as if they were as large as their cones.
///
/// Immutable; safe from many threads. About 0.1 MB.
class EnvironmentLight {
  public:
    /// The same radiance 1 from everywhere.
    EnvironmentLight();
    /// `cells` together are all directions. Takes some 10^-2 s.
    explicit EnvironmentLight(std::span<const EnvironmentCell> cells);

    /// Texels each way; 1 where the radiance is the same from everywhere.
    int side() const { return side_; }
    /// The spread radiance of each texel: side() x side() values for red, green or blue (0, 1, 2).
    const float* radiance(int channel) const { return radiance_[channel].data(); }

    /// Irradiance over pi of a surface with that unit normal that sees all directions before it.
    Colour open(Vec3 normal) const { return lookUp(open_, normal); }
    /// open(), over the same by the spread radiance: 0 to 2, black where nothing is before it.
    Colour correction(Vec3 normal) const;

  private:
    Colour lookUp(const std::vector<Colour>& byNormal, Vec3 normal) const;

    int side_ = 1;
    std::vector<float> radiance_[3];
    std::vector<Colour> open_, spreadOpen_; ///< by normal
};

} // namespace rtcore
