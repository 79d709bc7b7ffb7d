#include "rtserver/frames/adaptation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace {

using rtserver::Adaptation;
using rtserver::AdaptationSpeed;

constexpr AdaptationSpeed kSpeed{.brighter = 0.1, .darker = 0.4};

TEST(Adaptation, TakesTheFirstTargetAtOnce) {
    Adaptation eye;
    EXPECT_EQ(eye.advance(0.37F, 0, kSpeed), 0.37F);
    EXPECT_TRUE(eye.settled());
}

TEST(Adaptation, HasASpeedForMoreLightAndOneForLess) {
    Adaptation up, down;
    up.advance(1, 0, kSpeed);
    down.advance(10, 0, kSpeed);
    // The rest of ln 10 after 0.1 s: e^-1 of it on the way up, e^-0.25 on the way down.
    EXPECT_NEAR(up.advance(10, 0.1, kSpeed), std::pow(10, 1 - std::exp(-1)), 1e-4);
    EXPECT_NEAR(down.advance(1, 0.1, kSpeed), std::pow(10, std::exp(-0.25)), 1e-4);
    EXPECT_FALSE(up.settled());
}

TEST(Adaptation, KnownValueInOneOrTenSteps) {
    Adaptation once, often;
    constexpr AdaptationSpeed slow{.brighter = 0.4, .darker = 0.4};
    once.advance(1, 0, slow);
    often.advance(1, 0, slow);
    EXPECT_NEAR(once.advance(10, 0.1, slow), 1.664176F, 1e-5F);
    for (int i = 0; i < 10; ++i) often.advance(10, 0.01, slow);
    EXPECT_NEAR(often.value(), 1.664176F, 2e-5F);
}

TEST(Adaptation, DoesNotDependOnTheFrameRate) {
    Adaptation slow, fast;
    slow.advance(1, 0, kSpeed);
    fast.advance(1, 0, kSpeed);
    slow.advance(50, 0.4, kSpeed);
    for (int i = 0; i < 100; ++i) fast.advance(50, 0.004, kSpeed);
    EXPECT_NEAR(std::log(slow.value()), std::log(fast.value()), 1e-4);
}

TEST(Adaptation, IsNotSlowInTheEnd) {
    for (const double seconds : {0.1, 0.4, 20.0}) {
        const AdaptationSpeed speed{seconds, seconds};
        const double min = std::min(0.12, 0.05 / seconds);
        for (const double distance : {0.002, -0.002, 0.01, -0.03, 0.5}) {
            Adaptation once, often;
            for (Adaptation* const eye : {&once, &often}) eye->advance(1, 0, speed);
            const auto target = static_cast<float>(std::exp(distance));
            const double slow = std::min(std::fabs(distance), min * seconds);
            const double time = seconds * std::log(std::fabs(distance) / slow) + slow / min;
            for (int i = 0; i < 10; ++i) often.advance(target, 0.09 * time, speed);
            once.advance(target, 0.9 * time, speed);
            EXPECT_NEAR(std::log(once.value()), std::log(often.value()), 1e-5);
            EXPECT_NEAR(std::fabs(std::log(once.value()) - distance), 0.1 * time * min, 1e-5 + 0.0005);
            once.advance(target, 0.11 * time, speed);
            EXPECT_TRUE(once.settled());
            EXPECT_EQ(once.value(), target);
        }
    }
}

TEST(Adaptation, WithoutTimeIsThereAtOnce) {
    Adaptation eye;
    eye.advance(3, 0, {});
    EXPECT_EQ(eye.advance(77, 0.001, {}), 77);
    EXPECT_TRUE(eye.settled());
    EXPECT_EQ(eye.advance(0.5F, 0, {}), 0.5F);
}

TEST(Adaptation, EndsAtItsTargetToTheBit) {
    for (const float target : {0.123456F, 765.4321F}) {
        Adaptation eye;
        eye.advance(3, 0, kSpeed);
        int steps = 0;
        do {
            eye.advance(target, 0.016, kSpeed);
        } while (!eye.settled() && ++steps < 1000);
        EXPECT_EQ(eye.value(), target);
        EXPECT_LT(steps * 0.016, 3);
        EXPECT_GT(steps, 5);
        EXPECT_EQ(eye.advance(target, 0.016, kSpeed), target);
        EXPECT_TRUE(eye.settled());
    }
}

} // namespace
