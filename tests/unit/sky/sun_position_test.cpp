#include "rtcore/sky/sun_position.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace {

using rtcore::Sky;
using rtcore::SunDate;
using rtcore::Vec3;
using rtcore::Vec3d;

constexpr double kDegrees = 180 / std::numbers::pi;

struct Published {
    SunDate when;
    double azimuth, zenith; ///< degrees; the azimuth from north by east
};

/// Without refraction at any height: the angle between the two directions.
double angleTo(const Published& published) {
    const double azimuth = published.azimuth / kDegrees, zenith = published.zenith / kDegrees;
    const Vec3d expected{std::sin(zenith) * std::sin(azimuth), std::sin(zenith) * std::cos(azimuth),
                         std::cos(zenith)};
    const Vec3d difference = rtcore::sunFromPlace(published.when) - expected;
    return 2 * std::asin(length(difference) / 2) * kDegrees;
}

constexpr SunDate at(int year, int month, int day, int hour, int minute, double latitude, double longitude) {
    return {year, month, day, hour * 3600 + minute * 60, 0, latitude, longitude};
}

double greatestError(std::initializer_list<Published> all) {
    double max = 0;
    for (const Published& each : all) {
        const double angle = angleTo(each);
        EXPECT_LT(angle, 0.1) << each.when.year << '-' << each.when.month << ' ' << each.when.second << " at "
                              << each.when.latitude << ' ' << each.when.longitude;
        max = std::max(max, angle);
    }
    return max;
}

// Reda & Andreas, "Solar Position Algorithm for Solar Radiation Applications", NREL/TP-560-34302, appendix
// A.5: the example; 0.014 degrees of its zenith are refraction.
TEST(SunPosition, IsThatOfTheExampleOfNrel) {
    EXPECT_LT(
        angleTo({{2003, 10, 17, 12 * 3600 + 30 * 60 + 30, -7, 39.742476, -105.1786}, 194.34024, 50.11162}),
        0.1);
}

// "elevation" (without refraction) and "azimuth" that pvlib-python and SolarPosition.jl test their SPA with
// (pvlib/tests/test_solarposition and SolarPosition.jl/test/positioning/expected-values.jl): both poles, the
// equator, both sides of the date line, a leap day, two zones, 1800 and 2200.
TEST(SunPosition, AgreesWithWhatPvlibPublishes) {
    const double max = greatestError({
        {at(2020, 10, 17, 13, 30, 45, 10), 220.57399178806656, 90 - 26.455948571468227},
        {{2020, 10, 17, 13 * 3600 + 41 * 60 + 15, 0, 45, 10}, 223.2768724766246, 90 - 25.12441296301344},
        {{2020, 10, 17, 12 * 3600 + 30 * 60, 2, 45, 10}, 169.37672109975506, 90 - 34.922498574899585},
        {{2020, 10, 17, 12 * 3600 + 15 * 60, -2, 45, 10}, 230.96347247948168, 90 - 20.74420312851419},
        {at(2020, 2, 29, 13, 30, 45, 10), 214.6114263307121, 90 - 31.08683938023712},
        {at(2020, 10, 17, 13, 30, 90, 10), 216.19074528320496, 90 + 9.5456839602064},
        {at(2020, 10, 17, 13, 30, 0, 10), 254.10737562125826, 90 - 52.73759177190358},
        {at(2020, 10, 17, 13, 30, -90, 10), 323.80925471679507, 90 - 9.54086519703321},
        {at(2020, 10, 17, 13, 30, -45, 10), 307.4210449579527, 90 - 42.84261705177315},
        {at(2020, 10, 17, 13, 30, 45, -15), 193.4334594288829, 90 - 34.5274132443181},
        {at(2020, 10, 17, 13, 30, 45, -180), 40.562355799089744, 90 + 47.985785528824024},
        {at(2020, 10, 17, 13, 30, 45, 180), 40.562355799089744, 90 + 47.985785528824024},
        {at(1800, 10, 17, 13, 30, 45, 10), 220.65088785484784, 90 - 26.692500595497417},
        {at(2200, 10, 17, 13, 30, 45, 10), 220.66595638829207, 90 - 26.66829803970434},
        {at(2020, 10, 17, 3, 45, 45, 10), 82.37325703265446, 90 + 20.79195338462451},
        {{2020, 10, 17, 5 * 3600 + 48 * 60 + 45, 0, 45, 10}, 104.31771244299773, 90 - 0.8939296259501727},
    });
    EXPECT_LT(max, 0.02);
}

