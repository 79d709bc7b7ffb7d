/// The sums of what primary rays see, ray i for sample i.
#pragma once

#include "rtcore/math/colour.h"
#include "rtcore/shading/surface_wave.h"

namespace rtcore {

/// Begins the sum of each sample: `background` where the ray missed, else zero; and sets surfaces.share to 1.
void startSums(Colour background, SurfaceWave& surfaces, const ArraysOf3& radiance);

/// radiance += surfaces.added, sample by sample.
void addToSums(const SurfaceWave& surfaces, const ArraysOf3& radiance);

} // namespace rtcore
