/// Traits of an integrator's images, whatever renders them.
#pragma once

#include "rtcore/settings/render_settings.h"

namespace rtcore {

struct IntegratorTraits {
    Integrator integrator;
    /// All light is sampled at random, by path.samples for each pixel: there is noise everywhere. Else there
    /// are antialiasing x antialiasing samples, or fewer (RenderSettings::adaptive), and only soft light is
    /// sampled.
    bool samplesAllLight;
};

inline constexpr IntegratorTraits kIntegratorTraits[] = {
    {.integrator = Integrator::Whitted, .samplesAllLight = false},
    {.integrator = Integrator::Path, .samplesAllLight = true},
};

constexpr const IntegratorTraits& traitsOf(Integrator integrator) {
    switch (integrator) {
    case Integrator::Path:
        return kIntegratorTraits[1];
    case Integrator::Whitted:
        break;
    }
    return kIntegratorTraits[0];
}

/// The maximum for an image of those settings; RenderSettings::adaptive may take fewer.
inline int samplesPerPixel(const RenderSettings& settings) {
    return traitsOf(settings.integrator).samplesAllLight ? settings.path.samples
                                                         : settings.antialiasing * settings.antialiasing;
}

} // namespace rtcore
