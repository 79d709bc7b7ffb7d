#include "rtcore/settings/main_settings.h"

#include <algorithm>
#include <iterator>

namespace rtcore {

namespace {

constexpr MainSetting kMain[]{{"exposure.mode", "Exposure"},
                              {"exposure.key", "Brightness"},
                              {"shadows", "Shadows"},
                              {"reflections", "Reflections"},
                              {"indirect.mode", "Indirect light"},
                              {"ambientOcclusion.on", "Ambient occlusion"},
                              {"skyLight.on", "Sky light"},
                              {"depthOfField.on", "Depth of field"},
                              {"bloom.radius", "Bloom"},
                              {"falseColours.on", "False colours"}};

} // namespace

std::span<const MainSetting> mainSettings() { return kMain; }

const MainSetting* findMainSetting(std::string_view name) {
    const auto found = std::ranges::find(kMain, name, &MainSetting::name);
    return found == std::end(kMain) ? nullptr : found;
}

} // namespace rtcore