// Azimuth and zenith by NREL's own spa.c, in the test data of klausbrunner/solarpositioning
// (src/test/resources/azimuth_zenith/spa_reference_testdata.csv); their zeniths have refraction where the sun
// is up, which is below 0.1 degrees for those taken here. Auckland, Brasilia, Longyearbyen, Singapore.
TEST(SunPosition, AgreesWithTheReferenceProgramOfNrel) {
    const double max = greatestError({
        {at(1910, 3, 15, 0, 30, -36.840556, 174.74), 0.188643, 34.269919},
        {at(1910, 12, 15, 12, 30, -36.840556, 174.74), 176.294129, 119.821349},
        {at(2010, 3, 15, 3, 30, -36.840556, 174.74), 299.087594, 53.909325},
        {at(2010, 6, 15, 0, 30, -36.840556, 174.74), 357.723597, 60.142480},
        {at(2010, 9, 15, 21, 30, -36.840556, 174.74), 53.647771, 55.296815},
        {at(2010, 12, 15, 0, 30, -36.840556, 174.74), 346.427128, 13.924050},
        {at(2010, 12, 15, 15, 30, -36.840556, 174.74), 134.756453, 104.517154},
        {at(2010, 3, 15, 15, 30, -15.793889, -47.882778), 350.052467, 13.979658},
        {at(2010, 6, 15, 12, 30, -15.793889, -47.882778), 46.250557, 55.629466},
        {at(2010, 12, 15, 15, 30, -15.793889, -47.882778), 215.325977, 9.278971},
        {at(2010, 3, 15, 3, 30, 1.283333, 103.833333), 97.647061, 26.147108},
        {at(2010, 9, 15, 6, 30, 1.283333, 103.833333), 274.852472, 22.547357},
        {at(2110, 6, 15, 15, 30, -36.840556, 174.74), 94.972053, 137.541022},
        {at(2210, 6, 15, 6, 30, 78.22, 15.65), 107.712232, 62.592222},
        {at(2210, 6, 15, 0, 30, 78.22, 15.65), 21.535085, 77.582427},
        {at(2210, 12, 15, 9, 30, 78.22, 15.65), 160.835207, 102.129355},
    });
    EXPECT_LT(max, 0.09);
}

// Meeus, Astronomical Algorithms, example 25.a: the apparent declination on 1992-10-13 at 0h is -7.78507, the
// zenith of the north pole 90 degrees from it.
TEST(SunPosition, IsThatOfTheExampleOfMeeus) {
    EXPECT_NEAR(std::asin(rtcore::sunFromPlace(at(1992, 10, 13, 0, 0, 90, 0)).z) * kDegrees, -7.78507, 0.001);
}

void expectNear(Vec3 a, Vec3 b) {
    EXPECT_NEAR(a.x, b.x, 1e-6F);
    EXPECT_NEAR(a.y, b.y, 1e-6F);
    EXPECT_NEAR(a.z, b.z, 1e-6F);
}

TEST(SunPosition, TurnsWithNorthAndUp) {
    Sky sky;
    sky.date = at(2020, 10, 17, 13, 30, 45, 10);
    const Vec3d place = rtcore::sunFromPlace(*sky.date);
    const auto east = static_cast<float>(place.x), north = static_cast<float>(place.y),
               above = static_cast<float>(place.z);
    expectNear(sunDirection(sky, {0, 1, 0}), {east, above, -north});
    expectNear(sunDirection(sky, {0, 0, 1}), {east, north, above});
    expectNear(sunDirection(sky, {1, 0, 0}), {above, -east, -north});
    expectNear(sunDirection(sky, {0, -1, 0}), {-east, -above, -north});
    sky.north = 90; // to the right: +x
    expectNear(sunDirection(sky, {0, 1, 0}), {north, above, east});
    expectNear(sunDirection(sky, {0, 0, 1}), {north, -east, above});
}

TEST(SunPosition, IsTheDirectionWhereThereIsNoDate) {
    Sky sky;
    sky.date.reset();
    sky.direction = {0, 3, 4};
    expectNear(sunDirection(sky, {0, 1, 0}), {0, 0.6F, 0.8F});
}

} // namespace
