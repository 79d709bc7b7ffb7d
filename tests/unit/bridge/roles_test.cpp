#include "bridge/control/roles.h"

#include <gtest/gtest.h>

namespace {

using bridge::Roles;

Roles threePeople() {
    Roles roles;
    roles.join({1, "Anna", true}, 0);
    roles.join({2, "Ben", true}, 0);
    roles.join({3, "Carl", false}, 0);
    return roles;
}

TEST(Roles, TheFirstOneWhoMayDrives) {
    Roles roles;
    roles.join({3, "Carl", false}, 0);
    EXPECT_FALSE(roles.driver());
    roles.join({1, "Anna", true}, 0);
    EXPECT_EQ(roles.driver(), 1U);
    roles.join({2, "Ben", true}, 0);
    EXPECT_EQ(roles.driver(), 1U);
}

TEST(Roles, AViewersLinkNeverDrives) {
    Roles roles = threePeople();
    EXPECT_EQ(roles.ask(3, 100), Roles::Asked::NotAllowed);
    EXPECT_FALSE(roles.give(1, 3, 0));
    EXPECT_EQ(roles.driver(), 1U);
}

TEST(Roles, ADriverHandsOverOrRefuses) {
    Roles roles = threePeople();
    roles.touch(1, 5);
    EXPECT_EQ(roles.ask(2, 6), Roles::Asked::Waits);
    EXPECT_EQ(roles.asking(), std::vector<bridge::SessionId>{2});
    EXPECT_TRUE(roles.keep(1));
    EXPECT_FALSE(roles.tick(30));
    EXPECT_EQ(roles.driver(), 1U);
    EXPECT_FALSE(roles.give(2, 2, 7)) << "who does not drive has nothing to give";
    EXPECT_TRUE(roles.give(1, 2, 7));
    EXPECT_EQ(roles.driver(), 2U);
}

TEST(Roles, WhoeverDoesNotAnswerWithinTenSecondsLosesTheRole) {
    Roles roles = threePeople();
    roles.touch(1, 5);
    roles.ask(2, 6);
    roles.touch(1, 15.5);
    EXPECT_FALSE(roles.tick(15.9));
    EXPECT_TRUE(roles.tick(16.1));
    EXPECT_EQ(roles.driver(), 2U);
    EXPECT_TRUE(roles.asking().empty());
}

TEST(Roles, AnIdleDriverIsReplacedAtOnce) {
    Roles roles = threePeople();
    roles.touch(1, 5);
    EXPECT_EQ(roles.ask(2, 35.1), Roles::Asked::Drives);
    EXPECT_EQ(roles.driver(), 2U);
}

TEST(Roles, ALeavingDriverMakesRoomForWhoeverAsks) {
    Roles roles = threePeople();
    roles.touch(1, 5);
    roles.ask(2, 6);
    roles.leave(1);
    EXPECT_EQ(roles.driver(), 2U);
    roles.leave(2);
    EXPECT_FALSE(roles.driver());
    EXPECT_EQ(roles.people().size(), 1U);
}

} // namespace
