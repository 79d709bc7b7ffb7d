/// Whether packets of one origin are traced as bundles or one by one.
#pragma once

#include <algorithm>
#include <cstdint>

namespace rtcore {

/// Bundles take half the time where neighbouring rays meet the same triangles, and many times as long where
/// a beam of them meets hundreds: in small images of large models. So now and then both ways are tried in
/// turns, on neighbouring parts of an image, and the one that took less is kept. For one thread.
class BundleChoice {
  public:
    /// Whether to bundle the next packets.
    bool next() const { return bundles_ != (turn_ < kTurns && turn_ % 2 == 1); }

    /// Reports the time of each packet that next() decided. (Without this, next() decides the same again.)
    void learn(double seconds) {
        if (turn_ == kTurns) {
            if (--untilTrial_ == 0) turn_ = 0;
            return;
        }
        sum_[turn_ % 2] += seconds;
        if (++turn_ == kTurns) decide();
    }

  private:
    static constexpr std::uint32_t kTurns = 8;

    void decide() {
        constexpr double kClearly = 0.95, kMax = 8;
        double ratio = sum_[0] > 0 ? sum_[1] / sum_[0] : 1; // a coarse clock may see no time pass
        if (ratio < kClearly) {
            bundles_ = !bundles_;
            ratio = 1 / ratio;
        }
        sum_[0] = sum_[1] = 0;
        // The dearer the other way, the less often: trials take a fiftieth of the time.
        untilTrial_ = static_cast<std::uint32_t>(128 * std::clamp(ratio, 1.0, kMax));
    }

    bool bundles_ = true;          ///< thought to be better
    std::uint32_t turn_ = 0;       ///< of a trial; kTurns: none is under way
    std::uint32_t untilTrial_ = 0; ///< so many more calls of learn()
    double sum_[2] = {};           ///< in this trial: of what is thought better, and of the other
};

} // namespace rtcore
