#include "rtcore/motion/key_bindings.h"

#include <gtest/gtest.h>

#include <algorithm>

using rtcore::Action;
using rtcore::ActionTap;
using rtcore::KeyBindings;

namespace {

KeyBindings::Down down(std::initializer_list<int> keys) {
    KeyBindings::Down set;
    for (const int key : keys) set.set(static_cast<std::size_t>(key));
    return set;
}
KeyBindings::Presses presses(std::initializer_list<int> keys) {
    KeyBindings::Presses counts{};
    for (const int key : keys) ++counts[static_cast<std::size_t>(key)];
    return counts;
}

} // namespace

TEST(KeyBindings, HeldKeysAct) {
    const KeyBindings bindings;
    const auto set = bindings.held(down({'W', 'D', rtcore::KeyShift}));
    EXPECT_TRUE(set.has(Action::Forward));
    EXPECT_TRUE(set.has(Action::Right));
    EXPECT_TRUE(set.has(Action::Sprint));
    EXPECT_FALSE(set.has(Action::Back));
    EXPECT_EQ(set.balance(Action::Forward, Action::Back), 1);
    EXPECT_TRUE(bindings.held({}).none());
}

TEST(KeyBindings, ASecondKeyTakesOver) {
    const KeyBindings bindings;
    EXPECT_TRUE(bindings.held(down({rtcore::KeyLeft})).has(Action::Left));
    const auto set = bindings.held(down({rtcore::KeyLeft, rtcore::KeyCapsLock}));
    EXPECT_TRUE(set.has(Action::TurnLeft));
    EXPECT_FALSE(set.has(Action::Left));
    EXPECT_EQ(bindings.taps({}, presses({'3'})), (std::vector<ActionTap>{{Action::ToggleLight, 3}}));
    EXPECT_EQ(bindings.taps(down({'M'}), presses({'0'})),
              (std::vector<ActionTap>{{Action::SelectEnvironment, 10}}));
}

TEST(KeyBindings, NoTapIsLost) {
    const KeyBindings bindings;
    const std::vector<ActionTap> sky{{Action::SelectEnvironment, 3}};
    EXPECT_EQ(bindings.taps({}, presses({'M', '3'})), sky) << "both within a moment";
    EXPECT_EQ(bindings.taps({}, presses({'3'}), down({'M'})), sky) << "M is up again";
    EXPECT_EQ(bindings.taps({}, presses({'F', 'F', 'F'})).size(), 3U);
    EXPECT_EQ(bindings.taps({}, presses({'W', 'W'})), (std::vector<ActionTap>{{Action::Forward, 0}}));
    EXPECT_TRUE(bindings.taps(down({'W'}), presses({'W'})).empty()); // it is held
    KeyBindings::Presses many{};
    many['F'] = 4'000'000'001U;
    const std::size_t taps = bindings.taps({}, many).size();
    EXPECT_EQ(taps % 2, 1U);
    EXPECT_LT(taps, 100U);
}

TEST(KeyBindings, OthersCanBeGiven) {
    const rtcore::KeyBinding own[] = {{'Q', Action::Left}, {300, Action::Jump}, {-1, Action::Jump}};
    const KeyBindings bindings(own);
    EXPECT_EQ(bindings.list().size(), 1U);
    EXPECT_TRUE(bindings.held(down({'Q'})).has(Action::Left));
    EXPECT_TRUE(bindings.held(down({'W'})).none());
}

TEST(KeyBindings, DefaultsAreDistinct) {
    const auto all = rtcore::defaultKeyBindings();
    for (std::size_t i = 0; i < all.size(); ++i) {
        EXPECT_NE(all[i].key, rtcore::KeyNone);
        EXPECT_FALSE(rtcore::keyName(all[i].key).empty());
        for (std::size_t j = 0; j < i; ++j) {
            EXPECT_FALSE(all[i].key == all[j].key && all[i].with == all[j].with)
                << rtcore::keyName(all[i].key);
        }
    }
}

TEST(KeyBindings, NamesGoBothWays) {
    int keys = 0;
    for (int key = 0; key < rtcore::kKeyCodes; ++key) {
        const std::string name = rtcore::keyName(key);
        if (name.empty()) continue;
        ++keys;
        EXPECT_EQ(rtcore::keyNamed(name), key) << name;
    }
    EXPECT_GT(keys, 80);
    EXPECT_EQ(rtcore::keyNamed("capslock"), int{rtcore::KeyCapsLock});
    EXPECT_EQ(rtcore::keyNamed("w"), int{'W'});
    for (const char* wrong : {"", "ww", "\xc3\xa9", " ", "F99"})
        EXPECT_FALSE(rtcore::keyNamed(wrong)) << wrong;
    for (std::size_t i = 0; i < rtcore::kActions; ++i) {
        const auto action = static_cast<Action>(i);
        EXPECT_EQ(rtcore::actionNamed(rtcore::actionName(action)), action);
    }
    EXPECT_FALSE(rtcore::actionNamed("fly"));
}
