#include "rtcore/motion/standing_poses.h"

#include <algorithm>
#include <cstddef>

namespace rtcore {

namespace {

constexpr int kTicksBetween = kTicksPerSecond / 2;

} // namespace

void StandingPoses::begin() {
    count_ = 0;
    sinceNoted_ = kTicksBetween;
}

void StandingPoses::note(const WalkState& state) {
    sinceNoted_ = ticksLater(sinceNoted_);
    if (!state.grounded || sinceNoted_ < kTicksBetween) return;
    sinceNoted_ = 0;
    poses_[static_cast<std::size_t>(next_)] = {state.feet, state.height, state.stance};
    next_ = (next_ + 1) % static_cast<int>(poses_.size());
    count_ = std::min(count_ + 1, static_cast<int>(poses_.size()));
}

std::optional<WalkState> StandingPoses::takeLast() {
    if (count_ == 0) return std::nullopt;
    next_ = (next_ + static_cast<int>(poses_.size()) - 1) % static_cast<int>(poses_.size());
    --count_;
    sinceNoted_ = 0;
    const Pose& pose = poses_[static_cast<std::size_t>(next_)];
    WalkState state;
    state.feet = pose.feet;
    state.height = pose.height;
    state.stance = pose.stance;
    return state;
}

} // namespace rtcore
