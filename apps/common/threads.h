/// How many threads a program uses when the user does not say.
#pragma once

#include <optional>
#include <string>

namespace app {

/// `asked` when given and not 0; else what a batch system grants the job (SLURM_CPUS_PER_TASK) unless
/// OMP_NUM_THREADS is set; else 0: all cores, or OMP_NUM_THREADS.
int threadCount(std::optional<long long> asked);

} // namespace app
