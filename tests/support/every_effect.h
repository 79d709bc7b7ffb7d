/// Settings with every effect on.
#pragma once

#include "rtcore/settings/render_settings.h"
#include "rtcore/settings/settings_table.h"

#include <string_view>
#include <vector>

namespace test {

inline rtcore::RenderSettings everyEffect(int width, int height) {
    rtcore::RenderSettings settings;
    settings.width = width;
    settings.height = height;
    settings.antialiasing = 2;
    settings.sampling = rtcore::SamplingPattern::Poisson;
    settings.adaptive = 0.05F;
    settings.ambientOcclusion = {.on = true, .samples = 5};
    settings.depthOfField = {.on = true, .fNumber = 2, .blades = 6};
    settings.fog.shafts = 2;
    settings.areaLights.samples = 2;
    settings.denoise.passes = 3;
    settings.bloom.radius = 2;
    settings.bloom.kernel = rtcore::BloomKernel::Airy;
    settings.exposure.local = 0.5F;
    // False colours stand in place of all this.
    settings.falseColours.isolines = settings.falseColours.legend = false;
    return settings;
}

/// One setting is as if the effect were not wanted: a switch is off, another as by default.
struct WithoutEffect {
    std::string_view setting;
    rtcore::RenderSettings settings;
};

/// `all` without each effect in turn: each switch that is on, and each other setting that is not its default.
inline std::vector<WithoutEffect> withoutEachEffect(const rtcore::RenderSettings& all) {
    std::vector<WithoutEffect> result;
    for (const rtcore::Setting& setting : rtcore::settingsTable()) {
        if (setting.name == "width" || setting.name == "height" || setting.name == "antialiasing") continue;
        if (setting.integrator && *setting.integrator != all.integrator) continue;
        const bool isSwitch = setting.type == rtcore::SettingType::Boolean;
        const rtcore::SettingValue off = isSwitch ? rtcore::SettingValue(false) : setting.defaultValue;
        if (setting.get(all) == off) continue;
        result.push_back({setting.name, all});
        rtcore::setSetting(result.back().settings, setting.name, off);
    }
    return result;
}

} // namespace test
