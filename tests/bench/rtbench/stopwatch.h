/// The time that work takes.
#pragma once

#include <ctime>

namespace rtbench {

/// One thread is measured in its own processor time, which other programs disturb least; several in wall
/// time.
class Stopwatch {
  public:
    explicit Stopwatch(int threads)
        : clock_(threads == 1 ? CLOCK_THREAD_CPUTIME_ID : CLOCK_MONOTONIC), start_(now()) {}

    double seconds() const { return now() - start_; }

  private:
    double now() const {
        timespec time{};
        clock_gettime(clock_, &time);
        return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
    }

    clockid_t clock_;
    double start_;
};

/// The best two of many times.
struct BestTimes {
    double best = 1e30, second = 1e30; ///< seconds

    void add(double seconds) {
        if (seconds < best) {
            second = best;
            best = seconds;
        } else if (seconds < second) {
            second = seconds;
        }
    }
};

} // namespace rtbench
