/// Geometric means over scenes of the medians over their views.
#pragma once

#include "bench/rtbench/figures.h"

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace rtbench {

/// Of the positive values that `ratios` gives; of the views of one scene the median counts. Nothing when
/// there is none.
std::optional<double> geometricMean(std::span<const SceneFigures> scenes,
                                    const std::function<std::vector<double>(const SceneFigures&)>& ratios);

/// Our speed over Embree's best mode, or over its best robust one.
std::optional<double> meanRatio(std::span<const SceneFigures> scenes, const RayTest& test, bool robust);

/// Embree's time for a frame over ours.
std::optional<double> meanFrameRatio(std::span<const SceneFigures> scenes, const std::string& kind,
                                     int threads);

/// What frames were rendered: kind and threads, in order, each once.
std::vector<std::pair<std::string, int>> frameKinds(std::span<const SceneFigures> scenes);

} // namespace rtbench
