#include "rtcore/shading/normal_sums.h"

#include <algorithm>

namespace rtcore {

void NormalSums::add(const Wave& wave) {
    const SurfaceWave& surfaces = wave.surfaces;
    for (std::size_t i = 0; i < surfaces.size(); ++i) {
        if (surfaces.traits[i] == 0) continue;
        const float scattered = std::clamp(luminance(surfaces.weight.colourAt(i)), 0.0F, 1.0F);
        sums_[wave.paths.sample(i)] += surfaces.shadingNormal.at(i) * scattered;
    }
}

} // namespace rtcore
