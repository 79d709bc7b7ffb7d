#include "rtcore/look/sun_of_view.h"

#include "support/rooms.h"

#include "rtcore/kernels/single_ray.h"
#include "rtcore/survey/default_view.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace {

using rtcore::Vec3;

TEST(SunOfView, StandsBehindTheViewersLeftShoulder) {
    const test::TracedScene s(test::block().finish());
    for (const Vec3 up : {Vec3{0, 1, 0}, Vec3{0, 0, 1}, Vec3{-1, 0, 0}}) {
        const rtcore::Camera camera = rtcore::defaultCamera(
            s.tree, s.scene.mesh(), rtcore::survey(s.tree, s.scene.mesh(), rtcore::Axes(up)));
        const Vec3 sun = rtcore::sunOfView(s.tree, s.scene.mesh(),
                                           rtcore::survey(s.tree, s.scene.mesh(), rtcore::Axes(up)), camera);
        EXPECT_NEAR(length(sun), 1, 1e-5);
        EXPECT_NEAR(dot(sun, up), std::sin(40 * test::kPi / 180), 1e-5);
        EXPECT_LT(dot(sun, camera.forward), 0) << "behind";
        EXPECT_LT(dot(sun, cross(camera.forward, up)), 0) << "left";
    }
}

TEST(SunOfView, LooksStraightDownToo) {
    const test::TracedScene s(test::block().finish());
    rtcore::Camera camera;
    camera.eye = {0, 5, 0};
    camera.forward = {0, -1, 0};
    camera.up = {0, 0, -1};
    const Vec3 sun = rtcore::sunOfView(
        s.tree, s.scene.mesh(), rtcore::survey(s.tree, s.scene.mesh(), rtcore::Axes({0, 1, 0})), camera);
    EXPECT_NEAR(length(sun), 1, 1e-5);
    EXPECT_NEAR(sun.y, std::sin(40 * test::kPi / 180), 1e-5);
}

TEST(SunOfView, ShinesIntoACourtWhereItIsSeen) {
    const test::TracedScene s(test::room(true).finish());
    rtcore::Camera camera;
    camera.eye = {0, -1, 0};
    camera.forward = {1, 0, 0};
    const Vec3 sun = rtcore::sunOfView(
        s.tree, s.scene.mesh(), rtcore::survey(s.tree, s.scene.mesh(), rtcore::Axes({0, 1, 0})), camera);
    EXPECT_GT(sun.y, 0.3F);
    EXPECT_LT(sun.x, 0) << "on the wall that is looked at";
    EXPECT_FALSE(rtcore::occluded(s.tree, s.scene.mesh(),
                                  {{5.9F, 1.5F, 0}, 0, sun, std::numeric_limits<float>::max()}));
}

} // namespace
