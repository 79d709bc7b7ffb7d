/// Poses in which a walker stood: it is put back to them after a fall out of the world.
#pragma once

#include "rtcore/motion/walk_state.h"

#include <array>
#include <optional>

namespace rtcore {

/// The last ones, one for each half second at most.
class StandingPoses {
  public:
    /// Forgets all. The next floor that is stood on is a pose to come back to.
    void begin();
    /// Once in each tick.
    void note(const WalkState& state);
    /// The newest one, not moving, which is taken out: after another fall at once an older one is used.
    /// Nothing when there is none left.
    std::optional<WalkState> takeLast();

  private:
    struct Pose {
        Vec3d feet;
        double height = 0;
        Stance stance = Stance::Stand;
    };

    std::array<Pose, 16> poses_{};
    int count_ = 0, next_ = 0;
    int sinceNoted_ = 0; ///< ticks
};

} // namespace rtcore
