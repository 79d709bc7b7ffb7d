#include "bridge/stream/rest.h"

#include <gtest/gtest.h>

namespace {

constexpr float kEye[3] = {0, 0, 0}, kElsewhere[3] = {1, 0, 0}, kAhead[3] = {0, 0, -1};

TEST(RestWatch, WaitsForQuietAndTakesEachFrameOnce) {
    bridge::RestWatch rest;
    EXPECT_FALSE(rest.takeStill(0, true)) << "no frame yet";
    rest.frameCame(1, kEye, kAhead);
    EXPECT_FALSE(rest.takeStill(1.1, true));
    EXPECT_TRUE(rest.takeStill(1.13, true));
    EXPECT_FALSE(rest.takeStill(1.2, true));
}

TEST(RestWatch, TakesNothingWhileTheCameraMoves) {
    bridge::RestWatch rest;
    for (int i = 0; i < 100; ++i) {
        const float eye[3] = {static_cast<float>(i), 0, 0};
        rest.frameCame(0.2 * i, eye, kAhead);
        EXPECT_FALSE(rest.takeStill(0.2 * i + 0.15, false));
    }
}

TEST(RestWatch, TakesSomeStepsOfAPictureThatImproves) {
    bridge::RestWatch rest;
    rest.frameCame(0, kElsewhere, kAhead);
    int taken = 0;
    for (int i = 1; i <= 100; ++i) { // 20 s
        rest.frameCame(0.2 * i, kEye, kAhead);
        taken += rest.takeStill(0.2 * i + 0.15, false) ? 1 : 0;
    }
    EXPECT_GE(taken, 2);
    EXPECT_LE(taken, 6);
    rest.frameCame(30, kEye, kAhead);
    EXPECT_TRUE(rest.takeStill(30.2, true)) << "the last one";
}

} // namespace
