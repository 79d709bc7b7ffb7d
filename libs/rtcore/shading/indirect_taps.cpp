#include "rtcore/shading/indirect_taps.h"

#include "rtcore/math/constants.h"
#include "rtcore/shading/surface/scattered_light.h"

#include <algorithm>
#include <cmath>

namespace rtcore {

Colour IndirectTap::light(Colour irradiance) const { return factor * irradiance / kPi; }

void IndirectTaps::add(const MaterialTable& materials, const Wave& wave, const TapRules& rules) {
    const SurfaceWave& surfaces = wave.surfaces;
    for (std::size_t i = 0; i < wave.size(); ++i) {
        if (surfaces.traits[i] == 0) continue;
        Colour factor = scatteredOf(materials, surfaces, i);
        if (!(maxComponent(factor) > 0)) continue;
        const NarrowLobe lobe = narrowLobeOf(materials, surfaces, i, rules.minLobe);
        if (!isBlack(lobe.albedo)) {
            addLobeTaps(materials, wave, i, lobe, rules.lobeRays, lobes);
            factor = {std::max(factor.r - lobe.albedo.r, 0.0F), std::max(factor.g - lobe.albedo.g, 0.0F),
                      std::max(factor.b - lobe.albedo.b, 0.0F)};
            if (!(maxComponent(factor) > rules.minLobe)) continue;
        }
        const float before = wave.paths.primary() ? 0 : std::fabs(wave.paths.queue()->length[i]);
        matte.push_back({{surfaces.position.at(i), surfaces.geometricNormal.at(i),
                          surfaces.shadingNormal.at(i), rules.pixel.at(before + wave.hits.t[i])},
                         factor,
                         wave.paths.sample(i),
                         false});
    }
}

} // namespace rtcore
