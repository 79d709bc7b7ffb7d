#include "common/settings/image_texts.h"

#include "common/cli/help_text.h"

#include <string>

namespace app {

std::vector<rtcore::ImageText> imageTexts(rtcore::Integrator integrator, int samples) {
    return {{"Software", "rtsuite " + suiteVersion()},
            {"integrator", integrator == rtcore::Integrator::Path ? "path" : "whitted"},
            {"samples", std::to_string(samples)}};
}

std::vector<rtcore::ImageText> imageTexts(const rtcore::RenderSettings& settings) {
    const bool paths = settings.integrator == rtcore::Integrator::Path;
    return imageTexts(settings.integrator,
                      paths ? settings.path.samples : settings.antialiasing * settings.antialiasing);
}

} // namespace app
