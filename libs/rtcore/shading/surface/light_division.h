/// How the light at the points of a wave is divided: mirrors take their part, and lobes scatter the rest.
#pragma once

#include "rtcore/shading/surface/metallic_points.h"

namespace rtcore {

/// One for each thread; keeps its memory from wave to wave.
class LightDivision {
  public:
    /// For a wave whose `weight` is that of all light that leaves its points, as yet undivided; those that
    /// are not plain have their own materials already. Afterwards `weight` is that of scattered light,
    /// `specular` that of the mirrored ray of points that then have the trait kSpecular, and the lobes are
    /// complete (lobes-inl.h). Emission is of the undivided light: it has to be found before (emission.h).
    void divide(const LobeTask& task, const SurfaceWave& surfaces);

  private:
    MetallicPoints metallic_;
};

} // namespace rtcore
