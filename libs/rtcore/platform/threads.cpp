#include "rtcore/platform/threads.h"

#ifdef _OPENMP
#include <omp.h>
#endif

namespace rtcore {

#ifdef _OPENMP

int threadsFor(int wanted) { return wanted > 0 ? wanted : omp_get_max_threads(); }
int threadNumber() { return omp_get_thread_num(); }

#else

int threadsFor(int /*wanted*/) { return 1; }
int threadNumber() { return 0; }

#endif

} // namespace rtcore
