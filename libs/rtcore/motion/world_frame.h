/// Between a scene's coordinates and the player's: metres, z upwards, y ahead at a heading of zero.
#pragma once

#include "rtcore/math/box.h"
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

/// For models that do not say: the first of metre, centimetre, inch and millimetre at which the model is
/// between 3 and 100 m tall; where none fits, such that it is 3 m tall (if it is flat, 30 m wide). Always > 0
/// and finite.
double guessMetresPerUnit(const Box3& bounds, Vec3 up);

} // namespace rtcore
