/// Loops inside an OpenMP region that one thread has entered.
#pragma once

#include "rtcore/platform/task_errors.h"

#include <cstddef>

namespace rtcore {

/// Calls `work` with all numbers below `count`, by all threads that wait for work, and returns when it is
/// done. Throws what `work` throws.
template <typename Work>
void forEachInTasks(std::size_t count, const Work& work) {
    // GCC's library leaves a loop of more tasks than 64 for each thread to the one that meets it.
    [[maybe_unused]] constexpr int kTasks = 32; // (not without OpenMP)
    TaskErrors errors;
#pragma omp taskloop num_tasks(kTasks) default(shared)
    for (std::size_t i = 0; i < count; ++i) errors.guard([&] { work(i); });
    errors.rethrow();
}

} // namespace rtcore
