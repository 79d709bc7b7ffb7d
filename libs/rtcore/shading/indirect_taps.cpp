#include "rtcore/shading/indirect_taps.h"

#include "rtcore/math/constants.h"
#include "rtcore/shading/surface/scattered_light.h"

#include <cmath>

namespace rtcore {

Colour IndirectTap::light(Colour irradiance) const { return factor * irradiance / kPi; }

void addTaps(const MaterialTable& materials, const Wave& wave, const PixelSize& pixel,
             std::vector<IndirectTap>& taps) {
    const SurfaceWave& surfaces = wave.surfaces;
    for (std::size_t i = 0; i < wave.size(); ++i) {
        if (surfaces.traits[i] == 0) continue;
        const Colour factor = scatteredOf(materials, surfaces, i);
        if (!(maxComponent(factor) > 0)) continue;
        const float before = wave.paths.primary() ? 0 : std::fabs(wave.paths.queue()->length[i]);
        taps.push_back({{surfaces.position.at(i), surfaces.geometricNormal.at(i),
                         surfaces.shadingNormal.at(i), pixel.at(before + wave.hits.t[i])},
                        factor,
                        wave.paths.sample(i),
                        false});
    }
}

} // namespace rtcore
