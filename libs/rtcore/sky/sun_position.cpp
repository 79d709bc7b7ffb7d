#include "rtcore/sky/sun_position.h"

#include "rtcore/simd/portable_math.h"

#include <cmath>

namespace rtcore {

namespace {

/// From 2000-01-01 to the date, of the Gregorian calendar; the year begins in March.
int daysSince2000(int year, int month, int day) {
    const int y = month <= 2 ? year - 1 : year;
    const int m = month <= 2 ? month + 9 : month - 3;
    return 365 * y + y / 4 - y / 100 + y / 400 + (153 * m + 2) / 5 + day - 1 - 730425;
}

double sinOf(double degrees) { return portableSinOfDegrees(degrees); }
double cosOf(double degrees) { return portableCosOfDegrees(degrees); }

} // namespace

Vec3d sunFromPlace(const SunDate& date) {
    // From noon of 2000-01-01, universal time, which the sun's orbit takes for terrestrial time.
    const double days =
        daysSince2000(date.year, date.month, date.day) - 0.5 + (date.second - date.timeZone * 3600) / 86400;
    const double t = days / 36525;
    const double meanLongitude = 280.46646 + t * (36000.76983 + t * 0.0003032);
    const double anomaly = 357.52911 + t * (35999.05029 - t * 0.0001537);
    const double centre = (1.914602 - t * (0.004817 + t * 0.000014)) * sinOf(anomaly) +
                          (0.019993 - t * 0.000101) * sinOf(2 * anomaly) + 0.000289 * sinOf(3 * anomaly);
    const double node = 125.04 - 1934.136 * t;
    const double nutation = -0.00478 * sinOf(node);
    const double longitude = meanLongitude + centre - 0.00569 + nutation;
    const double obliquity = 23.439291 - 0.0130042 * t + 0.00256 * cosOf(node);
    const Vec3d equatorial{cosOf(longitude), cosOf(obliquity) * sinOf(longitude),
                           sinOf(obliquity) * sinOf(longitude)};

    const double sidereal = 280.46061837 + 360.98564736629 * days + nutation * cosOf(obliquity);
    const double s = sinOf(sidereal + date.longitude), c = cosOf(sidereal + date.longitude);
    const double meridian = equatorial.x * c + equatorial.y * s;
    const double sinLatitude = sinOf(date.latitude), cosLatitude = cosOf(date.latitude);
    return {equatorial.y * c - equatorial.x * s, equatorial.z * cosLatitude - meridian * sinLatitude,
            meridian * cosLatitude + equatorial.z * sinLatitude};
}

Vec3 sunDirection(const Sky& sky, Vec3 up) {
    if (!sky.date) return normalize(sky.direction);
    const Vec3d above{up.x, up.y, up.z};
    const Vec3d ahead = up.z == 0 ? Vec3d{0, 0, -1} : Vec3d{0, 1, 0};
    const Vec3d right = cross(ahead, above);
    const double s = sinOf(sky.north), c = cosOf(sky.north);
    const Vec3d north = ahead * c + right * s, east = right * c - ahead * s;
    const Vec3d sun = sunFromPlace(*sky.date);
    const Vec3d direction = normalize(east * sun.x + north * sun.y + above * sun.z);
    return {static_cast<float>(direction.x), static_cast<float>(direction.y),
            static_cast<float>(direction.z)};
}

} // namespace rtcore
