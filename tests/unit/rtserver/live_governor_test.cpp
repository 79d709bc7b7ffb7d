#include "rtserver/frames/live_governor.h"
#include "rtserver/frames/walk_light.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace {

using rtserver::FrameDetail;
using rtserver::LiveGovernor;
using rtserver::WalkLight;

constexpr double kPixels = 1e6, kRays = 20, kFrameTarget = 0.033;

/// Draws frames on a machine for which a pixel and a traced one take so many seconds.
/// `learning`: all rays by which indirect light is learned.
FrameDetail settled(LiveGovernor& governor, double pixel, double sample, int frames = 200,
                    double learning = 0) {
    FrameDetail detail;
    for (int i = 0; i < frames; ++i) {
        detail = governor.detail(kPixels, kRays, kFrameTarget);
        const double pixels = kPixels * detail.scale * detail.scale, samples = pixels * detail.newSamples;
        const double raySeconds = learning * detail.learning;
        governor.learn(detail, kPixels, kFrameTarget,
                       {.samples = samples,
                        .sampleSeconds = samples * sample,
                        .rays = learning > 0 ? WalkLight::budgetOf(detail.learning).rays : 0.0,
                        .raySeconds = raySeconds,
                        .seconds = pixels * pixel + samples * sample + raySeconds});
    }
    return detail;
}

double secondsOf(const FrameDetail& detail, double pixel, double sample) {
    return kPixels * detail.scale * detail.scale * (pixel + detail.newSamples * sample);
}

TEST(LiveGovernor, FillsTheTimeWithSamples) {
    LiveGovernor governor;
    const FrameDetail detail = settled(governor, 10e-9, 1e-6);
    EXPECT_EQ(detail.scale, 1);
    EXPECT_TRUE(detail.live());
    EXPECT_FALSE(detail.whole());
    EXPECT_GT(detail.newSamples, 0.01);
    const double seconds = secondsOf(detail, 10e-9, 1e-6);
    EXPECT_LT(seconds, kFrameTarget);
    EXPECT_GT(seconds, 0.7 * kFrameTarget);
}

TEST(LiveGovernor, GivesSizeUpRatherThanFreshLight) {
    LiveGovernor governor;
    const FrameDetail detail = settled(governor, 25e-9, 1e-6);
    EXPECT_LT(detail.scale, 1);
    EXPECT_GT(detail.scale, 0.6);
    EXPECT_GT(detail.newSamples, 0.01);
    EXPECT_LT(detail.newSamples, 0.04);
    EXPECT_LT(secondsOf(detail, 25e-9, 1e-6), 1.1 * kFrameTarget);
    EXPECT_EQ(settled(governor, 5e-9, 1e-6).scale, 1) << "and takes it back";
}

TEST(LiveGovernor, GivesRaysOfIndirectLightUpRatherThanSize) {
    LiveGovernor governor;
    const auto with = [&](double learning) { return settled(governor, 10e-9, 0.3e-6, 200, learning); };
    const FrameDetail quick = with(0.005);
    EXPECT_EQ(quick.learning, 1);
    EXPECT_GT(quick.newSamples, 0.02) << "what is left";
    const FrameDetail slow = with(0.02);
    EXPECT_LT(slow.learning, 0.9);
    EXPECT_GT(slow.learning, 0.4);
    EXPECT_EQ(slow.scale, 1);
    EXPECT_LT(secondsOf(slow, 10e-9, 0.3e-6) + slow.learning * 0.02, kFrameTarget);
    const FrameDetail slowest = with(0.1);
    EXPECT_NEAR(slowest.learning, 0.25, 0.01);
    EXPECT_LT(slowest.scale, 1);
    const FrameDetail off = with(0);
    EXPECT_EQ(off.learning, 1) << "nothing is kept for what is not learned";
    EXPECT_EQ(off.scale, 1);
}

TEST(LiveGovernor, PlansMoreRaysForAPlaceThatNothingIsKnownOf) {
    constexpr double kAll = 0.004, kPixel = 5e-9, kSample = 0.3e-6;
    LiveGovernor governor;
    const FrameDetail before = settled(governor, kPixel, kSample, 200, kAll);
    EXPECT_EQ(before.learning, 1);
    const auto after = [&](double unknown) {
        LiveGovernor now = governor;
        const double samples = kPixels * before.newSamples;
        now.learn(before, kPixels, kFrameTarget,
                  {.samples = samples,
                   .sampleSeconds = samples * kSample,
                   .rays = double{WalkLight::kBudget.rays},
                   .raySeconds = kAll,
                   .unknown = unknown,
                   .seconds = kPixels * kPixel + samples * kSample + kAll});
        return now.detail(kPixels, kRays, kFrameTarget);
    };
    EXPECT_EQ(after(0).learning, 1);
    const FrameDetail some = after(0.3), all = after(1);
    EXPECT_NEAR(some.learning, 1.9, 0.01);
    EXPECT_GT(all.learning, 3.5);
    EXPECT_LT(all.newSamples, some.newSamples) << "pixels give way";
    EXPECT_GT(all.newSamples, 0.019);
    for (const FrameDetail& detail : {some, all})
        EXPECT_LT(secondsOf(detail, kPixel, kSample) + detail.learning * kAll, kFrameTarget) << "in time";
    EXPECT_EQ(WalkLight::budgetOf(some.learning).rays, WalkLight::kBudget.rays);
    EXPECT_NEAR(WalkLight::budgetOf(some.learning).maxTimes, 1.9, 0.01);
    EXPECT_EQ(WalkLight::budgetOf(0.5).rays, WalkLight::kBudget.rays / 2);
    EXPECT_EQ(WalkLight::budgetOf(0.5).maxTimes, 1) << "there is no time for more";
}

