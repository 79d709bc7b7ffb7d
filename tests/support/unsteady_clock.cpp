/// Sets the wall clock of a program by an hour, to and fro, right after each time that it was read: a library
/// to be loaded before all others (LD_PRELOAD). A wait until a computed wall time takes an hour, or no time
/// at all. The kernel, which the steady clock and all sleeping belong to, does not notice.
#include <atomic>

#include <dlfcn.h>
#include <sys/time.h>
#include <time.h>

namespace {

long shift() {
    static std::atomic<unsigned> readings{0};
    return readings++ % 2 == 0 ? 3600 : -3600;
}

bool isWallClock(clockid_t clock) { return clock == CLOCK_REALTIME || clock == CLOCK_REALTIME_COARSE; }

template <class Function>
Function next(const char* name) {
    return reinterpret_cast<Function>(::dlsym(RTLD_NEXT, name));
}

} // namespace

extern "C" {

int clock_gettime(clockid_t clock, timespec* now) noexcept {
    static const auto real = next<int (*)(clockid_t, timespec*)>("clock_gettime");
    const int result = real(clock, now);
    if (result == 0 && isWallClock(clock)) now->tv_sec += shift();
    return result;
}

int gettimeofday(timeval* now, void*) noexcept {
    timespec time{};
    const int result = clock_gettime(CLOCK_REALTIME, &time);
    now->tv_sec = time.tv_sec;
    now->tv_usec = time.tv_nsec / 1000;
    return result;
}

time_t time(time_t* now) noexcept {
    timespec wall{};
    clock_gettime(CLOCK_REALTIME, &wall);
    if (now != nullptr) *now = wall.tv_sec;
    return wall.tv_sec;
}

} // extern "C"
