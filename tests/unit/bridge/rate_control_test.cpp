#include "bridge/stream/rate_control.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <deque>
#include <random>

namespace {

using bridge::RateControl;

constexpr double kBytesAtFirst = 100'000; ///< of a frame of kFirstRung

/// A link of a fixed delay and bandwidth, one frame after the other, and a viewer that decodes in 5 ms.
struct LinkModel {
    double delay, bytesPerSecond, fps = 30;
    RateControl rate = RateControl();
    double now = 0, freeAt = 0, oldest = 0;
    int shown = 0;
    std::uint64_t number = 0;
    struct Flying {
        std::uint64_t number;
        double sent, drawn;
    };
    std::deque<Flying> flying = {};

    void acknowledge() {
        constexpr double kDecode = 0.005;
        while (!flying.empty() && flying.front().drawn <= now) {
            const Flying frame = flying.front();
            flying.pop_front();
            oldest = std::max(oldest, frame.drawn - frame.sent);
            ++shown;
            rate.acked(1, frame.number, false, kDecode, now);
        }
    }
    void run(double seconds) {
        constexpr double kStep = 0.001;
        rate.setFrameTime(1 / fps);
        double nextFrame = now;
        shown = 0;
        oldest = 0;
        bool fresh = false;
        for (const double end = now + seconds; now < end; now += kStep) {
            acknowledge();
            if (now >= nextFrame) {
                nextFrame += 1 / fps;
                ++number;
                rate.offered();
                fresh = true;
            }
            if (fresh && rate.windowOpen()) send();
            fresh = fresh && !flying.empty() && flying.back().number != number;
        }
    }
    void send() {
        constexpr double kDecode = 0.005;
        const double bytes = kBytesAtFirst * bridge::kRungs[static_cast<std::size_t>(rate.rung())].relative;
        freeAt = std::max(freeAt, now) + bytes / bytesPerSecond;
        flying.push_back({number, now, freeAt + delay + kDecode});
        rate.sent(1, number, false, static_cast<std::size_t>(bytes), now);
    }
};

/// A link that carries all at once, beside processors that are busy: acknowledgements come late, now and then
/// much so, whatever was sent. The page pauses once.
struct BusyModel {
    double fps, usual;                ///< usual lateness, seconds: exponential
    double spike = 0.15, part = 0.02; ///< so late in this part of all frames
    double decode = 0.006;
    double pauseAt = 1e9, pause = 0;
    std::mt19937 random = std::mt19937(5);
    RateControl rate = RateControl();
    double coarse = 0, longest = 0; ///< seconds below the first rung; at a stretch

