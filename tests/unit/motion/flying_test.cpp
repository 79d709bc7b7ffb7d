#include "walk_world.h"

#include <cmath>
#include <numbers>

using rtcore::Action;
using rtcore::Camera;
using std::chrono::milliseconds;
using test::metres;
using test::WalkWorld;

namespace {

WalkWorld hall() {
    WalkWorld world;
    world.floor(0, 30);
    return world;
}

/// A tenth of its diagonal in a second.
constexpr double kHallSpeed = 0.1 * std::numbers::sqrt2 * 60;

void fly(rtcore::Player& player, int frames) {
    for (int i = 0; i < frames; ++i) player.advance(milliseconds(20));
}

} // namespace

TEST(Flying, LeavesACameraAsItIs) {
    WalkWorld world = hall();
    const auto player = world.player(0, 0, 0);
    Camera camera;
    camera.eye = {0.1F, 0.7F, 3.3F};
    camera.forward = {0.3F, 1.7F, -0.2F};
    camera.up = {0.1F, 0, 0.9F};
    camera.horizontalFov = 71;
    player->setCamera(camera);
    EXPECT_TRUE(player->atRest());
    fly(*player, 50);
    EXPECT_EQ(player->camera(), camera);
    // Who only moves still looks the same way.
    player->hold(test::only(Action::Forward));
    fly(*player, 5);
    EXPECT_EQ(player->camera().forward, camera.forward);
    EXPECT_NE(player->camera().eye, camera.eye);
    // Who turns keeps heading.
    player->setCamera(camera);
    player->hold({});
    player->look(1e-6, 0);
    const rtcore::Vec3 turned = player->camera().forward, was = normalize(camera.forward);
    EXPECT_LT(length(turned - was), 1e-5F);
}

TEST(Flying, AnOrthographicViewGetsNarrowerInPlaceOfNearer) {
    WalkWorld world = hall();
    const auto player = world.player(0, 0, 0);
    Camera camera;
    camera.eye = {0.1F, 0.7F, 3.3F};
    camera.kind = rtcore::CameraKind::Orthographic;
    camera.orthographicWidth = 8;
    player->setCamera(camera);
    fly(*player, 50);
    EXPECT_EQ(player->camera(), camera);
    player->hold(test::only(Action::Forward));
    fly(*player, 50);
    player->hold({});
    fly(*player, 100);
    EXPECT_TRUE(player->atRest());
    const float narrow = player->camera().orthographicWidth;
    EXPECT_NEAR(narrow, 8 / std::exp(1.0), 0.1);
    EXPECT_EQ(player->camera().eye, camera.eye);
    player->hold(test::only(Action::Back));
    fly(*player, 50);
    player->hold({});
    player->hold(test::only(Action::Right));
    fly(*player, 100);
    EXPECT_NEAR(player->camera().orthographicWidth, 8, 1e-4);
    EXPECT_NE(player->camera().eye, camera.eye);
}

TEST(Flying, MovesByTheSizeOfTheScene) {
    WalkWorld world = hall();
    const auto player = world.player(0, 0, 0);
    player->hold(test::only(Action::Forward));
    fly(*player, 50);
    const rtcore::Vec3 from = player->camera().eye;
    fly(*player, 50);
    const rtcore::Vec3 way = player->camera().eye - from;
    EXPECT_NEAR(way.y, kHallSpeed, 1e-3 * kHallSpeed);
    player->hold({});
    fly(*player, 100);
    EXPECT_TRUE(player->atRest());
}

TEST(Flying, CrossesARoomSlowly) {
    WalkWorld world;
    world.floor(-0.1, 600).box(metres(-3, -2.5, 0), metres(3, 2.5, 2.5));
    const auto speedFrom = [&](rtcore::Vec3 eye) {
        const auto player = world.player(0, 0, 0);
        rtcore::Camera camera = player->camera();
        camera.eye = eye;
        player->setCamera(camera);
        player->hold(test::only(Action::Right));
        fly(*player, 20);
        const rtcore::Vec3 from = player->camera().eye;
        fly(*player, 5);
        return double{length(player->camera().eye - from)} / 0.1;
    };
    const double inside = speedFrom(metres(0, 0, 1.6)), open = speedFrom(metres(0, 20, 30));
    EXPECT_GT(inside, 1);
    EXPECT_LT(inside, 3);
    EXPECT_GT(open, 100);
}

TEST(Flying, TurnsAndLooks) {
    WalkWorld world = hall();
    const auto player = world.player(0, 0, 0);
    player->look(0.5, 0.25);
    const rtcore::Vec3 forward = player->camera().forward;
    EXPECT_NEAR(forward.x, std::sin(0.5) * std::cos(0.25), 1e-6);
    EXPECT_NEAR(forward.y, std::cos(0.5) * std::cos(0.25), 1e-6);
    EXPECT_NEAR(forward.z, std::sin(0.25), 1e-6);
    for (int i = 0; i < 1000; ++i) player->look(0.37, 0.2);
    EXPECT_GT(player->camera().forward.z, 0.99F);
    EXPECT_NEAR(length(player->camera().forward), 1, 1e-5);
    player->look(0, -10);
    EXPECT_LT(player->camera().forward.z, -0.99F);
    player->look(std::nan(""), 1);
    EXPECT_TRUE(isFinite(player->camera().forward));

    player->look(0, 1.5690);
    player->hold(test::only(Action::TurnLeft));
    for (int i = 0; i < 400; ++i) {
        const rtcore::Vec3 before = player->camera().forward;
        player->advance(milliseconds(20));
        EXPECT_LT(length(player->camera().forward - before), 0.04F); // no leap where the angle wraps
    }
}

TEST(Flying, TapMovesALittle) {
    WalkWorld world = hall();
    const auto player = world.player(0, 0, 0);
    const rtcore::Vec3 from = player->camera().eye;
    player->tap(Action::Right);
    EXPECT_FALSE(player->atRest());
    fly(*player, 100);
    EXPECT_TRUE(player->atRest());
    EXPECT_GT(player->camera().eye.x, from.x);
}

TEST(Flying, DoesNotLeapAfterASleep) {
    WalkWorld world = hall();
    const auto player = world.player(0, 0, 0);
    player->hold(test::only(Action::Forward));
    player->advance(std::chrono::hours(3));
    EXPECT_LT(player->camera().eye.y, 0.25 * kHallSpeed);
    player->advance(std::chrono::nanoseconds(-5));
}
