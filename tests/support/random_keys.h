/// Keys that a child would press, for the player in walk-through mode.
#pragma once

#include "rtcore/motion/walker.h"
#include "support/random_numbers.h"

#include <cmath>
#include <cstddef>

namespace test {

/// In [0, 1].
inline double fraction(Random& random) { return double{random.number(0, 1)}; }

class RandomKeys {
  public:
    explicit RandomKeys(Random& random) : random_(random) {}

    /// The keys of the next step.
    rtcore::WalkInput next() {
        if (random_.index(20) == 0) angle_ = 6.28 * fraction(random_);
        angle_ += 0.02 * (fraction(random_) - 0.5);
        toggle(input_.jump, 15);
        toggle(input_.crouch, 60);
        toggle(input_.crawl, 60);
        toggle(input_.sprint, 20);
        if (random_.index(25) == 0) input_.forward = static_cast<double>(random_.index(3)) - 1;
        if (random_.index(25) == 0) input_.right = static_cast<double>(random_.index(3)) - 1;
        if (random_.index(30) == 0) input_.forward = 1;
        input_.ahead = {std::sin(angle_), std::cos(angle_), 0};
        return input_;
    }

  private:
    void toggle(bool& key, std::size_t every) {
        if (random_.index(every) == 0) key = !key;
    }
    Random& random_;
    rtcore::WalkInput input_;
    double angle_ = 0;
};

} // namespace test
