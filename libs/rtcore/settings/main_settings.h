/// The few settings that most people change, which panels show before all others.
#pragma once

#include <span>
#include <string_view>

namespace rtcore {

struct MainSetting {
    std::string_view name;  ///< of the table
    std::string_view label; ///< outside of its group, in English
};

/// In the order in which they are shown.
std::span<const MainSetting> mainSettings();

/// Null where it is none of them.
const MainSetting* findMainSetting(std::string_view name);

} // namespace rtcore
