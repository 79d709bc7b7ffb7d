/// How the exposure follows the image's brightness in time, as an eye does. (thesis 3.2)
#pragma once

#include <optional>

namespace rtserver {

/// Seconds in which the distance that is left falls to 1/e; 0: at once. The last of it is gone sooner: the
/// exposure changes by 12 % in a second at least, or by 5 % in such a time where that is less.
struct AdaptationSpeed {
    double brighter = 0; ///< where the image became brighter: the exposure grows
    double darker = 0;
};

/// One thread. The first target is taken at once; later ones are neared in the logarithm.
class Adaptation {
  public:
    /// The exposure `seconds` after the last call, on the way to `target` > 0. Near enough it is the target
    /// itself, to the bit, and stays there.
    float advance(float target, double seconds, const AdaptationSpeed& speed);
    /// To `target` at once.
    void jump(float target);
    bool settled() const { return settled_; }
    float value() const { return value_.value_or(1); }

  private:
    std::optional<float> value_;
    bool settled_ = true;
};

} // namespace rtserver
