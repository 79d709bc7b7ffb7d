#include "rtcore/io/text/sun_date.h"

#include <fmt/core.h>

#include <charconv>
#include <cmath>

namespace rtcore {

namespace {

std::optional<int> digits(std::string_view text) {
    int value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size() || text.front() == '-') return std::nullopt;
    return value;
}

} // namespace

std::optional<SunDate> calendarDateOf(std::string_view text) {
    constexpr std::size_t kLength = 10; // yyyy-mm-dd
    if (text.size() != kLength || text[4] != '-' || text[7] != '-') return std::nullopt;
    const auto year = digits(text.substr(0, 4)), month = digits(text.substr(5, 2)),
               day = digits(text.substr(8, 2));
    if (!year || !month || !day || *year < 1800 || *year > 2200 || *month < 1 || *month > 12)
        return std::nullopt;
    if (*day < 1 || *day > daysOfMonth(*year, *month)) return std::nullopt;
    SunDate date;
    date.year = *year;
    date.month = *month;
    date.day = *day;
    return date;
}

std::string calendarDateText(const SunDate& date) {
    return fmt::format("{:04}-{:02}-{:02}", date.year, date.month, date.day);
}

int secondOfHour(double hour) { return static_cast<int>(std::lround(hour * 3600)); }

} // namespace rtcore
