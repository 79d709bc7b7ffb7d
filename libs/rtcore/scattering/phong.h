/// The physical Phong model: radiance = albedo terms times irradiance, so that lights in W/sr and surfaces of
/// any shininess agree in brightness, and no surface reflects more than it gets (Lafortune and Willems 1994).
/// The formulas are in phong-inl.h.
#pragma once

namespace rtcore {

/// Below this exponent cos^n ends in a step, at right angles to the mirrored light: a fraction 1 - n of the
/// glossy light is then scattered by the rough lobe, the rest by the lobe of this exponent.
inline constexpr float kMinShininess = 1;

/// Keeps the rough lobe finite where light and viewer graze the surface.
inline constexpr float kMinCosines = 1e-18F;

} // namespace rtcore
