#include "common/settings/image_texts.h"

#include "common/cli/help_text.h"

#include "rtcore/settings/integrator_traits.h"
#include "rtcore/settings/settings_table.h"

#include <string>

namespace app {

std::vector<rtcore::ImageText> imageTexts(rtcore::Integrator integrator, int samples) {
    rtcore::RenderSettings settings;
    settings.integrator = integrator;
    return {{"Software", "rtsuite " + suiteVersion()},
            {"integrator", rtcore::settingText(rtcore::getSetting(settings, "integrator"))},
            {"samples", std::to_string(samples)}};
}

std::vector<rtcore::ImageText> imageTexts(const rtcore::RenderSettings& settings) {
    return imageTexts(settings.integrator, rtcore::samplesPerPixel(settings));
}

} // namespace app
