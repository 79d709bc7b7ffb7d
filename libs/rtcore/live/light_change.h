/// How far an edit of lights reaches.
#pragma once

#include "rtcore/math/vec.h"
#include "rtcore/scene/light.h"

#include <span>
#include <vector>

namespace rtcore {

/// The lights that differ between two states of a scene's, as they were and as they are.
class LightChange {
  public:
    /// The lists may differ in length: missing lights count as switched off.
    LightChange(std::span<const Light> before, std::span<const Light> now);

    bool any() const { return !changed_.empty(); }
    /// Whether such radiance of a surface at `position` may have changed: were nothing between it and the
    /// lights, they would bring or have brought more than a thousandth of it. Of area lights always.
    bool reaches(Vec3 position, float radiance) const;

  private:
    void add(const Light& light);

    std::vector<Light> changed_; ///< that shine
    bool everywhere_ = false;    ///< one of them is an area light
};

} // namespace rtcore
