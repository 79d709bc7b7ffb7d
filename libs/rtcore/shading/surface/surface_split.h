/// How the light at a surface divides: mirrored, let through, or scattered by the Phong lobes.
#pragma once

#include "rtcore/settings/render_settings.h"
#include "rtcore/shading/surface/surface.h"

namespace rtcore {

struct SurfaceSplit {
    Colour mirrored;    ///< weight of the mirror ray
    Colour transmitted; ///< weight of the ray that goes on behind the surface
    Colour scattered;   ///< factor on diffuse and glossy reflection
};

/// SurfaceSplit::mirrored of an opaque material; `cosine` between viewer and normal, at least 0.
Colour mirroredOf(const Material& material, float cosine);

SurfaceSplit splitLight(const Surface& s, const RenderSettings& settings);

} // namespace rtcore
