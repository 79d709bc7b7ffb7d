/// How far an edit of lights reaches.
#pragma once

#include "rtcore/math/vec.h"
#include "rtcore/scene/light.h"

#include <span>
#include <vector>

namespace rtcore {

/// The lights that differ between two states of a scene, before and after.
class LightChange {
  public:
    /// The lists may differ in length: missing lights count as switched off.
    LightChange(std::span<const Light> before, std::span<const Light> now);

    bool any() const { return !changed_.empty(); }
    /// Whether this radiance of a surface at `position` may have changed: without occlusion, the lights' old
    /// or new contribution exceeds a thousandth of it. Always true with area lights.
    bool reaches(Vec3 position, float radiance) const;

  private:
    void add(const Light& light);

    std::vector<Light> changed_; ///< that shine
    bool everywhere_ = false;    ///< one of them is an area light
};

} // namespace rtcore
