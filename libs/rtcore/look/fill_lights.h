/// Lights by which a scene stands in for light that surfaces send to each other.
#pragma once

#include "rtcore/scene/scene.h"

#include <vector>

namespace rtcore {

/// Those that are on and say so by their names, as "fill light west" or "bounce" do: where indirect light is
/// rendered, they count twice. Not one that is called "fill": studios have it beside that light. Pointers
/// into scene.lights.
std::vector<const SceneLight*> fillLights(const Scene& scene);

} // namespace rtcore
