#include "bridge/stream/rest.h"

#include <gtest/gtest.h>

namespace {

using bridge::FrameStep;
using bridge::RestWatch;

FrameStep stepAt(float x, std::uint64_t tag = 0, std::uint32_t samples = 1) {
    return {.epoch = 1, .run = 1, .width = 64, .height = 48, .samples = samples, .tag = tag, .view = {x}};
}

/// Shows it if it is to be shown.
bool show(RestWatch& rest, double now, const FrameStep& step) {
    if (!rest.comes(now, step)) return false;
    rest.shown(now);
    return true;
}

TEST(RestWatch, WaitsForQuietAndTakesEachFrameOnce) {
    RestWatch rest;
    EXPECT_FALSE(rest.takeStill(0, true)) << "no frame yet";
    ASSERT_TRUE(show(rest, 1, stepAt(0)));
    EXPECT_FALSE(rest.takeStill(1.1, true));
    EXPECT_TRUE(rest.takeStill(1.13, true));
    EXPECT_FALSE(rest.takeStill(1.2, true));
}

TEST(RestWatch, TakesNothingWhileTheCameraMoves) {
    RestWatch rest;
    for (int i = 0; i < 100; ++i) {
        ASSERT_TRUE(show(rest, 0.2 * i, stepAt(static_cast<float>(i))));
        EXPECT_FALSE(rest.takeStill(0.2 * i + 0.15, false));
    }
}

TEST(RestWatch, TakesSomeStepsOfAPictureThatImproves) {
    RestWatch rest;
    ASSERT_TRUE(show(rest, 0, stepAt(1)));
    int taken = 0;
    for (int i = 1; i <= 100; ++i) { // 20 s
        show(rest, 0.2 * i, stepAt(0));
        taken += rest.takeStill(0.2 * i + 0.15, false) ? 1 : 0;
    }
    EXPECT_GE(taken, 2);
    EXPECT_LE(taken, 6);
    ASSERT_TRUE(show(rest, 30, stepAt(0)));
    EXPECT_TRUE(rest.takeStill(30.2, true)) << "the last one";
}

/// A picture by paths, which publishes sixty steps a second.
TEST(RestWatch, ShowsStepsThatImproveThePictureAtGrowingIntervals) {
    RestWatch rest;
    double last = 0, longest = 0;
    int shown = 0, stills = 0;
    bool waits = false;
    ASSERT_TRUE(show(rest, 0, stepAt(0)));
    for (int i = 1; i <= 3600; ++i) {
        const double now = i / 60.0;
        waits = !rest.comes(now, stepAt(0, static_cast<std::uint64_t>(i)));
        if (!waits) {
            rest.shown(now);
            EXPECT_GE(now - last, longest) << "step " << i;
            if (longest < 4) longest = now - last;
            last = now;
            ++shown;
        }
        stills += rest.takeStill(now + 0.01, false) ? 1 : 0;
    }
    EXPECT_GE(shown, 8);
    EXPECT_LE(shown, 20) << "in a minute";
    EXPECT_GE(stills, 4);
    EXPECT_LE(stills, 10);
    ASSERT_TRUE(waits) << "the last one came just now";
    EXPECT_FALSE(rest.due(60.01, false));
    EXPECT_TRUE(rest.due(60.01, true)) << "the last one is shown in any case";
    rest.shown(60.01);
    EXPECT_TRUE(rest.takeStill(60.2, true)) << "exactly";
}

TEST(RestWatch, ShowsAtOnceWhatIsNoStepOfTheSamePicture) {
    const auto after = [](const FrameStep& next) {
        RestWatch rest;
        for (int i = 0; i < 60; ++i) show(rest, i, stepAt(0, 100 + static_cast<std::uint64_t>(i), 4));
        return rest.comes(59.5, next);
    };
    EXPECT_FALSE(after(stepAt(0, 200, 4))) << "further";
    EXPECT_FALSE(after(stepAt(0, 159, 5))) << "with more samples";
    EXPECT_TRUE(after(stepAt(1, 200, 4))) << "another view";
    EXPECT_TRUE(after(stepAt(0, 159, 4))) << "no further: a setting may have changed";
    EXPECT_TRUE(after(stepAt(0, 0, 0))) << "a new picture";
    FrameStep other = stepAt(0, 200, 4);
    other.run = 2;
    EXPECT_TRUE(after(other)) << "another run";
    other = stepAt(0, 200, 4);
    other.epoch = 2;
    EXPECT_TRUE(after(other)) << "another server";
    other = stepAt(0, 200, 4);
    other.width = 128;
    EXPECT_TRUE(after(other)) << "another size";
}

TEST(RestWatch, NeverLetsAWholeFrameWaitForTheCoarseOneBeforeIt) {
    RestWatch rest;
    ASSERT_TRUE(show(rest, 0, stepAt(0, 0, 0)));
    EXPECT_TRUE(rest.comes(0.01, stepAt(0, 0, 4)));
}

} // namespace
