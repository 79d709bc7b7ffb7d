/// The figures as text.
#pragma once

#include "bench/rtbench/figures.h"

#include <span>
#include <string>

namespace rtbench {

/// One view of a scene: a line for each kind of rays, then one for each kind of frame. With `modes` also a
/// line for each mode of Embree.
std::string sceneTable(const SceneFigures& scene, bool modes);

/// The geometric means; empty when there is nothing to compare.
std::string meansTable(std::span<const SceneFigures> scenes);

} // namespace rtbench
