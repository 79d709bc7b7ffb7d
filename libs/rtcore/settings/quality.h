/// How much work an image may be, as one choice in place of several settings: THE table of qualities.
#pragma once

#include "rtcore/settings/settings_table.h"

#include <array>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace rtcore {

/// Draft: few rays, while one looks for a view. Good: as settings are by default. Final: for what is kept.
enum class Quality { Draft, Good, Final };

/// By Quality.
inline constexpr std::array<std::string_view, 3> kQualityNames{"draft", "good", "final"};

/// One setting and what it is in each quality.
struct QualityRow {
    std::string_view setting;
    std::array<std::string_view, kQualityNames.size()> values; ///< by Quality, as settingText() writes them

    std::string_view of(Quality quality) const { return values.at(static_cast<std::size_t>(quality)); }
};

/// All rows. What is switched on or off, and how light becomes an image, is no matter of quality.
std::span<const QualityRow> qualityTable();

/// Nothing where none has that name.
std::optional<Quality> qualityNamed(std::string_view name);

std::vector<SettingAssignment> settingsOf(Quality quality);

/// The one whose values the settings have; nothing where they are none's.
std::optional<Quality> qualityOf(const RenderSettings& settings);

} // namespace rtcore
