// A film has one exposure or a smooth one, by what was measured of some of its frames.
#include "common/flights/film_exposure.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace {

using app::FilmExposure;
using app::framesToMeasure;
using app::MeasuredExposure;
using rtcore::FlightCourse;

constexpr rtcore::Vec3 kUp{0, 1, 0};

FlightCourse straight(double seconds) {
    rtcore::Flight flight{.name = "straight", .seconds = seconds, .keys = {{}, {}}};
    flight.keys[1].camera.eye = flight.keys[0].camera.eye + rtcore::Vec3{5, 0, 0};
    return {flight, kUp};
}

FlightCourse turntable(double seconds) {
    rtcore::Flight flight{
        .name = "table", .seconds = seconds, .target = rtcore::Vec3d{}, .turns = 1, .keys = {{}}};
    flight.keys[0].camera.eye = {0, 0, 5};
    return {flight, kUp};
}

std::vector<MeasuredExposure> measured(const FlightCourse& course, int frames,
                                       const std::vector<float>& constants) {
    std::vector<MeasuredExposure> all;
    const std::vector<int> chosen = framesToMeasure(course, frames);
    for (std::size_t i = 0; i < chosen.size(); ++i)
        all.push_back({course.timeOfFrame(chosen[i], 25), constants[i % constants.size()]});
    return all;
}

TEST(FilmExposures, AreMeasuredAllAlongTheFilm) {
    EXPECT_EQ(framesToMeasure(straight(2), 51).size(), 9U);
    EXPECT_EQ(framesToMeasure(straight(2), 51).back(), 50);
    EXPECT_EQ(framesToMeasure(straight(20), 501).size(), 21U);
    EXPECT_EQ(framesToMeasure(straight(80'000), 500'000).size(), 61U);
    EXPECT_EQ(framesToMeasure(straight(80'000), 500'000).back(), 499'999);
    EXPECT_EQ(framesToMeasure(straight(2), 3), (std::vector<int>{0, 1, 2}));
    EXPECT_EQ(framesToMeasure(straight(2), 1), std::vector<int>{0});
    const std::vector<int> around = framesToMeasure(turntable(4), 96);
    EXPECT_EQ(around.size(), 12U);
    EXPECT_EQ(around.back(), 88) << "frame 96 would be the first again";
}

TEST(FilmExposures, OfATurntableIsOne) {
    const FlightCourse course = turntable(4);
    const FilmExposure exposure(measured(course, 100, {1, 4}), course);
    for (int frame = 0; frame < 100; ++frame)
        EXPECT_EQ(exposure.at(course.timeOfFrame(frame, 25)), exposure.at(0)) << frame;
    EXPECT_NEAR(exposure.at(0), 2, 0.05) << "the geometric mean, nearly";
}

TEST(FilmExposures, GoSmoothlyFromDarkToBright) {
    const FlightCourse course = straight(20);
    std::vector<float> constants(21, 0.01F);
    std::fill(constants.begin() + 10, constants.end(), 10.0F);
    const FilmExposure exposure(measured(course, 501, constants), course);
    EXPECT_LT(exposure.at(0), 0.02F);
    EXPECT_GT(exposure.at(20), 5.0F);
    for (double time = 0; time < 20; time += 0.04) {
        const double stops = std::log2(exposure.at(time + 0.04)) - std::log2(exposure.at(time));
        EXPECT_GE(stops, -1e-5) << time;
        EXPECT_LT(stops, 0.25) << time << ": 10 stops in a frame are a jump";
    }
}

TEST(FilmExposures, AreThatOfTheFrameWhereNothingChanges) {
    const FlightCourse course = straight(10);
    const FilmExposure exposure(measured(course, 251, {0.37F}), course);
    for (double time = 0; time < 10; time += 0.5) EXPECT_NEAR(exposure.at(time), 0.37F, 1e-6F);
}

} // namespace
