/// Attenuation and emission of fog along a ray: the closed forms, one ray at a time. (thesis 5.5 and 7.1.9)
///
/// The optical depth of a stretch is tau = density * length, where `length` counts thin fog less and thick
/// fog more than its distance (the integral of the density relative to `Fog::density`). Light loses all but
/// e^-tau on it, and the fog adds (1 - e^-tau) * source, its own radiance: what it scatters of its
/// surroundings and emits. Light scattered from lights is added by fog_wave.h.
///
/// Pure functions, safe from many threads; the same bits on every processor. Directions of unit length;
/// distances in scene units, kEndless for a ray that meets nothing. Never NaN, whatever the ray.
#pragma once

#include "rtcore/scene/scene.h"
#include "rtcore/settings/render_settings.h"

#include <limits>

namespace rtcore {

inline constexpr float kEndless = std::numeric_limits<float>::max();

/// The scene's fog as rays need it.
struct FogMedium {
    bool on = false;
    bool exponential = false;
    float density = 0;   ///< extinction per scene unit at height 0, > 0
    float perHeight = 0; ///< exponential: 1 / scale height, per scene unit
    Vec3 up;             ///< unit; of exponential fog
    float ground = 0;    ///< height 0 along `up`, scene units
    Colour source;       ///< radiance that an endless ray tends to, without lights
    Colour scattered;    ///< of a light's irradiance, to each direction: albedo / 4 pi, per steradian

    static constexpr float kLowest = -60; ///< scale heights: the density stays the same below
};

FogMedium fogMedium(const Scene& scene, const RenderSettings& settings);

/// Length in scene units of the stretch of fog of density 1 that weakens light as much as this one.
/// Exponential: from the lower end z of the stretch, e^-z d (1 - e^-x) / x, x its rise in scale heights; so
/// it neither overflows on rays from high above nor loses digits on level ones.
float fogLength(const FogMedium& fog, Vec3 origin, Vec3 direction, float distance);

/// Transmittance of the stretch: e^-tau.
float fogTransmittance(const FogMedium& fog, Vec3 origin, Vec3 direction, float distance);

/// Transmittance from a light to `position`. 1 for a directional light in homogeneous fog: its intensity is
/// that which arrives in the scene, since endless fog would absorb it all. In exponential fog it comes from
/// above the fog; from below the horizon nothing arrives.
float fogLightTransmittance(const FogMedium& fog, const Light& light, Vec3 position);

} // namespace rtcore
