/// The scene that indirect light was learned of, told by two numbers.
#pragma once

#include "rtcore/math/box.h"
#include "rtcore/scene/scene.h"
#include "rtcore/settings/render_settings.h"

#include <cstdint>

namespace rtcore {

struct LightKey {
    std::uint64_t surfaces = 0; ///< where they are: triangles, but those of hidden parts, and the bounds
    std::uint64_t light = 0;    ///< all else that decides how bright they are
    Box3 bounds;                ///< RayTracer::bounds()

    friend bool operator==(const LightKey&, const LightKey&) = default;
};

/// Reads all of the model and of the environment: some 0.2 s for each GB. A plane that cuts the model is not
/// part of it. Of the settings only those count that IndirectLight uses; the camera and names do not.
LightKey lightKeyOf(const Scene& scene, const Box3& bounds, const RenderSettings& settings);

} // namespace rtcore
