// A flight goes through its keys, at one speed or when they say, hardly beyond them, upright, and is the same
// wherever it is computed.
#include "rtcore/motion/flight_course.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace {

using rtcore::Camera;
using rtcore::Flight;
using rtcore::FlightCourse;
using rtcore::FlightTiming;
using rtcore::Vec3;

constexpr Vec3 kUp{0, 0, 1};

double distance(Vec3 a, Vec3 b) { return double{length(a - b)}; }

double degreesBetween(Vec3 a, Vec3 b) {
    return std::atan2(double{length(cross(a, b))}, double{dot(a, b)}) * 57.29577951308232;
}

Camera cameraAt(Vec3 eye, Vec3 forward, Vec3 up = kUp) { return {.eye = eye, .forward = forward, .up = up}; }

/// Keys that neither stand nor turn back.
Flight anyFlight(std::mt19937& random, FlightTiming timing) {
    const auto number = [&](float from, float to) {
        return std::uniform_real_distribution<float>(from, to)(random);
    };
    Flight flight{.name = "any", .timing = timing, .seconds = double{number(1, 60)}};
    const int count = 2 + static_cast<int>(number(0, 6.99F));
    while (static_cast<int>(flight.keys.size()) < count) {
        const Vec3 eye{number(-10, 10), number(-10, 10), number(0, 5)};
        if (!flight.keys.empty() && distance(eye, flight.keys.back().camera.eye) < 0.05) continue;
        if (flight.keys.size() > 1) {
            const Vec3 last = flight.keys.back().camera.eye;
            const Vec3 before = last - flight.keys[flight.keys.size() - 2].camera.eye, after = eye - last;
            if (dot(normalize(before), normalize(after)) < -0.98F) continue;
        }
        Camera camera = cameraAt(eye, {number(-1, 1), number(-1, 1), number(-0.9F, 0.9F)});
        camera.horizontalFov = number(20, 120);
        const double time = flight.keys.empty() ? 0 : flight.keys.back().time + double{number(0.1F, 20)};
        flight.keys.push_back({.camera = camera, .time = timing == FlightTiming::Times ? time : 0});
    }
    return flight;
}

Flight flightOf(std::vector<Camera> cameras, double seconds = 10) {
    Flight flight{.name = "flight", .seconds = seconds};
    for (const Camera& camera : cameras) flight.keys.push_back({.camera = camera});
    return flight;
}

double yawOf(const Camera& camera) {
    return std::atan2(-double{camera.forward.x}, double{camera.forward.y}) * 57.29577951308232;
}

double speedAt(const FlightCourse& course, double time, double step) {
    return distance(course.at(time + step).camera.eye, course.at(time - step).camera.eye) / (2 * step);
}

} // namespace

TEST(FlightCourse, GoesExactlyThroughItsKeysAndUpTo) {
    std::mt19937 random(1);
    for (int i = 0; i < 1000; ++i) {
        const Flight flight = anyFlight(random, i % 2 == 0 ? FlightTiming::Even : FlightTiming::Times);
        const FlightCourse course(flight, kUp);
        for (std::size_t key = 0; key < flight.keys.size(); ++key) {
            const double time = course.timeOf(key);
            if (flight.timing == FlightTiming::Times) {
                ASSERT_EQ(time, flight.keys[key].time);
            }
            const Camera& wanted = flight.keys[key].camera;
            ASSERT_EQ(course.at(time).camera, wanted);
            // And comes from near it: nothing jumps there.
            for (const double near : {time - 1e-6, time + 1e-6}) {
                const Camera camera = course.at(near).camera;
                ASSERT_LT(distance(camera.eye, wanted.eye), 1e-3) << i; // 600 a second at the fastest
                ASSERT_LT(degreesBetween(camera.forward, wanted.forward), 0.01) << i;
                ASSERT_NEAR(camera.horizontalFov, wanted.horizontalFov, 0.01) << i;
            }
        }
        ASSERT_EQ(course.at(-1).camera, flight.keys.front().camera);
        ASSERT_EQ(course.at(1e9).camera, flight.keys.back().camera);
    }
}

