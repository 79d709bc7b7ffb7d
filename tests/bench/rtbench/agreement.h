/// Whether two tracers found the same.
#pragma once

#include "bench/rtbench/wave_runner.h"

#include <cstddef>
#include <vector>

namespace rtbench {

/// Rays on which two tracers differ: one hits and one does not, or distances differ by more than 1e-4 of the
/// larger.
std::size_t countDifferences(const RayTest& test, const std::vector<WaveAnswer>& a,
                             const std::vector<WaveAnswer>& b);

/// More than rounding at edges explains.
inline bool areMany(std::size_t differences, std::size_t rays) { return differences > 10 + rays / 1000; }

} // namespace rtbench
