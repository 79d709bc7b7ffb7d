#include "common/threads.h"

#include "common/command_line.h"

#include <cstdlib>

namespace app {

int threadCount(std::optional<long long> asked) {
    if (asked && *asked > 0) return static_cast<int>(*asked);
    const char* granted = std::getenv("SLURM_CPUS_PER_TASK");
    if (granted == nullptr || std::getenv("OMP_NUM_THREADS") != nullptr) return 0;
    const std::optional<std::int64_t> count = parseInteger(granted);
    return count && *count > 0 && *count <= 1024 ? static_cast<int>(*count) : 0;
}

} // namespace app