    double lateness() {
        std::exponential_distribution<double> late(1 / usual);
        return std::uniform_real_distribution<double>()(random) < part ? spike + late(random) : late(random);
    }
    void run(double seconds) {
        constexpr double kStep = 0.001;
        rate.setFrameTime(1 / fps);
        rate.ponged(0.001, 0);
        struct Flying {
            std::uint64_t number;
            double drawn;
        };
        std::deque<Flying> flying;
        std::uint64_t number = 0;
        double nextFrame = 0, stretch = 0, last = 0;
        bool fresh = false;
        for (double now = 0; now < seconds; now += kStep) {
            const bool stands = now >= pauseAt && now < pauseAt + pause;
            for (; !stands && !flying.empty() && flying.front().drawn <= now; flying.pop_front())
                rate.acked(1, flying.front().number, false, decode, now);
            if (now >= nextFrame) {
                nextFrame += 1 / fps;
                ++number;
                rate.offered();
                fresh = true;
            }
            if (fresh && rate.windowOpen()) {
                fresh = false;
                last = std::max(last + decode, now + decode + lateness()); // in order
                flying.push_back({number, last});
                const double size = bridge::kRungs[static_cast<std::size_t>(rate.rung())].relative;
                rate.sent(1, number, false, static_cast<std::size_t>(kBytesAtFirst * size), now);
            }
            stretch = rate.rung() > bridge::kFirstRung ? stretch + kStep : 0;
            coarse += stretch > 0 ? kStep : 0;
            longest = std::max(longest, stretch);
        }
    }
};

TEST(RateControl, StaysFineWhereOnlyProcessorsAreBusy) {
    for (const double fps : {10.0, 20.0, 30.0, 60.0})
        for (const double usual : {0.01, 0.03, 0.05}) {
            BusyModel busy{fps, usual};
            busy.run(60);
            EXPECT_LE(busy.longest, 4) << fps << " frames/s, late by " << usual;
            EXPECT_LE(busy.coarse, 6) << fps << " frames/s, late by " << usual;
        }
}

TEST(RateControl, IsFineAgainSoonAfterThePagePaused) {
    for (const double pause : {0.3, 1.0, 3.0, 10.0}) {
        BusyModel busy{.fps = 30, .usual = 0.01, .pauseAt = 5, .pause = pause};
        busy.run(20);
        EXPECT_LE(busy.longest, 2.5) << "after " << pause << " s";
    }
}

TEST(RateControl, MakesFramesCoarserForAPageThatDecodesTooSlowly) {
    BusyModel slow{.fps = 30, .usual = 0.001, .part = 0, .decode = 0.08};
    slow.run(5);
    EXPECT_GT(slow.rate.rung(), bridge::kFirstRung);
}

TEST(RateControl, FollowsALinkThatBecomesNarrow) {
    LinkModel link{0.02, 20e6};
    link.rate.ponged(0.02, 0);
    link.run(5);
    ASSERT_LE(link.rate.rung(), bridge::kFirstRung);
    link.bytesPerSecond = 2e6 / 8;
    link.run(4);
    EXPECT_GE(link.rate.rung(), bridge::kFirstHalfRung);
    link.run(4);
    EXPECT_GE(link.shown, 4 * 8);
    EXPECT_LT(link.oldest, 0.02 + 3 * 4.0 / link.shown);
}

/// At each rate of the server, for larger and smaller frames.
TEST(RateControl, KeepsANarrowLinkFluentAndItsFramesYoung) {
    for (const double fps : {10.0, 15.0, 22.0, 30.0, 60.0})
        for (const double bytesPerSecond : {1.5e6 / 8, 2e6 / 8, 3e6 / 8, 6e6 / 8}) {
            LinkModel link{0.1, bytesPerSecond, fps};
            link.rate.ponged(0.1, 0);
            link.run(2);
            link.run(20);
            const double shown = link.shown / 20.0;
            EXPECT_GE(shown, 9) << fps << " frames/s, " << bytesPerSecond;
            EXPECT_LT(link.oldest, 0.1 + 3 / shown) << fps << " frames/s, " << bytesPerSecond;
        }
}

TEST(RateControl, KeepsTwoFramesUnderWayOnAShortLink) {
    RateControl rate;
    rate.setFrameTime(1.0 / 30);
    rate.ponged(0.001, 0);
    EXPECT_EQ(rate.window(), 2);
    rate.sent(1, 1, false, 1000, 0);
    EXPECT_TRUE(rate.windowOpen());
    rate.sent(1, 2, false, 1000, 0.01);
    EXPECT_FALSE(rate.windowOpen());
    EXPECT_FALSE(rate.acked(1, 7, false, 0, 0.02));
    EXPECT_FALSE(rate.acked(2, 1, false, 0, 0.02));
    EXPECT_TRUE(rate.acked(1, 1, false, 0, 0.02));
    EXPECT_TRUE(rate.windowOpen());
}

TEST(RateControl, OpensTheWindowWithTheDelayUpToSix) {
    RateControl rate;
    rate.setFrameTime(1.0 / 30);
    rate.ponged(0.1, 0);
    EXPECT_EQ(rate.window(), 4);
    RateControl far;
    far.setFrameTime(1.0 / 30);
    far.ponged(2, 0);
    EXPECT_EQ(far.window(), 6);
}

TEST(RateControl, NeverHasMoreUnderWayThanItsWindow) {
    RateControl rate;
    for (std::uint64_t i = 1; i < 100 && rate.windowOpen(); ++i) rate.sent(1, i, false, 100'000, 0);
    EXPECT_EQ(rate.inFlight(), 2U);
}

TEST(RateControl, StaysFineOnAFastLinkHoweverLongItIs) {
    LinkModel link{0.15, 20e6};
    link.rate.ponged(0.15, 0);
    link.run(10);
    EXPECT_LE(link.rate.rung(), bridge::kFirstRung);
    EXPECT_GT(link.shown, 200);
}

TEST(RateControl, FindsARungForANarrowLinkWithinTwoSeconds) {
    LinkModel link{0.1, 2e6 / 8};
    link.rate.ponged(0.1, 0);
    link.run(2);
    link.run(5);
    EXPECT_GE(link.shown, 5 * 8) << "frames shown in 5 s";
    EXPECT_LT(link.oldest, 0.1 + 3 * 5.0 / link.shown) << "age of the oldest, s";
    EXPECT_GE(link.rate.rung(), bridge::kFirstHalfRung);
}

TEST(RateControl, GoesBackUpWhenTheLinkIsWideAgain) {
    LinkModel link{0.1, 2e6 / 8};
    link.rate.ponged(0.1, 0);
    link.run(5);
    const int coarse = link.rate.rung();
    link.bytesPerSecond = 20e6;
    link.run(12);
    EXPECT_LT(link.rate.rung(), coarse);
}

TEST(RateControl, KeepsPinnedRungs) {
    LinkModel link{0.1, 2e6 / 8};
    link.rate.pin(0);
    link.run(3);
    EXPECT_EQ(link.rate.rung(), 0);
    link.rate.limit(3);
    EXPECT_EQ(link.rate.rung(), 3);
    link.rate.floor(1);
    EXPECT_EQ(link.rate.rung(), 3) << "what the page wants does not lift the limit";
    link.rate.limit(0);
    EXPECT_EQ(link.rate.rung(), 1);
}

TEST(RateControl, SendsSmallPartsOverNarrowLinks) {
    RateControl rate;
    EXPECT_EQ(rate.partBytes(), 32768U);
    rate.ponged(0.1, 0);
    for (std::uint64_t i = 1; i < 20; ++i) {
        const double start = static_cast<double>(i);
        rate.sent(1, i, false, 25'000, start);
        rate.acked(1, i, false, 0, start + 0.2);
    }
    EXPECT_LT(rate.partBytes(), 20'000U);
    EXPECT_TRUE(rate.narrow());
}

TEST(RateControl, MergesRungsDownwardsUntilThreeAreLeft) {
    EXPECT_EQ(bridge::mergedRungs(0b000111), 0b000111U);
    EXPECT_EQ(bridge::mergedRungs(0b101011), 0b101010U);
    EXPECT_EQ(bridge::mergedRungs(0), 0U);
    for (bridge::RungMask mask = 1; mask < 64; ++mask) {
        const bridge::RungMask merged = bridge::mergedRungs(mask);
        EXPECT_EQ(merged & ~mask, 0U);
        EXPECT_LE(std::popcount(merged), bridge::kMaxRungs);
        EXPECT_EQ(std::bit_width(merged), std::bit_width(mask))
            << "the coarsest one stays: it serves all others";
    }
}

} // namespace
