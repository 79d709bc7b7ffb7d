#include "common/cli/threads_option.h"

#include "common/process/threads.h"

namespace app {

Option threadsOption() {
    return {.name = "threads",
            .value = ValueKind::Integer,
            .argument = "N",
            .help = "use N threads; 0 is all cores; the results are the same for every number [0]",
            .more = "Without it `OMP_NUM_THREADS` is heeded, and what a Slurm job was granted "
                    "(`SLURM_CPUS_PER_TASK`)",
            .minimum = 0,
            .maximum = 1024};
}

int threadsOf(const Arguments& arguments) { return threadCount(arguments.integer("threads")); }

} // namespace app
