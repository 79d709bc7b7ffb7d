/// Light that fog along a wave of rays scatters from one light, without shadows.
#pragma once

#include "rtcore/scene/light.h"
#include "rtcore/shading/fog/fog_wave.h"

namespace rtcore {

/// Adds the light's radiance, unshadowed, to fog.rays().scattered: single scattering, the same to all sides.
///
/// Directional lights in closed form. Others, from their middle, by the integral of density * e^-tau / r^2
/// over the ray, where tau counts both ways; with t = tp + h sinh(q), h the light's distance from the ray
/// and tp its foot, dt / r^2 = dq / r, which is smooth, by Gauss-Legendre quadrature on either side of tp
/// (4 to 12 nodes each). h is at least the light's radius (half of what a rectangle measures), and 1e-4 of
/// its distance. (Kulla and Fajardo 2012 have the same substitution but for the angle in place of q.)
/// Rays that fall into ever thicker fog have a third stretch at their end. The error is below 1e-5 of
/// density * integral, or of 1 where that is less.
void addFogLight(const FogWave& fog, const Light& light);

} // namespace rtcore
