/// How far people in browsers may turn up what is dear, and what they may not change at all.
#pragma once

#include "rtcore/settings/settings_table.h"

#include <algorithm>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace bridge {

inline double maxOf(const rtcore::Setting& setting) {
    return std::min(setting.browser.maximum, setting.maximum);
}
inline double minOf(const rtcore::Setting& setting) {
    return std::max(setting.browser.minimum, setting.minimum);
}

inline constexpr std::size_t kMaxLights = 64; ///< no page adds one beyond them

/// Beyond so many notes of a scene those who only look add none.
inline constexpr std::size_t kMaxVisitorNotes = 500;
/// Bytes of a message of a page: the longest note (rtcore::kMaxNoteBytes) has room in one, however it is
/// escaped.
inline constexpr std::size_t kMaxPageMessage = 8192;

struct Limits {
    std::int64_t maxPixels = 1920 * 1080;
    std::vector<std::string> locked; ///< names of settings, or "edits"
    bool visitorNotes = false;       ///< all pages may add notes, those that only look with a name

    bool isLocked(std::string_view name) const { return std::ranges::find(locked, name) != locked.end(); }
};

} // namespace bridge
