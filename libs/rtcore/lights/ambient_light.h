/// The ambient light that ambient occlusion darkens in corners.
#pragma once

#include "rtcore/math/box.h"
#include "rtcore/scene/scene.h"
#include "rtcore/settings/render_settings.h"

namespace rtcore {

struct OccludedLight {
    Colour radiance;    ///< from every direction in which nothing is near
    float distance = 1; ///< > 0, scene units: from there on a surface takes nothing away
};

/// By the settings, else by what the scene has (docs/shading.md). `bounds`: of the mesh; may be empty.
OccludedLight occludedLight(const Scene& scene, const Box3& bounds, const AmbientOcclusionSettings& settings);

/// Ambient light that reaches every surface as it is: the scene's, unless ambient occlusion or the light of
/// the sky replaces it.
inline Colour unoccludedAmbient(const Scene& scene, const RenderSettings& settings) {
    return settings.ambientOcclusion.on || settings.skyLight.on ? Colour{} : scene.ambient;
}

} // namespace rtcore
