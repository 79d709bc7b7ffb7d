/// Processor time of one thread.
#pragma once

#include <ctime>

namespace app {

/// Seconds that the calling thread has had the processor so far.
inline double threadSeconds() {
    timespec time{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

} // namespace app
