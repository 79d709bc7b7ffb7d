#include "rtserver/keyboard.h"

#include "common/key_names.h"

#include <gtest/gtest.h>

namespace {

using rtserver::Action;

std::bitset<rtserver::kActions> actions(std::initializer_list<int> keys) {
    std::bitset<ipc::kMaxKeys> down;
    for (const int key : keys) down.set(static_cast<std::size_t>(key));
    return actionsOf(down, rtserver::defaultBindings());
}
std::bitset<rtserver::kActions> just(std::initializer_list<Action> wanted) {
    std::bitset<rtserver::kActions> all;
    for (const Action action : wanted) all.set(static_cast<std::size_t>(action));
    return all;
}

TEST(Bindings, KeysMove) {
    EXPECT_EQ(actions({'W', 'D'}), just({Action::Forward, Action::Right}));
    EXPECT_EQ(actions({app::key::kUp, app::key::kShift}), just({Action::Forward, Action::Sprint}));
    EXPECT_EQ(actions({'Q'}), just({}));
}

TEST(Bindings, CapsLockTurnsInsteadOfMoving) {
    EXPECT_EQ(actions({app::key::kLeft, app::key::kCapsLock}), just({Action::TurnLeft}));
    EXPECT_EQ(actions({app::key::kCapsLock, 'A'}), just({Action::Left}));
}

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
