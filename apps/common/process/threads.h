/// How many threads a program uses when the user does not say.
#pragma once

#include <optional>
#include <string>

namespace app {

/// `asked` when given and not 0; else what a batch system grants the job (SLURM_CPUS_PER_TASK) unless
/// OMP_NUM_THREADS is set; else 0: all cores, or OMP_NUM_THREADS.
int threadCount(std::optional<long long> asked);

/// Parallel code that is told no number uses `threads` from now on; 0 changes nothing.
void useThreads(int threads);

/// Lets threads that wait for each other sleep soon: those that spin use up, beside other programs, the time
/// that they are granted. What the environment asks for (OMP_WAIT_POLICY, GOMP_SPINCOUNT) stays. GNU's OpenMP
/// reads it before main() does anything, so the program is started anew in this process, with `argv`: call it
/// before all else. Nothing where that fails, or without OpenMP.
void spinLittle(char** argv) noexcept;

/// Lets threads that come and go share the allocator's memory, where each would leave an arena of its own
/// behind. Call it before the first thread. Nothing where the system has no such switch.
void shareMemoryAmongThreads() noexcept;

} // namespace app
