#include "rtcore/scene/revisions.h"

#include <gtest/gtest.h>

namespace rtcore {
namespace {

TEST(Revisions, BeginWithNothing) {
    const Revisions revisions;
    EXPECT_EQ(revisions.revision(), 0U);
    EXPECT_FALSE(revisions.since(0).any());
}

TEST(Revisions, CountEditsAndTellTheirKinds) {
    Revisions revisions;
    revisions.note(Changes::all());
    revisions.note({Change::Light, Change::Sky});
    revisions.note({Change::View});
    revisions.note({Change::Light});
    EXPECT_EQ(revisions.revision(), 4U);
    EXPECT_EQ(revisions.since(0), Changes::all());
    EXPECT_EQ(revisions.since(1), (Changes{Change::View, Change::Light, Change::Sky}));
    EXPECT_EQ(revisions.since(2), (Changes{Change::View, Change::Light}));
    EXPECT_EQ(revisions.since(3), Changes{Change::Light});
    EXPECT_EQ(revisions.since(4), Changes{});
}

TEST(Revisions, AnEditThatChangesNothingIsNone) {
    Revisions revisions;
    revisions.note({});
    EXPECT_EQ(revisions.revision(), 0U);
}

TEST(Changes, AreASet) {
    Changes changes{Change::View, Change::Setting};
    EXPECT_TRUE(changes.has(Change::View));
    EXPECT_FALSE(changes.has(Change::Sky));
    EXPECT_TRUE(changes.hasAny({Change::Sky, Change::Setting}));
    EXPECT_FALSE(changes.hasAny({Change::Sky, Change::Scene}));
    changes.set(Change::View, false);
    EXPECT_EQ(changes, Changes{Change::Setting});
}

TEST(Subscription, TellsEachChangeOnce) {
    Revisions revisions;
    revisions.note({Change::Scene});
    Subscription early, late;
    EXPECT_EQ(early.take(revisions), Changes{Change::Scene});
    revisions.note({Change::View});
    revisions.note({Change::Material});
    EXPECT_EQ(early.take(revisions), (Changes{Change::View, Change::Material}));
    EXPECT_EQ(early.take(revisions), Changes{});
    EXPECT_EQ(late.take(revisions), (Changes{Change::Scene, Change::View, Change::Material}));
}

} // namespace
} // namespace rtcore
