/// The figures for programs.
#pragma once

#include "bench/rtbench/figures.h"

#include <span>
#include <string>

namespace rtbench {

/// {"scenes": [{"name", "triangles", "rays": {"primary": {"ours", "embree", "mode", "ratio", "ratioRobust",
/// "spread"}, ...}}], "geomean": {"primary": ..., ...}, "geomeanRobust": {...}}; speeds in Mrays/s. Without
/// Embree its values are null and the means empty. When frames were rendered also "frames": {"scenes":
/// [{"name", "phong": {"1": {"ours", "oursMedian", "embree", "embreeMedian", "ratio", "fps"}, ...},
/// "mirrors": ...}], "geomean": {"phong": {"1": ...}, ...}} with the number of threads as key and times in
/// milliseconds.
std::string jsonReport(std::span<const SceneFigures> scenes);

} // namespace rtbench
