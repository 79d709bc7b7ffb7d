// The points of a model that a camera sees, and whether light reaches them.
#include "rtcore/look/visible_points.h"

#include "support/rooms.h"

#include <gtest/gtest.h>

#include <span>
#include <vector>

namespace {

using rtcore::Camera;

TEST(VisiblePoints, TellWhetherACameraShowsTheModel) {
    const test::TracedScene s(test::block().finish());
    const rtcore::Box3 box = s.scene.mesh().bounds();
    Camera camera;
    camera.eye = {0, 0, 5};
    EXPECT_TRUE(rtcore::showsModel(rtcore::visiblePoints(s.tree, s.scene.mesh(), camera), box));
    camera.forward = {0, 0, 1};
    EXPECT_FALSE(rtcore::showsModel(rtcore::visiblePoints(s.tree, s.scene.mesh(), camera), box));
    camera = {};
    camera.eye = {0, 0, 200};
    EXPECT_FALSE(rtcore::showsModel(rtcore::visiblePoints(s.tree, s.scene.mesh(), camera), box)) << "a dot";
}

TEST(VisiblePoints, TellWhetherLampsLightIt) {
    const test::TracedScene s(test::block().finish());
    Camera camera;
    camera.eye = {0, 0, 5};
    const std::vector<rtcore::VisiblePoint> points = rtcore::visiblePoints(s.tree, s.scene.mesh(), camera);
    const auto reaches = [&](const rtcore::Light& light) {
        return rtcore::lightReaches(s.tree, s.scene.mesh(), std::span(&light, 1), points,
                                    rtcore::kWhite * 0.15F);
    };
    EXPECT_TRUE(reaches(test::pointLight({0, 0, 4}, 10)));
    EXPECT_FALSE(reaches(test::pointLight({0, 0, -4}, 10))) << "behind it";
    EXPECT_FALSE(reaches(test::pointLight({0, 0, 400}, 10))) << "too far";
    rtcore::Light spot = test::pointLight({0, 0, 4}, 10);
    spot.kind = rtcore::LightKind::Spot;
    spot.cosOuter = 0.9F;
    spot.direction = {0, 0, 1};
    EXPECT_FALSE(reaches(spot)) << "away from it";
    spot.direction = {0, 0, -1};
    EXPECT_TRUE(reaches(spot));
    rtcore::Light off = test::pointLight({0, 0, 4}, 10);
    off.on = 0;
    EXPECT_FALSE(reaches(off));
}

} // namespace
