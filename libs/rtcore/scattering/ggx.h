/// Microfacets with the GGX distribution of normals (Walter et al. 2007), masked as Smith has it with the
/// heights of light and viewer correlated (Heitz 2014). The formulas are in ggx-inl.h.
#pragma once

namespace rtcore {

/// Of alpha, the square of the roughness: below, a surface is a mirror, and single precision ends.
inline constexpr float kMinAlpha = 1e-3F;

/// Of the viewer with the normal; lower ones, which smooth normals bring about, are lifted.
inline constexpr float kMinViewerCosine = 1e-3F;

} // namespace rtcore