/// A machine that is busy has small frames: they are not to be a mosaic of what was learned when.
TEST(WalkLight, UpdatesSmallFramesInFewerTurns) {
    const WalkLight light;
    EXPECT_EQ(light.turns(1), WalkLight::kTurns);
    EXPECT_EQ(light.turns(11.0 / 12), WalkLight::kTurns);
    EXPECT_EQ(light.turns(0.5), 12);
    EXPECT_EQ(light.turns(1.0 / 3), 8);
    for (int twelfths = 4; twelfths <= 12; ++twelfths) {
        const double scale = twelfths / 12.0;
        EXPECT_LE(scale * scale / light.turns(scale), 1.0 / WalkLight::kTurns) << "no more pixels at once";
    }
}

TEST(LiveGovernor, PlansTheRaysOfCoarseFrames) {
    const auto after = [](double secondsOfAll) {
        LiveGovernor governor;
        governor.learnRays({.rays = double{WalkLight::kBudget.rays}, .raySeconds = secondsOfAll});
        return governor.coarseLearning(kFrameTarget);
    };
    EXPECT_EQ(LiveGovernor().coarseLearning(kFrameTarget), 1) << "nothing is known";
    EXPECT_EQ(after(0.001), 4);
    EXPECT_NEAR(after(0.01) * 0.01, kFrameTarget / 2, 1e-6);
    EXPECT_EQ(after(1), 0.25);
}

TEST(LiveGovernor, NeverGivesAllUp) {
    LiveGovernor governor;
    const FrameDetail detail = settled(governor, 1e-5, 1e-3);
    EXPECT_EQ(detail.scale, rtserver::kMinLiveScale);
    EXPECT_GT(detail.newSamples, 0.001);
}

TEST(LiveGovernor, TracesFewOfASceneThatNothingIsKnownOf) {
    const LiveGovernor governor;
    const double dear = governor.detail(kPixels, 2000, kFrameTarget).newSamples;
    EXPECT_GT(dear, 0);
    EXPECT_LT(dear * kPixels * 2000, 200e3) << "rays, in a frame that is never left";
    EXPECT_GE(dear * kPixels, 63.9);
    EXPECT_GT(governor.detail(kPixels, 2, kFrameTarget).newSamples, dear);
}

TEST(LiveGovernor, BelievesInMoreSoonerThanInLess) {
    LiveGovernor governor;
    const double before = settled(governor, 5e-9, 0.4e-6).newSamples;
    const double slower = settled(governor, 5e-9, 0.8e-6, 2).newSamples;
    EXPECT_LT(slower, 0.75 * before);
    EXPECT_LT(settled(governor, 5e-9, 0.4e-6, 2).newSamples, 0.95 * before);
    EXPECT_NEAR(settled(governor, 5e-9, 0.4e-6).newSamples, before, 0.05 * before);
}

TEST(LiveGovernor, KeepsTheSizeBesideProgramsThatTakeTheProcessorNowAndThen) {
    constexpr double kPixel = 8e-9, kSample = 0.3e-6, kAll = 0.004, kTaken = 0.02;
    LiveGovernor governor;
    FrameDetail detail;
    double smallest = 1;
    for (int i = 0; i < 300; ++i) {
        detail = governor.detail(kPixels, kRays, kFrameTarget);
        const double pixels = kPixels * detail.scale * detail.scale, samples = pixels * detail.newSamples;
        // In each third frame, by turns in another part of the work.
        const auto taken = [&](int part) { return i % 3 == 0 && i / 3 % 3 == part ? kTaken : 0; };
        const double sampleSeconds = samples * kSample + taken(0),
                     raySeconds = detail.learning * kAll + taken(1);
        governor.learn(detail, kPixels, kFrameTarget,
                       {.samples = samples,
                        .sampleSeconds = sampleSeconds,
                        .rays = WalkLight::budgetOf(detail.learning).rays * 1.0,
                        .raySeconds = raySeconds,
                        .seconds = pixels * kPixel + taken(2) + sampleSeconds + raySeconds});
        if (i > 30) smallest = std::min(smallest, detail.scale);
    }
    EXPECT_EQ(smallest, 1);
    EXPECT_EQ(detail.learning, 1);
}

TEST(LiveGovernor, ForgetsAScene) {
    LiveGovernor governor;
    const FrameDetail first = governor.detail(kPixels, kRays, kFrameTarget);
    settled(governor, 1e-7, 1e-4);
    governor.forget();
    EXPECT_EQ(governor.detail(kPixels, kRays, kFrameTarget), first);
}

} // namespace
