/// Geometric means over scenes.
#pragma once

#include "bench/rtbench/figures.h"

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace rtbench {

/// How the views of a scene are averaged.
enum class OfViews { Mean, Median };

/// The mean of the positive values that `ratios` gives; the views of one scene together count as one scene.
/// Nothing when there are none.
std::optional<double> geometricMean(std::span<const SceneFigures> scenes,
                                    const std::function<std::vector<double>(const SceneFigures&)>& ratios,
                                    OfViews ofViews = OfViews::Mean);

/// Our speed over Embree's best mode, or over its best robust one.
std::optional<double> meanRatio(std::span<const SceneFigures> scenes, const RayTest& test, bool robust,
                                OfViews ofViews = OfViews::Mean);

/// Embree's time for a frame over ours.
std::optional<double> meanFrameRatio(std::span<const SceneFigures> scenes, const std::string& kind,
                                     int threads);

/// Kind and threads of the frames that were rendered, in order, each pair once.
std::vector<std::pair<std::string, int>> frameKinds(std::span<const SceneFigures> scenes);

} // namespace rtbench
