/// Traces waves with one or several threads, each with memory of its own that it keeps.
#pragma once

#include "bench/rtbench/ray_sets.h"

#include "rtcore/kernels/ray_tracer.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace rtbench {

/// The answers to a wave: `hits`, or `occluded` for kinds of rays that ask no more.
struct WaveAnswer {
    rtcore::HitWave hits;
    std::vector<std::uint8_t> occluded;
};

class WaveRunner {
  public:
    WaveRunner(const RayTest& test, int threads);

    /// Answers are overwritten by each next wave of the same thread. Throws what the tracer throws.
    void run(const rtcore::RayTracer& tracer, std::span<const rtcore::RayWave> waves);
    /// One answer, kept.
    void run(const rtcore::RayTracer& tracer, const rtcore::RayWave& wave, WaveAnswer& answer) const;

  private:
    const RayTest& test_;
    std::vector<WaveAnswer> answers_; ///< of each thread
};

} // namespace rtbench
