#include "rtserver/walk/keyboard.h"

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
    EXPECT_TRUE(state.down['W']);
    EXPECT_TRUE(state.down['S']);
    EXPECT_FALSE(state.down['B']);
    EXPECT_EQ(state.presses['W'], 1U);
    EXPECT_EQ(state.presses['B'], 1U);
    keyboard.release('W');
    ipc::KeyState next;
    keyboard.collect(next);
    EXPECT_TRUE(next.down.none());
    EXPECT_EQ(next.presses['B'], 0U);
}

TEST(Keyboard, ReleasesWhatWasPressedForATime) {
    using namespace std::chrono_literals;
    rtserver::Keyboard keyboard;
    EXPECT_EQ(keyboard.untilRelease(), std::chrono::nanoseconds::max());
    const std::uint64_t first = keyboard.pressFor('W', 100ms);
    const std::uint64_t second = keyboard.pressFor('A', 30ms);
    EXPECT_FALSE(keyboard.advance(1h)) << "nobody has seen it yet";
    ipc::KeyState state;
    keyboard.collect(state);
    EXPECT_EQ(keyboard.untilRelease(), 30ms);
    EXPECT_FALSE(keyboard.advance(29ms));
    EXPECT_TRUE(keyboard.advance(1ms));
    EXPECT_TRUE(keyboard.isDown(first));
    EXPECT_FALSE(keyboard.isDown(second));
    EXPECT_TRUE(keyboard.down()['W']);
    EXPECT_FALSE(keyboard.down()['A']);
    const std::uint64_t third = keyboard.pressFor('W', 500ms);
    keyboard.collect(state);
    EXPECT_FALSE(keyboard.isDown(first)) << "another press took its place";
    EXPECT_FALSE(keyboard.advance(100ms));
    keyboard.press('W');
    EXPECT_FALSE(keyboard.isDown(third));
    EXPECT_FALSE(keyboard.advance(1h));
    EXPECT_TRUE(keyboard.down()['W']) << "held until it is released";
    keyboard.endPress(third);
    EXPECT_TRUE(keyboard.down()['W']) << "no longer that press";
    keyboard.endPress(keyboard.pressFor('W', 1h));
    EXPECT_FALSE(keyboard.down()['W']);
    keyboard.pressFor('Q', 1s);
    keyboard.releaseAll();
    EXPECT_TRUE(keyboard.down().none());
}

} // namespace
