#include "rtcore/look/walk_grid.h"

#include "support/rooms.h"

#include <gtest/gtest.h>

#include <cmath>
#include <span>
#include <vector>

namespace {

using rtcore::Camera;

std::vector<Camera> gridOf(const test::TracedScene& s, int maxStands = 120) {
    const rtcore::Survey survey = rtcore::survey(s.tree, s.scene.mesh(), rtcore::Axes({0, 1, 0}));
    return rtcore::walkGrid(s.tree, s.scene.mesh(), survey, maxStands);
}

TEST(WalkGrid, LooksToFourSidesFromTheFloorsOfARoom) {
    const test::TracedScene s(test::room().finish()); // its floor at -2
    const std::vector<Camera> views = gridOf(s);
    ASSERT_GE(views.size(), 40U);
    ASSERT_EQ(views.size() % 4, 0U);
    for (std::size_t i = 0; i < views.size(); ++i) {
        EXPECT_NEAR(views[i].eye.y, -2 + rtcore::kEyeHeight, 1e-3F);
        EXPECT_EQ(views[i].eye, views[i / 4 * 4].eye);
        EXPECT_NEAR(views[i].forward.y, 0, 1e-6F);
        EXPECT_EQ(views[i].horizontalFov, 90);
        if (i % 4 > 0) {
            EXPECT_NEAR(dot(views[i].forward, views[i - 1].forward), 0, 1e-5F);
        }
    }
}

TEST(WalkGrid, StandsThatFollowEachOtherAreNear) {
    const test::TracedScene s(test::room().finish());
    const std::vector<Camera> views = gridOf(s);
    for (std::size_t i = 4; i < views.size(); i += 4)
        EXPECT_LT(length(views[i].eye - views[i - 4].eye), 4) << i;
}

TEST(WalkGrid, HasSoManyStandsAtMostFromEndToEnd) {
    const test::TracedScene s(test::room().finish());
    const std::vector<Camera> all = gridOf(s), some = gridOf(s, 5);
    ASSERT_EQ(some.size(), 20U);
    EXPECT_EQ(some.front(), all.front());
    EXPECT_GT(length(some.back().eye - some.front().eye), 2);
}

TEST(WalkGrid, GoesAroundAnObject) {
    const test::TracedScene s(test::block().finish());
    const std::vector<Camera> views = gridOf(s);
    ASSERT_GE(views.size(), 12U);
    const rtcore::Box3& bounds = s.tree.bounds;
    for (const Camera& view : std::span(views).first(12)) {
        const rtcore::Vec3 to = bounds.centre() - view.eye;
        EXPECT_GT(length(to), 0.5F * bounds.diagonal()) << "outside";
        EXPECT_GT(dot(normalize(to), normalize(view.forward)), 0.999F);
    }
}

TEST(WalkGrid, OfNothingIsEmpty) {
    const test::TracedScene s{rtcore::Scene()};
    EXPECT_TRUE(rtcore::walkGrid(s.tree, s.scene.mesh(), {rtcore::Axes({0, 1, 0}), {}, {}, {}}).empty());
}

} // namespace
