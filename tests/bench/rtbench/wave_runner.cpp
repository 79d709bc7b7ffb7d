#include "bench/rtbench/wave_runner.h"

#include "rtcore/platform/task_errors.h"

#ifdef _OPENMP
#include <omp.h>
#endif

namespace rtbench {

WaveRunner::WaveRunner(const RayTest& test, int threads)
    : test_(test), answers_(static_cast<std::size_t>(threads)) {}

void WaveRunner::run(const rtcore::RayTracer& tracer, const rtcore::RayWave& wave, WaveAnswer& answer) const {
    if (test_.anyHit) {
        tracer.occluded(test_.kind, wave, answer.occluded);
    } else {
        tracer.intersect(test_.kind, wave, answer.hits);
    }
}

void WaveRunner::run(const rtcore::RayTracer& tracer, std::span<const rtcore::RayWave> waves) {
    if (answers_.size() == 1) {
        for (const rtcore::RayWave& wave : waves) run(tracer, wave, answers_.front());
        return;
    }
    rtcore::TaskErrors errors;
#ifdef _OPENMP
#pragma omp parallel for schedule(dynamic, 1) num_threads(static_cast <int>(answers_.size()))
#endif
    for (std::size_t i = 0; i < waves.size(); ++i) {
        errors.guard([&] {
#ifdef _OPENMP
            const auto thread = static_cast<std::size_t>(omp_get_thread_num());
#else
            const std::size_t thread = 0;
#endif
            run(tracer, waves[i], answers_[thread]);
        });
    }
    errors.rethrow();
}

} // namespace rtbench
