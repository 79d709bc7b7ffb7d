#include "bridge/control/locked_keys.h"

#include <gtest/gtest.h>

namespace {

constexpr const char* kBindings =
    "W forward\nF toggleWalk\nB toggleBloom\n1 toggleLight 1\nM+2 selectEnvironment 2\nQ dance";

std::string heldOf(const bridge::LockedKeys& keys) {
    const bridge::InputMessage left =
        keys.allowed({1, 0, 0, {'W', 'F', 'B', '1', '2', 'Q', 'M'}, {'B', 'W'}});
    return std::string(left.held.begin(), left.held.end()) + "," +
           std::string(left.taps.begin(), left.taps.end());
}

TEST(LockedKeys, OfEditsAreAllThatDoNotMove) {
    const bridge::Limits limits{.locked = {"edits"}};
    bridge::LockedKeys keys(limits);
    EXPECT_TRUE(keys.possible());
    EXPECT_EQ(heldOf(keys), ",") << "nobody knows yet what they do";
    keys.read(kBindings);
    EXPECT_EQ(heldOf(keys), "WFM,W");
    keys.read("B forward\nW toggleBloom");
    EXPECT_EQ(heldOf(keys), "FB12QM,B") << "others since then";
    keys.forget();
    EXPECT_EQ(heldOf(keys), ",");
    for (const char* odd : {"", "\n\n", " ", "W", "+", "M+", "nokey forward"}) {
        keys.read(odd);
        EXPECT_EQ(heldOf(keys), std::string_view(odd) == "W" ? "FB12QM,B" : "WFB12QM,BW") << odd;
    }
}

TEST(LockedKeys, OfBloomAreThatOne) {
    const bridge::Limits limits{.locked = {"bloom.radius"}};
    bridge::LockedKeys keys(limits);
    keys.read(kBindings);
    EXPECT_EQ(heldOf(keys), "WF12QM,W");
}

TEST(LockedKeys, AreNoneWithoutALock) {
    const bridge::Limits limits{.locked = {"maxDepth"}};
    const bridge::LockedKeys keys(limits);
    EXPECT_FALSE(keys.possible());
    EXPECT_EQ(heldOf(keys), "WFB12QM,BW");
}

} // namespace