TEST(FlightCourse, HasOneSpeedBetweenItsEnds) {
    std::mt19937 random(2);
    for (int i = 0; i < 1000; ++i) {
        const FlightCourse course(anyFlight(random, FlightTiming::Even), kUp);
        const double ease = FlightCourse::kEase * course.seconds(), step = course.seconds() / 400;
        // Along the curve: chords of a bend are shorter, so that steps are small.
        double longest = 0, shortest = 1e30;
        for (int j = 0; j < 40; ++j) {
            const double from = ease + (course.seconds() - 2 * ease - step) * j / 40;
            double way = 0;
            constexpr int kSteps = 32;
            for (int k = 0; k < kSteps; ++k)
                way += distance(course.at(from + step * k / kSteps).camera.eye,
                                course.at(from + step * (k + 1) / kSteps).camera.eye);
            longest = std::max(longest, way);
            shortest = std::min(shortest, way);
        }
        ASSERT_LT(longest, 1.01 * shortest) << i;
        // At the ends it is at rest.
        ASSERT_LT(speedAt(course, 1e-3 * ease, 1e-3 * ease), 0.02 * longest / step) << i;
    }
}

TEST(FlightCourse, GoesHardlyBeyondItsKeys) {
    std::mt19937 random(3);
    for (int i = 0; i < 1000; ++i) {
        const Flight flight = anyFlight(random, i % 2 == 0 ? FlightTiming::Even : FlightTiming::Times);
        const FlightCourse course(flight, kUp);
        for (std::size_t key = 0; key + 1 < flight.keys.size(); ++key) {
            const Vec3 from = flight.keys[key].camera.eye, way = flight.keys[key + 1].camera.eye - from;
            const double begins = course.timeOf(key), lasts = course.timeOf(key + 1) - begins;
            for (int j = 1; j < 100; ++j) {
                const Vec3 eye = course.at(begins + lasts * j / 100).camera.eye;
                const double along = double{dot(eye - from, way) / dot(way, way)};
                ASSERT_GT(along, -0.0201) << i;
                ASSERT_LT(along, 1.0201) << i;
            }
        }
    }
}

TEST(FlightCourse, IsUprightAndTurnsTheShorterWay) {
    std::mt19937 random(4);
    for (int i = 0; i < 200; ++i) {
        const Flight flight = anyFlight(random, FlightTiming::Times);
        const FlightCourse course(flight, kUp);
        for (int j = 0; j <= 200; ++j) {
            const Camera camera = course.at(course.seconds() * j / 200).camera;
            ASSERT_LT(std::fabs(dot(normalize(cross(camera.forward, camera.up)), kUp)), 1e-5F);
        }
    }
    // From 170 degrees to -170 are twenty, by way of 180.
    const auto looking = [](double degrees) {
        const auto radians = static_cast<float>(degrees / 57.29577951308232);
        return cameraAt({0, 0, 1}, {-std::sin(radians), std::cos(radians), 0});
    };
    const FlightCourse course(flightOf({looking(170), looking(-170)}), kUp);
    for (int j = 0; j <= 100; ++j) EXPECT_GE(std::fabs(yawOf(course.at(j * 0.1).camera)), 169.99);
    EXPECT_NEAR(std::fabs(yawOf(course.at(5).camera)), 180, 1e-3);
}

TEST(FlightCourse, RestsWhereTheCameraTurnsOnTheSpotAndWhereItGoesBack) {
    const Flight flight = flightOf({cameraAt({0, 0, 1}, {1, 0, 0}), cameraAt({4, 0, 1}, {1, 0, 0}),
                                    cameraAt({4, 0, 1}, {0, 1, 0}), cameraAt({4, 8, 1}, {0, 1, 0}),
                                    cameraAt({4, 2, 1}, {0, 1, 0})},
                                   30);
    const FlightCourse course(flight, kUp);
    const double turnsAt = course.timeOf(1), turnsUntil = course.timeOf(2);
    // A right angle takes as long as the mean way of three.
    EXPECT_NEAR((turnsUntil - turnsAt) / 30, 6.0 / 24, 1e-6);
    for (int i = 0; i <= 20; ++i)
        EXPECT_EQ(course.at(turnsAt + (turnsUntil - turnsAt) * i / 20).camera.eye, (Vec3{4, 0, 1}));
    for (const double rest : {turnsAt, turnsUntil, course.timeOf(3)})
        EXPECT_LT(speedAt(course, rest, 1e-3), 0.01);
    EXPECT_LT(course.at((course.timeOf(3) + course.timeOf(4)) / 2).camera.eye.y, 8);
}

