#include "common/mirror/state_follower.h"

#include <gtest/gtest.h>

namespace {

TEST(StateFollower, AsksOnceForEachRevision) {
    app::StateFollower follower;
    EXPECT_FALSE(follower.asks()) << "no status yet";
    follower.revision(0);
    EXPECT_TRUE(follower.asks()) << "the first one";
    EXPECT_FALSE(follower.asks()) << "it is under way";
    EXPECT_TRUE(follower.answered(true));
    for (int i = 0; i < 5; ++i) {
        follower.revision(0);
        EXPECT_FALSE(follower.asks());
    }
    EXPECT_TRUE(follower.isCurrent());
    follower.revision(1);
    EXPECT_FALSE(follower.isCurrent());
    EXPECT_TRUE(follower.asks());
    follower.revision(2); // meanwhile
    EXPECT_TRUE(follower.answered(true));
    EXPECT_TRUE(follower.asks()) << "what came while it was asked";
}

TEST(StateFollower, DropsWhatWasAskedBeforeAnEdit) {
    app::StateFollower follower;
    follower.revision(1);
    ASSERT_TRUE(follower.asks());
    follower.edits();
    EXPECT_FALSE(follower.answered(true)) << "it would take the edit back in what is shown";
    EXPECT_TRUE(follower.asks());
    EXPECT_TRUE(follower.answered(true));
}

TEST(StateFollower, AsksAgainWithTheNextStatusWhereTheServerFailed) {
    app::StateFollower follower;
    follower.revision(1);
    ASSERT_TRUE(follower.asks());
    EXPECT_FALSE(follower.answered(false));
    EXPECT_FALSE(follower.asks()) << "not at once, again and again";
    follower.revision(1);
    EXPECT_TRUE(follower.asks());
}

TEST(StateFollower, WaitsForNoAnswerOfAServerThatIsGone) {
    app::StateFollower follower;
    follower.revision(7);
    ASSERT_TRUE(follower.asks());
    follower.forget();
    EXPECT_FALSE(follower.asks());
    follower.revision(7); // of the next server
    EXPECT_TRUE(follower.asks());
    EXPECT_TRUE(follower.answered(true));
    follower.want();
    EXPECT_TRUE(follower.asks());
}

} // namespace
