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
    double least = -rtcore::kUnlimited;
};
inline constexpr std::array<SettingCap, 8> kCaps{{{"antialiasing", 4},
                                                  {"maxDepth", 64},
                                                  // Else bounces by mirrors and glass double without end.
                                                  {"minContribution", 1, 0.001},
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

/// The larger of the table's minimum and the cap.
inline double leastOf(const rtcore::Setting& setting) {
    const auto* const cap = std::ranges::find(kCaps, setting.name, &SettingCap::name);
    return cap == kCaps.end() ? setting.minimum : std::max(cap->least, setting.minimum);
}

inline constexpr std::size_t kMostLights = 64; ///< no page adds one beyond them

struct Limits {
    std::int64_t maxPixels = 1920 * 1080;
    std::vector<std::string> locked; ///< names of settings, or "edits"

    bool isLocked(std::string_view name) const { return std::ranges::find(locked, name) != locked.end(); }
};

} // namespace bridge
