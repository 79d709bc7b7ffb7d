#include "rtserver/resolution_governor.h"

#include <gtest/gtest.h>

namespace {

/// Frames whose time is that of all pixels times the square of the scale.
double settledScale(rtserver::ResolutionGovernor& governor, double fullSeconds, double target, int frames) {
    for (int i = 0; i < frames; ++i) {
        const double scale = governor.scale();
        governor.learn(fullSeconds * scale * scale, scale, target);
    }
    return governor.scale();
}

TEST(ResolutionGovernor, FitsTheTime) {
    rtserver::ResolutionGovernor governor;
    EXPECT_EQ(governor.scale(), 1);
    EXPECT_EQ(settledScale(governor, 0.04, 0.01, 1), 0.5) << "at once";
    EXPECT_EQ(settledScale(governor, 0.04, 0.01, 50), 0.5) << "and stays";
    EXPECT_LT(settledScale(governor, 0.01, 0.02, 1), 1) << "back step by step";
    EXPECT_EQ(settledScale(governor, 0.01, 0.02, 100), 1);
}

TEST(ResolutionGovernor, HasLimits) {
    rtserver::ResolutionGovernor governor;
    EXPECT_EQ(settledScale(governor, 100, 0.001, 10), 0.125);
    governor.learn(0, 0.125, 0.01);
    EXPECT_EQ(governor.scale(), 0.125) << "a time of nothing teaches nothing";
    EXPECT_EQ(settledScale(governor, 1e-9, 1, 200), 1);
}

} // namespace
