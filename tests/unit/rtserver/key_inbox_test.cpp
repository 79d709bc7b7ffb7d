#include "rtserver/walk/key_inbox.h"

#include <gtest/gtest.h>

namespace {

TEST(KeyInbox, KnowsWhatTheSessionDoesNot) {
    rtserver::KeyInbox inbox;
    ipc::KeyState keys;
    EXPECT_FALSE(inbox.add(keys));
    keys.down.set('W');
    keys.presses['W'] = 1;
    EXPECT_TRUE(inbox.add(keys));
    keys.presses['W'] = 0;
    EXPECT_TRUE(inbox.add(keys)) << "it was not taken yet";
    const ipc::KeyState taken = inbox.take();
    EXPECT_TRUE(taken.down['W']);
    EXPECT_EQ(taken.presses['W'], 1U);
    EXPECT_FALSE(inbox.add(keys)) << "held on";
    keys.down.reset('W');
    EXPECT_TRUE(inbox.add(keys)) << "released";
    EXPECT_EQ(inbox.take().presses['W'], 0U);
}

TEST(KeyInbox, LosesNoTap) {
    rtserver::KeyInbox inbox;
    ipc::KeyState tap;
    tap.presses['B'] = 1;
    EXPECT_TRUE(inbox.add(tap));
    EXPECT_TRUE(inbox.add(tap));
    EXPECT_EQ(inbox.take().presses['B'], 2U);
    EXPECT_EQ(inbox.take().presses['B'], 0U);
}

} // namespace
