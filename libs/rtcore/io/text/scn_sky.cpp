#include "rtcore/io/text/scn_sections.h"
#include "rtcore/io/text/sun_date.h"
#include "rtcore/platform/sentence.h"

#include <fmt/core.h>

#include <array>
#include <cmath>

namespace rtcore {

namespace {

constexpr Limits kHour{.minimum = 0, .maximum = 24};
constexpr Limits kTimeZone{.minimum = -15, .maximum = 15};
constexpr Limits kLatitude{.minimum = -90, .maximum = 90};
constexpr Limits kLongitude{.minimum = -180, .maximum = 180};
constexpr Limits kTurbidity{.minimum = kMinTurbidity, .maximum = kMaxTurbidity};
constexpr Limits kNorth{.minimum = -360, .maximum = 360};
constexpr std::array<std::string_view, 5> kDateKeys{"date", "hour", "timeZone", "latitude", "longitude"};

SunDate readDate(StrictTable& table) {
    SunDate date;
    if (const auto text = table.text("date")) {
        const auto day = calendarDateOf(*text);
        if (!day)
            table.fail("date", fmt::format("date is \"{}\", but takes a day from 1800 to 2200 such as "
                                           "\"2026-06-21\"",
                                           *text));
        date.year = day->year;
        date.month = day->month;
        date.day = day->day;
    }
    if (const auto hour = table.preciseNumber("hour", kHour)) date.second = secondOfHour(*hour);
    date.timeZone = table.preciseNumber("timeZone", kTimeZone).value_or(date.timeZone);
    date.latitude = table.preciseNumber("latitude", kLatitude).value_or(date.latitude);
    date.longitude = table.preciseNumber("longitude", kLongitude).value_or(date.longitude);
    return date;
}

} // namespace

Sky readSky(StrictTable& table, const Sky& usual) {
    Sky sky = usual;
    sky.north = table.number("north", kNorth).value_or(sky.north);
    sky.turbidity = table.number("turbidity", kTurbidity).value_or(sky.turbidity);
    sky.strength = table.number("strength", kNotNegative).value_or(sky.strength);
    sky.ground = table.boolean("ground").value_or(sky.ground);
    sky.haze = table.boolean("haze").value_or(sky.haze);
    sky.studio = table.boolean("studio").value_or(sky.studio);
    const SunDate date = readDate(table);
    const auto direction = table.vector("direction");
    table.finish();
    sky.date = date;
    if (!direction) return sky;
    for (const std::string_view key : kDateKeys) {
        if (table.value(key) != nullptr)
            table.fail(key, "direction and " + std::string(key) + " are both given; leave one out");
    }
    if (normalize(*direction) == Vec3{})
        table.fail("direction", say("direction is that to the sun, and not zero"));
    sky.date.reset();
    sky.direction = *direction;
    return sky;
}

void writeSky(TomlWriter& writer, const Sky& sky, std::string_view header) {
    writer.section(header);
    if (sky.date) {
        writer.add("date", calendarDateText(*sky.date));
        writer.add("hour", sky.date->second / 3600.0);
        writer.add("timeZone", sky.date->timeZone);
        writer.add("latitude", sky.date->latitude);
        writer.add("longitude", sky.date->longitude);
        writer.add("north", sky.north);
    } else {
        writer.add("direction", sky.direction);
        writer.add("north", sky.north);
    }
    writer.add("turbidity", sky.turbidity);
    writer.add("strength", sky.strength);
    if (sky.ground) writer.add("ground", true);
    if (sky.haze) writer.add("haze", true);
    if (sky.studio) writer.add("studio", true);
}

} // namespace rtcore
