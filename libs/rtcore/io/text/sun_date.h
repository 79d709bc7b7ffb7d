/// The date of a sky in text: "2026-06-21".
#pragma once

#include "rtcore/scene/sky.h"

#include <optional>
#include <string>
#include <string_view>

namespace rtcore {

/// The day alone; nothing where the text is none between 1800 and 2200.
std::optional<SunDate> calendarDateOf(std::string_view text);
std::string calendarDateText(const SunDate& date);

/// The nearest second of the day; `hour` 0..24.
int secondOfHour(double hour);

} // namespace rtcore
