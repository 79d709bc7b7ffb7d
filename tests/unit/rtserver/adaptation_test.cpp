#include "rtserver/adaptation.h"

#include <gtest/gtest.h>

#include <cmath>

namespace {

using rtserver::Adaptation;

TEST(Adaptation, TakesTheFirstTargetAtOnce) {
    Adaptation eye;
    EXPECT_EQ(eye.advance(0.37F, 0), 0.37F);
    EXPECT_TRUE(eye.settled());
}

TEST(Adaptation, NearsItsTargetByTheLogarithm) {
    Adaptation up, down;
    up.advance(1, 0);
    down.advance(100, 0);
    const float rising = up.advance(100, 0.1), falling = down.advance(1, 0.1);
    EXPECT_FALSE(up.settled());
    EXPECT_NEAR(rising * falling, 100, 0.01) << "light and darkness take equally long";
    EXPECT_GT(rising, 1);
    EXPECT_LT(rising, 100);
}

TEST(Adaptation, DoesNotDependOnTheFrameRate) {
    Adaptation slow, fast;
    slow.advance(1, 0);
    fast.advance(1, 0);
    slow.advance(50, 0.4);
    for (int i = 0; i < 100; ++i) fast.advance(50, 0.004);
    EXPECT_NEAR(std::log(slow.value()), std::log(fast.value()), 1e-4);
}

TEST(Adaptation, EndsAtItsTargetToTheBit) {
    Adaptation eye;
    eye.advance(3, 0);
    int steps = 0;
    do {
        eye.advance(0.123456F, 0.016);
    } while (!eye.settled() && ++steps < 1000);
    EXPECT_EQ(eye.value(), 0.123456F);
    EXPECT_LT(steps * 0.016, 3);
    EXPECT_GT(steps, 5);
}

} // namespace
