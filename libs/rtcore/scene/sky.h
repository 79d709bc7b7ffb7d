/// A clear sky as a scene describes it: where its sun stands, and through what air it shines; or the walls of
/// a studio in its place.
#pragma once

#include "rtcore/math/vec.h"

#include <optional>

namespace rtcore {

/// A moment and a place, from which the sun's position follows (sky/sun_position.h). Gregorian calendar.
struct SunDate {
    int year = 2026, month = 6, day = 21; ///< 1800..2200; 1..12; 1..daysOfMonth()
    int second = 12 * 3600;               ///< of the day on the clock there, 0..86400
    double timeZone = 0;                  ///< what that clock is ahead of universal time, hours, -15..15
    double latitude = 45;                 ///< degrees, north positive, -90..90
    double longitude = 0;                 ///< degrees, east positive, -180..180

    friend bool operator==(const SunDate&, const SunDate&) = default;
};

/// Below it the model of the sky has no meaning; above it there is no clear sky.
inline constexpr double kMinTurbidity = 2, kMaxTurbidity = 10;

struct Sky {
    std::optional<SunDate> date = SunDate{}; ///< absent: the sun stands where `direction` points to
    Vec3 direction{1, 2, 1}; ///< to the sun, in the scene; not zero, need not be of unit length
    float north = 0;         ///< degrees from straight ahead (-z; +y where up is along z) to the right
    float turbidity = 3;     ///< of the air: 2 very clear, 3 clear, 6 hazy, 10 thick
    float strength = 1;      ///< factor on sun and sky, or on the studio, >= 0
    bool ground = false;     ///< the ground below it takes the shadow of the model (scene/sky_ground.h)
    bool haze = false;       ///< white at the horizon, into which a light ground fades
    /// White walls and floor without corners below a dark ceiling, and no sun: of all above, only `strength`
    /// and `ground` count.
    bool studio = false;

    friend bool operator==(const Sky&, const Sky&) = default;
};

/// How many days the month has.
constexpr int daysOfMonth(int year, int month) {
    const bool leap = (year % 4 == 0 && year % 100 != 0) || year % 400 == 0;
    if (month == 2) return leap ? 29 : 28;
    return month == 4 || month == 6 || month == 9 || month == 11 ? 30 : 31;
}

} // namespace rtcore
