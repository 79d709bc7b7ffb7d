/// One number over time, through keys, that never goes beyond two neighbours between them.
#pragma once

#include <span>
#include <vector>

namespace rtcore {

/// A cubic whose slopes make it monotone where its keys are (Fritsch and Carlson: Monotone Piecewise Cubic
/// Interpolation, SIAM J. Numer. Anal. 17, 1980, by the harmonic means of Fritsch and Butland, 1984). It is
/// at rest at both ends, or goes round without a break. By the four operations on doubles alone.
class MonotoneTrack {
  public:
    /// Times do not fall; of keys of one time the last counts. At least one key, as many values. `periodic`:
    /// the last key is the first one again, and the track goes on as it began, as far off as the two values
    /// are.
    MonotoneTrack(std::span<const double> times, std::span<const double> values, bool periodic = false);

    /// Clamped to the first and the last key; exactly the value of a key at its time.
    double at(double time) const;

  private:
    struct Key {
        double time, value, slope;
    };
    std::vector<Key> keys_;
};

} // namespace rtcore
