#include "rtserver/flying.h"

#include <gtest/gtest.h>

namespace {

using rtcore::Vec3;
using rtserver::Action;
using rtserver::Flyer;

constexpr Vec3 kUp{0, 1, 0};

rtcore::Box3 box() {
    rtcore::Box3 bounds;
    bounds.extend(Vec3{0, 0, 0});
    bounds.extend(Vec3{10, 10, 10});
    return bounds;
}

void expectNear(Vec3 a, Vec3 b, float within = 1e-4F) {
    EXPECT_LT(length(a - b), within) << a.x << ' ' << a.y << ' ' << a.z;
}

TEST(Flyer, StandsStillWithoutActions) {
    Flyer flyer({}, box(), kUp);
    EXPECT_FALSE(flyer.advance(1));
    EXPECT_EQ(flyer.camera(), rtcore::Camera{});
}

TEST(Flyer, GoesAsFarInOneStepAsInMany) {
    Flyer once({}, box(), kUp), often({}, box(), kUp);
    once.press(Action::Forward);
    often.press(Action::Forward);
    EXPECT_TRUE(once.advance(1));
    for (int i = 0; i < 100; ++i) often.advance(0.01);
    expectNear(once.camera().eye, often.camera().eye);
    EXPECT_LT(once.camera().eye.z, -1);
}

TEST(Flyer, OppositeActionsCancel) {
    Flyer flyer({}, box(), kUp);
    flyer.press(Action::Left);
    flyer.press(Action::Right);
    EXPECT_FALSE(flyer.advance(1));
}

TEST(Flyer, SlantedIsNoFasterThanStraight) {
    Flyer straight({}, box(), kUp), slanted({}, box(), kUp);
    straight.press(Action::Forward);
    slanted.press(Action::Forward);
    slanted.press(Action::Right);
    straight.advance(1);
    slanted.advance(1);
    EXPECT_NEAR(length(straight.camera().eye), length(slanted.camera().eye), 1e-4);
}

TEST(Flyer, TurnsRightAndUp) {
    Flyer flyer({}, box(), kUp);
    flyer.look(90, 0);
    expectNear(flyer.camera().forward, {1, 0, 0});
    flyer.look(0, 45);
    expectNear(flyer.camera().forward, normalize(Vec3{1, 1, 0}));
    EXPECT_EQ(flyer.camera().up, kUp);
}

TEST(Flyer, NeverLooksStraightUpOrDown) {
    Flyer flyer({}, box(), kUp);
    for (const float way : {1.0F, -1.0F}) {
        for (int i = 0; i < 50; ++i) flyer.look(7, 10 * way);
        EXPECT_GT(length(cross(flyer.camera().forward, flyer.camera().up)), 0.017F);
        EXPECT_GT(flyer.camera().forward.y * way, 0.99F);
    }
}

} // namespace
