#include "rtserver/keyboard.h"

#include <gtest/gtest.h>

namespace {

TEST(Keyboard, HoldsWhatCommandsPress) {
    rtserver::Keyboard keyboard;
    keyboard.press('W');
    keyboard.press('W');
    keyboard.tap('B');
    ipc::KeyState state;
    state.down.set('S');
    keyboard.collect(state);
    EXPECT_TRUE(state.held('W'));
    EXPECT_TRUE(state.held('S'));
    EXPECT_FALSE(state.held('B'));
    EXPECT_EQ(state.pressed('W'), 1U);
    EXPECT_EQ(state.pressed('B'), 1U);
    keyboard.release('W');
    ipc::KeyState next;
    keyboard.collect(next);
    EXPECT_TRUE(next.down.none());
    EXPECT_EQ(next.pressed('B'), 0U);
}

} // namespace
