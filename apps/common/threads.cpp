#include "common/threads.h"

#include "common/command_line.h"

#include <cstdlib>

#ifdef _OPENMP
#include <omp.h>
#endif

namespace app {

int threadCount(std::optional<long long> asked) {
    if (asked && *asked > 0) return static_cast<int>(*asked);
    const char* granted = std::getenv("SLURM_CPUS_PER_TASK");
    if (granted == nullptr || std::getenv("OMP_NUM_THREADS") != nullptr) return 0;
    const std::optional<std::int64_t> count = parseInteger(granted);
    return count && *count > 0 && *count <= 1024 ? static_cast<int>(*count) : 0;
}

void useThreads(int threads) {
#ifdef _OPENMP
    if (threads > 0) omp_set_num_threads(threads);
#else
    static_cast<void>(threads);
#endif
}

} // namespace app
