/// The background seen by rays that leave the scene, which also lights it.
#pragma once

#include "rtcore/scene/scene.h"

namespace rtcore {

/// The scene's environment (an image or the map of a sky), or a radiance that is the same from everywhere. A
/// view: the scene must outlive it. Copies are cheap; safe from many threads.
struct BackgroundLight {
    const Environment* environment = nullptr;
    Colour even; ///< radiance where there is no environment
    TexelFilter filter = TexelFilter::Bilinear;

    /// `direction`: finite, not zero.
    Colour radiance(Vec3 direction) const {
        return environment != nullptr ? environment->radiance(direction, filter) : even;
    }
    /// Mean over all directions.
    Colour mean() const { return environment != nullptr ? environment->meanRadiance() : even; }
};

/// The scene's environment, else its background. `instead`: radiance of a scene with neither; for scattered
/// rays the ambient light, which cameras do not see.
inline BackgroundLight backgroundLight(const Scene& scene, TexelFilter filter, Colour instead = {}) {
    const Environment* const environment = scene.environment();
    return {environment, isBlack(scene.background) ? instead : scene.background, filter};
}

} // namespace rtcore
