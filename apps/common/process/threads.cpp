#include "common/process/threads.h"

#include <charconv>
#include <cstdlib>
#include <string_view>

#ifdef _OPENMP
#include <omp.h>
#endif

namespace app {

int threadCount(std::optional<long long> asked) {
    if (asked && *asked > 0) return static_cast<int>(*asked);
    const char* granted = std::getenv("SLURM_CPUS_PER_TASK");
    if (granted == nullptr || std::getenv("OMP_NUM_THREADS") != nullptr) return 0;
    const std::string_view text(granted);
    int count = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), count);
    const bool whole = error == std::errc() && end == text.data() + text.size();
    return whole && count > 0 && count <= 1024 ? count : 0;
}

void useThreads(int threads) {
#ifdef _OPENMP
    if (threads > 0) omp_set_num_threads(threads);
#else
    static_cast<void>(threads);
#endif
}

} // namespace app
