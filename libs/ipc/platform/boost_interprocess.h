/// The only way to include Boost.Interprocess: every file must see the same settings.
#pragma once

// A lock that is not to be had within this time throws instead of hanging (the owner died; before Boost 1.78
// nothing else tells).
#define BOOST_INTERPROCESS_ENABLE_TIMEOUT_WHEN_LOCKING
#define BOOST_INTERPROCESS_TIMEOUT_WHEN_LOCKING_DURATION_MS 100
// To open what its maker never finished would take 300 s.
#define BOOST_INTERPROCESS_MANAGED_OPEN_OR_CREATE_INITIALIZE_TIMEOUT_SEC 1

#include "ipc/platform/rules.h"

#include <boost/interprocess/interprocess_fwd.hpp>
#include <boost/version.hpp>

#include <cerrno>
#include <chrono>
#include <thread>

#include <pthread.h>

namespace ipc {

// Replaces the timed wait of Boost, which uses the wall clock: setting that back would stretch it. A process
// is inside a queue for 50 ns, unless it is stopped there.
inline int lockWithin(pthread_mutex_t* mutex, const timespec* wallClock) {
    if (!keeps("waits for a queue go by the steady clock"))
        return ::pthread_mutex_timedlock(mutex, wallClock);
    const auto deadline = std::chrono::steady_clock::now() +
                          std::chrono::milliseconds(BOOST_INTERPROCESS_TIMEOUT_WHEN_LOCKING_DURATION_MS);
    while (true) {
        const int result = ::pthread_mutex_trylock(mutex);
        if (result != EBUSY) return result;
        if (std::chrono::steady_clock::now() >= deadline) return ETIMEDOUT;
        std::this_thread::yield();
    }
}

} // namespace ipc

#define pthread_mutex_timedlock(mutex, deadline) ::ipc::lockWithin(mutex, deadline)
