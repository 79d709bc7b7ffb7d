// Where one who walks begins.
#include "rtcore/look/doorstep.h"
#include "rtcore/survey/default_view.h"

#include "support/rooms.h"

#include <gtest/gtest.h>

#include <cmath>
#include <utility>

namespace {

using rtcore::Axes;
using rtcore::Camera;
using rtcore::Vec3;

/// 8 x 3 x 6, hollow; with a door of 1 x 2.1 at x = 1.5 in the wall at z = 3, or without.
test::SceneBuilder hut(bool door) {
    test::SceneBuilder b;
    const std::uint32_t white = b.material(test::matte(0.7F));
    b.box({-4, -0.2F, -3}, {4, 0, 3}, white);
    b.box({-4, 3, -3}, {4, 3.2F, 3}, white);
    b.box({-4, 0, -3}, {4, 3, -2.8F}, white);
    b.box({-4, 0, -2.8F}, {-3.8F, 3, 2.8F}, white);
    b.box({3.8F, 0, -2.8F}, {4, 3, 2.8F}, white);
    if (!door) b.box({-4, 0, 2.8F}, {4, 3, 3}, white);
    if (!door) return b;
    b.box({-4, 0, 2.8F}, {1, 3, 3}, white);
    b.box({2, 0, 2.8F}, {4, 3, 3}, white);
    b.box({1, 2.1F, 2.8F}, {2, 3, 3}, white);
    return b;
}

struct Steps {
    explicit Steps(test::SceneBuilder builder, Vec3 eye, float metresPerUnit = 1)
        : scene(builder.finish()),
          survey(rtcore::survey(scene.tree, scene.scene.mesh(), Axes({0, 1, 0}, metresPerUnit))) {
        from.eye = eye;
        from.forward = -eye;
        cameras = rtcore::doorsteps(scene.tree, scene.scene.mesh(), survey, from);
    }
    test::TracedScene scene;
    rtcore::Survey survey;
    Camera from;
    std::vector<Camera> cameras;
};

TEST(Doorstep, IsBeforeTheDoorWhereverOneLooksFrom) {
    for (const Vec3 eye : {Vec3{5, 8, 20}, Vec3{-20, 8, 3}, Vec3{1, 8, -20}}) {
        const Steps steps(hut(true), eye);
        ASSERT_EQ(steps.cameras.size(), 5U);
        const Camera& first = steps.cameras.front();
        EXPECT_NEAR(first.eye.x, 1.5F, 0.1F);
        EXPECT_GT(first.eye.z, 5);
        EXPECT_LT(first.eye.z, 12);
        EXPECT_NEAR(first.eye.y, 1.4F, 0.01F) << "over the lowest point";
        EXPECT_EQ(first.forward, Vec3(0, 0, -1));
    }
}

TEST(Doorstep, IsBeforeTheMiddleOfTheSideThatWasSeen) {
    const Steps steps(hut(false), {-20, 8, 3});
    ASSERT_EQ(steps.cameras.size(), 4U);
    EXPECT_LT(steps.cameras.front().eye.x, -6);
    EXPECT_NEAR(steps.cameras.front().eye.z, 0, 0.01F);
    EXPECT_EQ(steps.cameras.front().forward, Vec3(1, 0, 0));
}

TEST(Doorstep, StandsOnTheGround) {
    test::SceneBuilder b = hut(false);
    b.square({0, -0.2F, 0}, {0, 1, 0}, 50, b.material(test::matte(0.5F)));
    const Steps steps(std::move(b), {2, 8, 20});
    EXPECT_NEAR(steps.cameras.front().eye.y, 1.4F, 0.01F);
    EXPECT_LT(steps.cameras.front().eye.z, 12) << "before the hut, not before the ground";
}

// Not a few steps before the plot.
TEST(Doorstep, IsOnThePlotOfTheHouse) {
    test::SceneBuilder builder = hut(true);
    builder.box({-8, -0.5F, -8}, {8, -0.2F, 8}, builder.material(test::matte(0.3F)));
    const Steps steps(std::move(builder), {5, 8, 20});
    EXPECT_FALSE(steps.survey.subject.ground) << "so small a plot is seen with the house";
    EXPECT_NEAR(steps.cameras.front().eye.x, 1.5F, 0.1F);
    EXPECT_LT(steps.cameras.front().eye.z, 7.9F);
    EXPECT_NEAR(steps.cameras.front().eye.y, 1.4F, 0.01F) << "with its feet on the plot";
}

TEST(Doorstep, OnLandIsWhereOneLooks) {
    test::SceneBuilder b;
    b.square({0, 2, 0}, {0, 1, 0}, 100, b.material(test::matte(0.5F)));
    const Steps steps(std::move(b), {10, 60, 80});
    ASSERT_EQ(steps.cameras.size(), 1U);
    EXPECT_NEAR(steps.cameras.front().eye.y, 3.6F, 0.01F);
    EXPECT_NEAR(steps.cameras.front().forward.y, 0, 1e-5);
    EXPECT_LT(length(steps.cameras.front().eye), 20);
}

TEST(Doorstep, IsForThoseWhoHover) {
    const Steps steps(hut(true), {5, 8, 20});
    const auto hovers = [&](Vec3 eye) {
        return rtcore::hoversOutside(steps.scene.tree, steps.scene.scene.mesh(), steps.survey, eye);
    };
    EXPECT_TRUE(hovers({5, 8, 20}));
    EXPECT_FALSE(hovers({0, 1.6F, 0})) << "in the room";
    EXPECT_FALSE(hovers({0, 1.5F, 8})) << "before the door";
    EXPECT_TRUE(hovers({0, 9, 0})) << "above the roof";
    EXPECT_FALSE(rtcore::isTooSmallToWalk(steps.survey));
    EXPECT_TRUE(rtcore::isTooSmallToWalk(Steps(hut(true), {5, 8, 20}, 0.1F).survey));
}

} // namespace
