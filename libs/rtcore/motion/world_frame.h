/// Between a scene's coordinates and the player's: metres, z upwards, y ahead at a heading of zero.
#pragma once

#include "rtcore/math/vec.h"

namespace rtcore {

class WorldFrame {
  public:
    /// `up` need not be of unit length, only finite and not zero (else +Y); `metresPerUnit` > 0.
    WorldFrame(Vec3 up, double metresPerUnit);

    Vec3d toMetres(Vec3 p) const;
    Vec3 toScene(Vec3d p) const;
    /// Directions keep their length.
    Vec3d turn(Vec3 d) const;
    Vec3 turnBack(Vec3d d) const;

    double metresPerUnit() const { return scale_; }
    Vec3 up() const { return turnBack({0, 0, 1}); }

  private:
    Vec3d right_, ahead_, up_;
    double scale_;
};

} // namespace rtcore
