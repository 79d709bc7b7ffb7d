/// Microfacets with the GGX distribution of normals (Walter et al. 2007), masked as Smith has it with the
/// heights of light and viewer correlated (Heitz 2014). The formulas are in ggx-inl.h.
#pragma once

namespace rtcore {

/// Lower bound of alpha, the square of the roughness: below, a surface is a mirror, and single precision
/// ends.
inline constexpr float kMinAlpha = 1e-3F;

/// Lower bound of the cosine between viewer and normal; lower ones, due to smooth normals, are lifted.
inline constexpr float kMinViewerCosine = 1e-3F;

} // namespace rtcore