TEST(FlightCourse, WhatIsClosedGoesRoundWithoutABreak) {
    Flight flight = flightOf({cameraAt({5, 0, 1}, {-1, 0, 0}), cameraAt({0, 5, 1}, {0, -1, 0}),
                              cameraAt({-5, 0, 1}, {1, 0, 0}), cameraAt({0, -5, 1}, {0, 1, 0})},
                             8);
    flight.closed = true;
    const FlightCourse course(flight, kUp);
    EXPECT_TRUE(course.goesRound());
    EXPECT_EQ(course.frames(25), 200);
    EXPECT_NEAR(course.timeOf(2), 4, 1e-6);
    EXPECT_EQ(course.at(8).camera, course.at(0).camera);
    const double before = speedAt(course, 8 - 0.01, 0.005), after = speedAt(course, 0.01, 0.005);
    EXPECT_NEAR(before, after, 0.01 * after);
    const auto turnedIn = [&](double from) {
        return degreesBetween(course.at(from).camera.forward, course.at(from + 0.05).camera.forward);
    };
    EXPECT_NEAR(turnedIn(7.95), turnedIn(0), 0.02);
    // All the way it turns to the same side.
    for (int i = 0; i < 160; ++i) {
        const double turned = yawOf(course.at(i * 0.05 + 0.05).camera) - yawOf(course.at(i * 0.05).camera);
        EXPECT_GT(turned < -180 ? turned + 360 : turned, 0) << i;
    }
}

TEST(FlightCourse, ATargetIsLookedAtAllTheWay) {
    Flight flight = flightOf({cameraAt({5, 0, 1}, {1, 0, 0}), cameraAt({0, 5, 3}, {0, 1, 0})});
    flight.target = rtcore::Vec3d{0, 0, 2};
    const FlightCourse course(flight, kUp);
    for (int i = 0; i <= 100; ++i) {
        const Camera camera = course.at(i * 0.1).camera;
        EXPECT_LT(degreesBetween(camera.forward, Vec3{0, 0, 2} - camera.eye), 1e-3);
        EXPECT_LT(std::fabs(dot(normalize(cross(camera.forward, camera.up)), kUp)), 1e-5F);
    }
}

TEST(FlightCourse, ATurntableTurnsTheCameraAsItStands) {
    for (const Vec3 up : {Vec3{0, 1, 0}, Vec3{0, 0, 1}}) {
        const Vec3 side = up.y > 0 ? Vec3{0, 0, 5} : Vec3{0, -5, 0}; // ahead of it is the middle, up is up
        const Vec3 middle{1, 2, 3};
        Camera camera = cameraAt(middle + side + up * 2, -side - up, up);
        Flight flight = flightOf({camera}, 12);
        flight.target = rtcore::Vec3d{1, 2, 3};
        flight.turns = 1;
        const FlightCourse course(flight, up);
        EXPECT_TRUE(course.goesRound());
        EXPECT_EQ(course.frames(30), 360);
        EXPECT_EQ(course.at(0).camera, camera);
        // A quarter: the eye is where its right was.
        const Camera quarter = course.at(3).camera;
        EXPECT_LT(distance(quarter.eye, middle + up * 2 + Vec3{5, 0, 0}), 1e-5);
        EXPECT_LT(degreesBetween(quarter.forward, Vec3{-5, 0, 0} - up), 1e-4);
        EXPECT_LT(degreesBetween(quarter.up, up), 1e-4);
        const Camera half = course.at(6).camera;
        EXPECT_LT(distance(half.eye, middle + up * 2 - side), 1e-5);
        flight.turns = -0.5;
        const FlightCourse back(flight, up);
        EXPECT_FALSE(back.goesRound());
        EXPECT_EQ(back.frames(30), 361);
        EXPECT_LT(distance(back.at(6).camera.eye, middle + up * 2 - Vec3{5, 0, 0}), 1e-5);
    }
}

