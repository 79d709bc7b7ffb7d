#include "ipc/platform/error.h"
#include "ipc/platform/names.h"

#include <gtest/gtest.h>

namespace {

using namespace ipc;

TEST(Names, BelongToUserAndInstance) {
    const Names names("view-1_A");
    EXPECT_EQ(names.control(), userPrefix() + "view-1_A.ctl");
    EXPECT_EQ(names.frames(0xAB, 3), userPrefix() + "view-1_A.fab-3");
    EXPECT_EQ(names.slotOfQueue(names.queue(31, 5)), 31);
    EXPECT_EQ(names.slotOfQueue(names.control()), -1);
    EXPECT_EQ(names.slotOfQueue(names.prefix() + "q32-1"), -1);
    EXPECT_EQ(names.slotOfQueue(names.prefix() + "q1"), -1);
    EXPECT_EQ(names.slotOfQueue(Names("other").queue(1, 5)), -1);
}

TEST(Names, CannotLeaveTheirFolder) {
    for (const char* bad :
         {"", ".", "..", "a/b", "a.b", "a b", "\xC3\xA4", "123456789012345678901234567890123"}) {
        try {
            const Names names(bad);
            FAIL() << bad;
        } catch (const Error& error) {
            EXPECT_EQ(error.problem, Problem::BadName);
        }
    }
    EXPECT_NO_THROW(Names("12345678901234567890123456789012"));
}

TEST(Names, TagsDiffer) { EXPECT_NE(randomTag(), randomTag()); }

} // namespace
