#include "rtserver/frames/detail_governor.h"

#include <gtest/gtest.h>

namespace {

using rtserver::DetailGovernor;
using rtserver::FrameDetail;

constexpr double kTarget = 0.033;
constexpr DetailGovernor::Work kPlain{1e6, 1e6}, kDear{64e6, 1e6};

/// A machine that does so much work a second draws so many frames.
FrameDetail settled(DetailGovernor& governor, const DetailGovernor::Work& work, double speed, int frames) {
    for (int i = 0; i < frames; ++i) {
        const FrameDetail detail = governor.detail(work, kTarget);
        governor.learn(detail, work,
                       (detail.cut ? work.cut : work.whole) * detail.scale * detail.scale / speed);
    }
    return governor.detail(work, kTarget);
}

double secondsOf(const FrameDetail& detail, const DetailGovernor::Work& work, double speed) {
    return (detail.cut ? work.cut : work.whole) * detail.scale * detail.scale / speed;
}

TEST(DetailGovernor, BeginsWithTheCoarsest) {
    DetailGovernor governor;
    EXPECT_EQ(governor.detail(kDear, kTarget), rtserver::kCoarsest);
    EXPECT_EQ(governor.detail(kPlain, kTarget).scale, rtserver::kMinScale);
    governor.learn({}, kPlain, 1e-6);
    EXPECT_TRUE(governor.detail(kPlain, kTarget).whole());
    governor.forget();
    EXPECT_EQ(governor.detail(kDear, kTarget), rtserver::kCoarsest);
}

TEST(DetailGovernor, FitsTheTime) {
    for (const double speed : {1e7, 4e7, 1e8, 1e9}) {
        for (const DetailGovernor::Work& work : {kPlain, kDear}) {
            DetailGovernor governor;
            const FrameDetail detail = settled(governor, work, speed, 200);
            EXPECT_LT(secondsOf(detail, work, speed), kTarget) << speed;
            EXPECT_GT(secondsOf(detail, work, speed), detail.scale == 1 ? 0 : kTarget * 0.4) << speed;
        }
    }
}

TEST(DetailGovernor, CutsSamplesBeforeThePictureGetsCoarse) {
    DetailGovernor governor;
    const FrameDetail slow = settled(governor, kDear, 4e7, 200);
    EXPECT_TRUE(slow.cut);
    EXPECT_GT(slow.scale, 0.5);
    const FrameDetail quick = settled(governor, kDear, 1e9, 300);
    EXPECT_FALSE(quick.cut);
}

TEST(DetailGovernor, KnowsDearerSettingsBeforeTheyAreDrawn) {
    DetailGovernor governor;
    governor.learn({}, kPlain, 0.02);
    EXPECT_TRUE(governor.detail(kPlain, kTarget).whole());
    EXPECT_FALSE(governor.detail(kDear, kTarget).whole());
}

TEST(DetailGovernor, AWholeFrameTellsLittleOfCoarseOnes) {
    DetailGovernor governor;
    governor.learn({0.25, false}, kPlain, 0.03);
    governor.learn({}, kPlain, 0.05);
    EXPECT_LT(governor.detail(kPlain, kTarget).scale, 0.3);
}

TEST(DetailGovernor, WhatWasLeftHasTakenLongerThanThat) {
    DetailGovernor governor;
    governor.learn({}, kPlain, 0.02);
    governor.learnLimit({}, kPlain, 0.01);
    EXPECT_TRUE(governor.detail(kPlain, kTarget).whole()) << "teaches nothing new";
    governor.learnLimit({}, kPlain, 0.04);
    EXPECT_FALSE(governor.detail(kPlain, kTarget).whole());
    governor.learn({}, kPlain, 0);
    EXPECT_FALSE(governor.detail(kPlain, kTarget).whole()) << "a time of nothing teaches nothing";
}

} // namespace
