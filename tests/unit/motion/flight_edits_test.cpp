// Flights get another timing, are stretched and trimmed, and recordings become flights.
#include "rtcore/motion/flight_edits.h"

#include "rtcore/motion/flight_course.h"
#include "rtcore/motion/flight_thinning.h"
#include "rtcore/platform/sentence.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace {

using rtcore::Camera;
using rtcore::Flight;
using rtcore::FlightCourse;
using rtcore::FlightTiming;
using rtcore::TimedView;
using rtcore::Vec3;

constexpr Vec3 kUpwards{0, 0, 1};

Camera looking(Vec3 eye, float yaw) {
    return {.eye = eye, .forward = {-std::sin(yaw), std::cos(yaw), 0}, .up = kUpwards};
}

Flight bentFlight() {
    Flight flight{.name = "bent", .seconds = 10};
    flight.keys = {{.camera = looking({0, 0, 1}, 0)},
                   {.camera = looking({0, 5, 1}, 0.5F)},
                   {.camera = looking({5, 9, 1}, 1)}};
    return flight;
}

TEST(FlightEdits, ATimingComesThroughTheSameKeysAtTheSameTimes) {
    const Flight even = bentFlight(), timed = retimed(even, FlightTiming::Times, kUpwards);
    const FlightCourse before(even, kUpwards), after(timed, kUpwards);
    ASSERT_EQ(timed.keys.size(), 3U);
    EXPECT_FALSE(problemOf(timed));
    EXPECT_NEAR(after.seconds(), 10, 1e-12);
    for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(timed.keys[i].time, before.timeOf(i));
    EXPECT_EQ(retimed(timed, FlightTiming::Even, kUpwards), even);
    EXPECT_EQ(retimed(even, FlightTiming::Even, kUpwards), even);
}

TEST(FlightEdits, WhatIsClosedComesBackByTimesToo) {
    Flight closed = bentFlight();
    closed.closed = true;
    const Flight timed = retimed(closed, FlightTiming::Times, kUpwards);
    ASSERT_EQ(timed.keys.size(), 4U);
    EXPECT_EQ(timed.keys[3].camera, timed.keys[0].camera);
    EXPECT_EQ(timed.keys[3].time, 10);
    EXPECT_FALSE(problemOf(timed));
}

TEST(FlightEdits, ATurntableByTimesIsAsRound) {
    Flight table{.name = "round", .seconds = 12, .target = rtcore::Vec3d{1, 0, 0}, .turns = 1};
    table.keys = {{.camera = looking({1, -4, 1}, 0)}};
    const Flight timed = retimed(table, FlightTiming::Times, kUpwards);
    ASSERT_EQ(timed.keys.size(), 13U);
    EXPECT_FALSE(problemOf(timed));
    const FlightCourse course(timed, kUpwards);
    for (int i = 0; i <= 120; ++i) {
        const Vec3 eye = course.at(i * 0.1).camera.eye;
        EXPECT_NEAR(std::hypot(eye.x - 1, eye.y), 4, 0.02) << i;
    }
}

TEST(FlightEdits, StretchTimes) {
    Flight timed = retimed(bentFlight(), FlightTiming::Times, kUpwards);
    const double second = timed.keys[1].time;
    timed = lasting(timed, 20);
    EXPECT_EQ(secondsOf(timed), 20);
    EXPECT_NEAR(timed.keys[1].time, 2 * second, 1e-12);
    EXPECT_EQ(secondsOf(lasting(bentFlight(), 3)), 3);
}

TEST(FlightEdits, TrimToWhatIsBetween) {
    const Flight timed = retimed(bentFlight(), FlightTiming::Times, kUpwards);
    const FlightCourse whole(timed, kUpwards);
    const Flight part = trimmed(timed, 2, 9, kUpwards);
    ASSERT_EQ(part.keys.size(), 3U);
    EXPECT_EQ(part.keys[0].camera, whole.at(2).camera);
    EXPECT_EQ(part.keys[2].camera, whole.at(9).camera);
    EXPECT_EQ(part.keys[0].time, 0);
    EXPECT_EQ(part.keys[2].time, 7);
    EXPECT_FALSE(problemOf(part));
    Flight table{.name = "round", .seconds = 12, .target = rtcore::Vec3d{1, 0, 0}, .turns = 1};
    table.keys = {{.camera = looking({1, -4, 1}, 0)}};
    const Flight half = trimmed(table, 0, 6, kUpwards);
    EXPECT_FALSE(problemOf(half));
    EXPECT_EQ(half.turns, 0);
    EXPECT_EQ(half.seconds, 6);
    EXPECT_EQ(half.keys.size(), 7U);
}

/// A walk that trembles by a millimetre, at 30 views a second.
std::vector<TimedView> recording(std::size_t count) {
    std::mt19937 random(7);
    std::uniform_real_distribution<float> tremble(-0.001F, 0.001F);
    std::vector<TimedView> views;
    for (std::size_t i = 0; i < count; ++i) {
        const float t = static_cast<float>(i) / 30;
        const Vec3 eye{3 * std::sin(t / 2) + tremble(random), t + tremble(random), 1.7F + tremble(random)};
        views.push_back({looking(eye, std::sin(t / 3)), double{t} + 5});
    }
    return views;
}

TEST(FlightThinning, HoldsARecordingByFewKeyFrames) {
    const std::vector<TimedView> views = recording(600);
    Flight flight{.name = "walk", .timing = FlightTiming::Times};
    flight.keys = rtcore::thinned(views, 0.05, 1, kUpwards);
    EXPECT_FALSE(problemOf(flight));
    EXPECT_LT(flight.keys.size(), 60U);
    EXPECT_GT(flight.keys.size(), 4U);
    const FlightCourse course(flight, kUpwards);
    for (const TimedView& view : views) {
        const Camera camera = course.at(view.time - 5).camera;
        EXPECT_LE(length(camera.eye - view.camera.eye), 0.0501F);
        EXPECT_GE(dot(camera.forward, view.camera.forward), std::cos(1.01F / 57.2957795F));
    }
}

TEST(FlightThinning, TakesOddRecordings) {
    const Camera camera = looking({1, 2, 3}, 0);
    EXPECT_EQ(rtcore::thinned(std::vector<TimedView>{{camera, 3}}, 0.05, 1, kUpwards).size(), 1U);
    EXPECT_EQ(rtcore::thinned(std::vector<TimedView>{{camera, 3}, {camera, 3}}, 0.05, 1, kUpwards).size(),
              1U);
    EXPECT_EQ(
        rtcore::thinned(std::vector<TimedView>{{camera, 3}, {camera, 2}, {camera, 4}}, 0.05, 1, kUpwards)
            .size(),
        2U);
    EXPECT_THROW(rtcore::thinned(recording(3000), 1e-5, 1, kUpwards), rtcore::BadValue);
}

} // namespace
