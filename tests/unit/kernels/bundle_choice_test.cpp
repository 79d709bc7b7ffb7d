// Which way of tracing packets is kept, by what they took.
#include "rtcore/kernels/bundle_choice.h"

#include "support/random_numbers.h"

#include <gtest/gtest.h>

namespace {

/// How many of `count` times bundles are chosen where they take `bundles` and packets one by one `packets`
/// seconds, times `work` of each part of an image.
template <typename Work>
int timesBundled(rtcore::BundleChoice& choice, int count, double bundles, double packets, Work&& work) {
    int bundled = 0;
    for (int i = 0; i < count; ++i) {
        const bool chosen = choice.next();
        choice.learn((chosen ? bundles : packets) * work());
        bundled += chosen ? 1 : 0;
    }
    return bundled;
}

const auto kEvenly = [] { return 1e-6; };

TEST(BundleChoice, KeepsTheFasterWay) {
    rtcore::BundleChoice choice;
    EXPECT_GT(timesBundled(choice, 1000, 1, 2, kEvenly), 970);
    rtcore::BundleChoice other;
    EXPECT_LT(timesBundled(other, 1000, 20, 1, kEvenly), 10);
}

TEST(BundleChoice, NoticesThatTheOtherWayIsFasterNow) {
    rtcore::BundleChoice choice;
    timesBundled(choice, 1000, 1, 3, kEvenly);
    timesBundled(choice, 1100, 3, 1, kEvenly);
    EXPECT_LT(timesBundled(choice, 1000, 3, 1, kEvenly), 30);
    timesBundled(choice, 1100, 1, 3, kEvenly);
    EXPECT_GT(timesBundled(choice, 1000, 1, 3, kEvenly), 970);
}

TEST(BundleChoice, IsNotMisledByPartsOfAnImageThatTakeLonger) {
    test::Random random(3);
    rtcore::BundleChoice choice;
    const auto unevenly = [&] { return 1e-6 * (1 + 4 * random.number(0, 1)); };
    EXPECT_GT(timesBundled(choice, 20000, 1, 3, unevenly), 19000);
}

TEST(BundleChoice, StaysWithBundlesWhereNoTimeSeemsToPass) {
    rtcore::BundleChoice choice;
    EXPECT_GT(timesBundled(choice, 1000, 0, 0, kEvenly), 950);
    EXPECT_LT(timesBundled(choice, 1000, 0, 0, kEvenly), 1000);
}

TEST(BundleChoice, TellsTheSameUntilItLearns) {
    rtcore::BundleChoice choice;
    for (int i = 0; i < 20; ++i) EXPECT_TRUE(choice.next());
    choice.learn(1e-6);
    for (int i = 0; i < 20; ++i) EXPECT_FALSE(choice.next());
}

} // namespace
