#include "rtserver/frames/frame_pacer.h"

#include <gtest/gtest.h>

namespace rtserver {
namespace {

using namespace std::chrono_literals;
using Clock = FramePacer::Clock;

const Clock::time_point kStart{1000s};

TEST(FramePacer, SaysHowFarApartFramesAreAtLeast) {
    EXPECT_EQ(rtserver::FramePacer(0).interval(), rtserver::FramePacer::Clock::duration{});
    EXPECT_NEAR(std::chrono::duration<double>(rtserver::FramePacer(20).interval()).count(), 0.05, 1e-6);
}

TEST(FramePacer, WithoutALimitTheNextFrameIsDueAtOnce) {
    FramePacer pacer(0);
    pacer.published(kStart, kStart + 5ms);
    EXPECT_EQ(pacer.due(false), kStart + 5ms);
}

TEST(FramePacer, AnExposureThatAdaptsTakesItsTime) {
    FramePacer pacer(0);
    pacer.published(kStart, kStart + 5ms);
    EXPECT_EQ(pacer.due(true), kStart + 21ms);
    EXPECT_EQ(pacer.due(false), kStart + 5ms) << "but what changed besides does not wait for it";
}

TEST(FramePacer, FramesThatComeALittleLateKeepTheRate) {
    FramePacer pacer(20);
    pacer.published(kStart, kStart + 10ms);
    EXPECT_EQ(pacer.due(false), kStart + 50ms);
    pacer.published(kStart + 53ms, kStart + 63ms); // 3 ms late
    EXPECT_EQ(pacer.due(false), kStart + 100ms);
    pacer.published(kStart + 104ms, kStart + 110ms);
    EXPECT_EQ(pacer.due(false), kStart + 150ms);
    EXPECT_EQ(pacer.due(true), kStart + 150ms) << "the limit is the later of the two";
}

TEST(FramePacer, OneThatTookTooLongDoesNotPutOffAllThatFollow) {
    FramePacer pacer(20);
    pacer.published(kStart, kStart + 10ms);
    pacer.published(kStart + 50ms, kStart + 120ms); // 20 ms too long
    EXPECT_EQ(pacer.due(false), kStart + 120ms);
    pacer.published(kStart + 120ms, kStart + 140ms);
    EXPECT_EQ(pacer.due(false), kStart + 150ms) << "in time again";
}

TEST(FramePacer, AFrameAfterAPauseBeginsANewRate) {
    FramePacer pacer(20);
    pacer.published(kStart, kStart + 10ms);
    pacer.published(kStart + 5s, kStart + 5s + 10ms);
    EXPECT_EQ(pacer.due(false), kStart + 5s + 50ms);
}

TEST(FramePacer, SlowFramesAreDueAtOnce) {
    FramePacer pacer(20);
    pacer.published(kStart, kStart + 300ms);
    EXPECT_EQ(pacer.due(false), kStart + 300ms);
}

TEST(FramePacer, APauseIsOverWithTheNextFrame) {
    FramePacer pacer(0);
    pacer.pauseUntil(kStart + 1s);
    EXPECT_EQ(pacer.due(false), kStart + 1s);
    pacer.published(kStart + 1s, kStart + 1010ms);
    EXPECT_EQ(pacer.due(false), kStart + 1010ms);
}

TEST(FramePacer, CountsTheFramesOfTheLastSecond) {
    FramePacer pacer(0);
    EXPECT_EQ(pacer.framesPerSecond(kStart), 0);
    for (int i = 0; i < 30; ++i) {
        const Clock::time_point now = kStart + i * 100ms;
        pacer.published(now, now);
    }
    EXPECT_EQ(pacer.framesPerSecond(kStart + 2900ms), 11);
    EXPECT_EQ(pacer.framesPerSecond(kStart + 3400ms), 6);
    EXPECT_EQ(pacer.framesPerSecond(kStart + 5s), 0);
}

} // namespace
} // namespace rtserver
