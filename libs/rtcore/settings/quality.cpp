#include "rtcore/settings/quality.h"

#include <algorithm>
#include <cstddef>
#include <string>

namespace rtcore {

namespace {

constexpr std::array kQualities{Quality::Draft, Quality::Good, Quality::Final};

constexpr QualityRow kRows[]{
    {"antialiasing", {"1", "1", "3"}},       {"sampling", {"grid", "grid", "rotated"}},
    {"maxDepth", {"3", "5", "8"}},           {"ambientOcclusion.samples", {"4", "9", "25"}},
    {"skyLight.samples", {"6", "16", "36"}}, {"areaLights.samples", {"1", "4", "9"}},
    {"path.samples", {"64", "256", "1024"}},
};

} // namespace

std::span<const QualityRow> qualityTable() { return kRows; }

std::optional<Quality> qualityNamed(std::string_view name) {
    const auto found = std::find(kQualityNames.begin(), kQualityNames.end(), name);
    if (found == kQualityNames.end()) return std::nullopt;
    return static_cast<Quality>(found - kQualityNames.begin());
}

std::vector<SettingAssignment> settingsOf(Quality quality) {
    std::vector<SettingAssignment> settings;
    for (const QualityRow& row : kRows)
        settings.push_back(
            {std::string(row.setting), parseSetting(requireSetting(row.setting), row.of(quality))});
    return settings;
}

std::optional<Quality> qualityOf(const RenderSettings& settings) {
    const auto has = [&](Quality quality) {
        return std::ranges::all_of(settingsOf(quality), [&](const SettingAssignment& each) {
            return getSetting(settings, each.name) == each.value;
        });
    };
    const auto found = std::ranges::find_if(kQualities, has);
    if (found == kQualities.end()) return std::nullopt;
    return *found;
}

} // namespace rtcore
