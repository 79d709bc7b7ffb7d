/// How far people in browsers may turn up what is dear, and what they may not change at all.
#pragma once

#include "rtcore/settings/settings_table.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace bridge {

struct SettingCap {
    std::string_view name;
    double most;
};
inline constexpr std::array<SettingCap, 7> kCaps{{{"antialiasing", 4},
                                                  {"maxDepth", 64},
                                                  {"ambientOcclusion.samples", 256},
                                                  {"skyLight.samples", 256},
                                                  {"fog.shafts", 64},
                                                  {"areaLights.samples", 64},
                                                  {"bloom.radius", 256}}};

/// The least of the table's maximum and the cap.
inline double mostOf(const rtcore::Setting& setting) {
    const auto* const cap = std::ranges::find(kCaps, setting.name, &SettingCap::name);
    return cap == kCaps.end() ? setting.maximum : std::min(cap->most, setting.maximum);
}

/// Settings of stills, and those that requests of their own change, are no rows for pages.
inline bool isOffered(const rtcore::Setting& setting) {
    return setting.stillChoice.empty() && setting.group != "path" && setting.name != "width" &&
           setting.name != "height";
}

struct Limits {
    std::int64_t maxPixels = 1920 * 1080;
    std::vector<std::string> locked; ///< names of settings, or "edits"

    bool isLocked(std::string_view name) const { return std::ranges::find(locked, name) != locked.end(); }
};

} // namespace bridge