TEST(FlightCourse, ExposureAndRollAreTracks) {
    Flight flight = flightOf({cameraAt({0, 0, 1}, {0, 1, 0}), cameraAt({0, 4, 1}, {0, 1, 0}),
                              cameraAt({0, 8, 1}, {0, 1, 0}, {0.5F, 0, 0.8660254F})});
    flight.keys[0].exposure = 1.0F;
    flight.keys[2].exposure = 3.0F;
    const FlightCourse course(flight, kUp);
    EXPECT_EQ(course.at(0).exposure, 1.0F);
    EXPECT_NEAR(*course.at(5).exposure, 2.0F, 1e-5F);
    EXPECT_EQ(course.at(10).exposure, 3.0F);
    EXPECT_EQ(course.at(2).camera.up, kUp);
    const Camera end = course.at(9.999).camera;
    EXPECT_LT(degreesBetween(end.up, {0.5F, 0, 0.8660254F}), 0.01);
    const Camera middle = course.at(7.5).camera;
    EXPECT_NEAR(degreesBetween(middle.up, kUp), 15, 5);
}

TEST(FlightCourse, RollTurnsTheShorterWay) {
    const auto rolled = [](double degrees) {
        const double radians = degrees / 57.29577951308232;
        return cameraAt({0, 0, 1}, {0, 1, 0},
                        {static_cast<float>(std::sin(radians)), 0, static_cast<float>(std::cos(radians))});
    };
    const FlightCourse course(flightOf({rolled(175), rolled(-175)}), kUp);
    for (int i = 0; i <= 100; ++i) EXPECT_LT(course.at(i * 0.1).camera.up.z, -0.99F);
}

TEST(FlightCourse, HasOneAspectAllTheWay) {
    Flight flight = flightOf({cameraAt({0, 0, 1}, {0, 1, 0}), cameraAt({0, 4, 1}, {0, 1, 0})});
    flight.keys[1].camera.aspect = 1.5F;
    const FlightCourse course(flight, kUp);
    for (int i = 0; i <= 10; ++i) EXPECT_EQ(course.at(i).camera.aspect, 0);
}

TEST(FlightCourse, WhatMovesByRoundingAloneStands) {
    const Flight flight = flightOf({cameraAt({4000, 0, 1}, {1, 0, 0}), cameraAt({4004, 0, 1}, {1, 0, 0}),
                                    cameraAt({std::nextafter(4004.0F, 0.0F), 0, 1}, {0, 1, 0}),
                                    cameraAt({4004, 4, 1}, {0, 1, 0})});
    const FlightCourse course(flight, kUp);
    EXPECT_NEAR(course.timeOf(2) - course.timeOf(1), 10.0 / 3, 1e-3) << "a right angle, as long as a way";
}

TEST(FlightCourse, LooksStraightDown) {
    const FlightCourse course(
        flightOf({cameraAt({0, 0, 9}, {0, 0, -1}, {0, 1, 0}), cameraAt({0, -9, 9}, {0, 1, -1})}), kUp);
    for (int i = 0; i <= 100; ++i) {
        const Camera camera = course.at(i * 0.1).camera;
        EXPECT_LT(std::fabs(camera.forward.x), 1e-5F);
        EXPECT_GT(camera.up.z * camera.up.z + camera.up.y * camera.up.y, 0.99F);
        EXPECT_GE(camera.up.y, -1e-5F);
    }
}

TEST(FlightCourse, OddFlightsAreStillCameras) {
    const Camera camera = cameraAt({1, 2, 3}, {0, 1, 0});
    for (Flight flight : {flightOf({camera}), flightOf({camera, camera, camera})}) {
        for (const bool closed : {false, true}) {
            flight.closed = closed;
            const FlightCourse course(flight, kUp);
            for (int i = 0; i <= 20; ++i) {
                EXPECT_LT(distance(course.at(i * 0.5).camera.eye, camera.eye), 1e-6);
                EXPECT_LT(degreesBetween(course.at(i * 0.5).camera.forward, camera.forward), 1e-4);
            }
        }
    }
}
