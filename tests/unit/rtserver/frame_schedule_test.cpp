#include "rtserver/frames/frame_schedule.h"

#include <gtest/gtest.h>

namespace {

using namespace std::chrono_literals;
using rtserver::FrameDetail;
using rtserver::FrameSchedule;
using rtserver::kCoarsest;

constexpr rtserver::DetailGovernor::Work kWork{64e6, 1e6};
constexpr FrameSchedule::Demand kChange{.frameSeconds = 0.033, .work = kWork};
constexpr FrameSchedule::Demand kRest{.changed = false, .frameSeconds = 0.033, .work = kWork};

TEST(FrameSchedule, AChangeIsSeenCoarseAtFirstAndThenWhole) {
    FrameSchedule schedule;
    EXPECT_EQ(schedule.begin(kChange), kCoarsest);
    EXPECT_FALSE(schedule.leaves(10h, true)) << "or nothing would ever be seen";
    schedule.shown(20ms);
    EXPECT_TRUE(schedule.begin(kRest).whole());
    EXPECT_FALSE(schedule.leaves(10h, false));
    EXPECT_TRUE(schedule.leaves(1ms, true)) << "at once";
    schedule.left(1ms);
    EXPECT_FALSE(schedule.begin(kChange).whole());
}

TEST(FrameSchedule, WhatIsQuickEnoughIsWholeAtOnce) {
    FrameSchedule schedule;
    schedule.begin(kRest);
    schedule.shown(5ms);
    EXPECT_TRUE(schedule.begin(kChange).whole());
    EXPECT_FALSE(schedule.leaves(20ms, true)) << "a change is never left for another";
    EXPECT_TRUE(schedule.leaves(34ms, false)) << "it was not quick enough";
    schedule.left(34ms);
    EXPECT_EQ(schedule.begin(kChange), kCoarsest);
    EXPECT_FALSE(schedule.leaves(1s, true));
    schedule.shown(20ms);
    EXPECT_FALSE(schedule.begin(kChange).whole()) << "and that is known now";
}

TEST(FrameSchedule, LeavesWhatIsLateEarlyEnoughForTheCoarsest) {
    FrameSchedule schedule;
    schedule.begin(kChange);
    schedule.shown(30ms); // the coarsest
    schedule.begin(kRest);
    schedule.shown(1ms);
    EXPECT_TRUE(schedule.begin(kChange).whole());
    EXPECT_FALSE(schedule.leaves(20ms, true));
    EXPECT_TRUE(schedule.leaves(24ms, false)) << "24 and 30 ms, and what else there is to do, are 66";
    schedule.left(24ms);
    EXPECT_EQ(schedule.begin(kChange), kCoarsest);
    schedule.shown(50ms);
    EXPECT_EQ(schedule.begin(kChange), kCoarsest) << "nothing else would leave it time";
    EXPECT_FALSE(schedule.leaves(10h, true));
}

TEST(FrameSchedule, CoarseFramesLearnIndirectLightByAsManyRaysAsThereIsTimeFor) {
    FrameSchedule schedule;
    EXPECT_EQ(schedule.begin(kChange), kCoarsest);
    schedule.shown(200ms, {.rays = 8192, .raySeconds = 0.15});
    const FrameDetail next = schedule.begin(kChange);
    EXPECT_EQ(next.learning, 0.25);
    EXPECT_EQ(next.scale, kCoarsest.scale);
    EXPECT_FALSE(schedule.leaves(10h, true)) << "it is the coarsest still";
    EXPECT_EQ(schedule.begin(kRest).learning, 1);
}

TEST(FrameSchedule, AnotherSceneIsSeenCoarseAtFirst) {
    FrameSchedule schedule;
    schedule.begin(kRest);
    schedule.shown(5ms);
    schedule.forget();
    EXPECT_EQ(schedule.begin(kChange), kCoarsest);
}

TEST(FrameSchedule, AFrameThatACommandWaitsForHasASecond) {
    FrameSchedule schedule;
    FrameSchedule::Demand file = kRest;
    file.waitedFor = true;
    EXPECT_TRUE(schedule.begin(file).whole());
    EXPECT_FALSE(schedule.leaves(900ms, true));
    EXPECT_TRUE(schedule.leaves(1100ms, true));
    EXPECT_FALSE(schedule.leaves(10h, false));
}

TEST(FrameSchedule, WithoutATimeAllIsWholeButForWhatWouldLockTheUserOut) {
    FrameSchedule schedule;
    for (const bool changed : {true, false}) {
        const FrameSchedule::Demand any{.changed = changed, .work = kWork};
        EXPECT_TRUE(schedule.begin(any).whole());
        EXPECT_FALSE(schedule.leaves(10h, false));
        EXPECT_FALSE(schedule.leaves(900ms, true));
        EXPECT_TRUE(schedule.leaves(1100ms, true));
        schedule.left(1100ms);
        EXPECT_EQ(schedule.begin(any), kCoarsest);
        EXPECT_FALSE(schedule.leaves(10h, true));
        schedule.shown(50ms);
        EXPECT_TRUE(schedule.begin(any).whole());
        schedule.shown(3s);
    }
}

constexpr FrameSchedule::Demand kLiveChange{
    .frameSeconds = 0.033, .work = kWork, .live = true, .pixels = 1e6, .liveRays = 20};

TEST(FrameSchedule, WhereThereAreLiveFramesAChangeIsSeenInOne) {
    FrameSchedule schedule;
    EXPECT_TRUE(schedule.begin(kLiveChange).live());
    EXPECT_FALSE(schedule.leaves(10h, true)) << "or nothing would ever be seen";
    schedule.shown(20ms, {.samples = 1000, .sampleSeconds = 0.01});
    EXPECT_EQ(schedule.coarsest(), 0) << "a live frame fills its time; that says nothing of the coarsest";
    FrameSchedule::Demand rest = kLiveChange;
    rest.changed = false;
    EXPECT_TRUE(schedule.begin(rest).whole());
    EXPECT_TRUE(schedule.leaves(1ms, true));
    schedule.left(1ms);
    EXPECT_TRUE(schedule.begin(kLiveChange).live());
}

TEST(FrameSchedule, WhatIsQuickEnoughIsWholeThoughThereCouldBeLiveFrames) {
    FrameSchedule schedule;
    FrameSchedule::Demand rest = kLiveChange;
    rest.changed = false;
    schedule.begin(rest);
    schedule.shown(5ms);
    EXPECT_TRUE(schedule.begin(kLiveChange).whole());
    EXPECT_TRUE(schedule.leaves(60ms, false)) << "it was not";
    schedule.left(60ms);
    EXPECT_TRUE(schedule.begin(kLiveChange).live());
}

} // namespace
