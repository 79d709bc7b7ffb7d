#include "rtserver/frame_pacer.h"

#include <gtest/gtest.h>

namespace rtserver {
namespace {

using namespace std::chrono_literals;
using Clock = FramePacer::Clock;

const Clock::time_point kStart{1000s};

TEST(FramePacer, WithoutALimitTheNextFrameIsDueAtOnce) {
    FramePacer pacer(0);
    pacer.published(kStart, kStart + 5ms, false);
    EXPECT_EQ(pacer.due(), kStart + 5ms);
}

TEST(FramePacer, AnExposureThatAdaptsTakesItsTime) {
    FramePacer pacer(0);
    pacer.published(kStart, kStart + 5ms, true);
    EXPECT_EQ(pacer.due(), kStart + 21ms);
}

TEST(FramePacer, FramesThatComeALittleLateKeepTheRate) {
    FramePacer pacer(20);
    pacer.published(kStart, kStart + 10ms, false);
    EXPECT_EQ(pacer.due(), kStart + 50ms);
    pacer.published(kStart + 53ms, kStart + 63ms, false); // 3 ms late
    EXPECT_EQ(pacer.due(), kStart + 100ms);
    pacer.published(kStart + 104ms, kStart + 110ms, true); // the limit is the later of the two
    EXPECT_EQ(pacer.due(), kStart + 150ms);
}

TEST(FramePacer, AFrameAfterAPauseBeginsANewRate) {
    FramePacer pacer(20);
    pacer.published(kStart, kStart + 10ms, false);
    pacer.published(kStart + 5s, kStart + 5s + 10ms, false);
    EXPECT_EQ(pacer.due(), kStart + 5s + 50ms);
}

TEST(FramePacer, SlowFramesAreDueAtOnce) {
    FramePacer pacer(20);
    pacer.published(kStart, kStart + 300ms, false);
    EXPECT_EQ(pacer.due(), kStart + 300ms);
}

TEST(FramePacer, APauseIsOverWithTheNextFrame) {
    FramePacer pacer(0);
    pacer.pauseUntil(kStart + 1s);
    EXPECT_EQ(pacer.due(), kStart + 1s);
    pacer.published(kStart + 1s, kStart + 1010ms, false);
    EXPECT_EQ(pacer.due(), kStart + 1010ms);
}

TEST(FramePacer, CountsTheFramesOfTheLastSecond) {
    FramePacer pacer(0);
    EXPECT_EQ(pacer.framesPerSecond(kStart), 0);
    for (int i = 0; i < 30; ++i) {
        const Clock::time_point now = kStart + i * 100ms;
        pacer.published(now, now, false);
    }
    EXPECT_EQ(pacer.framesPerSecond(kStart + 2900ms), 11);
    EXPECT_EQ(pacer.framesPerSecond(kStart + 3400ms), 6);
    EXPECT_EQ(pacer.framesPerSecond(kStart + 5s), 0);
}

} // namespace
} // namespace rtserver
