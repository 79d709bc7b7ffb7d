// Starting to walk anywhere, and falling out of the world.
#include "walk_world.h"

using rtcore::MotionMode;
using rtcore::Vec3d;
using test::metres;
using test::WalkWorld;

TEST(Entering, KeepsTheEyeWhereThereIsRoom) {
    WalkWorld world;
    world.floor();
    rtcore::Walker walker(world.tree(), world.view(), rtcore::WorldFrame({0, 0, 1}, 1), WalkWorld::shape());
    for (const double eye : {1.75, 1.2, 0.7}) {
        ASSERT_TRUE(walker.enter({0, 0, eye}));
        EXPECT_EQ(walker.eye().x, 0);
        EXPECT_NEAR(walker.eye().z, eye, 1e-12);
    }
}

TEST(Entering, MovesAsideInSight) {
    WalkWorld world;
    world.floor().box(metres(-5, 0, -1), metres(5, 1, 3));
    rtcore::Walker walker(world.tree(), world.view(), rtcore::WorldFrame({0, 0, 1}, 1), WalkWorld::shape());
    ASSERT_TRUE(walker.enter({0, -0.05, 1.7}));
    EXPECT_LE(walker.eye().y, -0.29);
}

TEST(Entering, RefusesWhereThereIsNone) {
    WalkWorld world;
    world.floor().box(metres(-0.2, -0.2, 1), metres(0.2, 0.2, 1.4));
    rtcore::Walker walker(world.tree(), world.view(), rtcore::WorldFrame({0, 0, 1}, 1), WalkWorld::shape());
    const rtcore::WalkState before = walker.state();
    EXPECT_FALSE(walker.enter({0, 0, 1.2}));
    EXPECT_EQ(walker.state(), before);
    const auto player = world.player(0, 0, 1.2 - 1.7);
    EXPECT_FALSE(player->setMode(MotionMode::Walk));
    EXPECT_EQ(player->mode(), MotionMode::View);
}

TEST(Entering, ComesBackFromBelowTheWorld) {
    WalkWorld world;
    world.floor(0, 4);
    const auto walker = world.walker(0, 0, 0);
    test::stand(*walker, 200);
    bool fell = false;
    for (int i = 0; i < 1200; ++i) {
        ASSERT_TRUE(walker->tick(test::ahead()));
        fell = fell || walker->state().feet.z < -5;
        if (fell && walker->state().feet.z > -1) break;
    }
    EXPECT_TRUE(fell);
    EXPECT_NEAR(walker->state().feet.z, 0, 1e-3);
}

TEST(Entering, WalksOnAnUnseenFloorBesideAModel) {
    WalkWorld world;
    world.box(metres(-1, -2, 0.2), metres(1, 2, 1.5)); // a car, say
    const auto player = world.player(30, 0, 1);
    ASSERT_TRUE(player->setMode(MotionMode::Walk));
    EXPECT_TRUE(player->onUnseenFloor());
    for (int i = 0; i < 120; ++i) player->advance(std::chrono::milliseconds(17));
    EXPECT_EQ(player->mode(), MotionMode::Walk);
    EXPECT_NEAR(player->camera().eye.z, 0.2 + 1.7, 0.01) << "its lowest point";
    EXPECT_TRUE(player->atRest());
    player->hold(test::only(rtcore::Action::Forward));
    for (int i = 0; i < 600; ++i) player->advance(std::chrono::milliseconds(17));
    EXPECT_GT(player->camera().eye.y, 25) << "it reaches everywhere";
    EXPECT_NEAR(player->camera().eye.z, 0.2 + 1.7, 0.01);
    player->setMode(MotionMode::View);
    EXPECT_FALSE(player->onUnseenFloor());
}

TEST(Entering, RunsIntoTheModelOnTheUnseenFloor) {
    WalkWorld world;
    world.box(metres(-5, 3, 0), metres(5, 6, 4));
    const auto walker = world.walker(0, 0, 0);
    EXPECT_TRUE(walker->onUnseenFloor());
    test::walkFor(*walker, test::ahead(), 300);
    EXPECT_LE(walker->state().feet.y, 3 - 0.29);
    EXPECT_GT(walker->state().feet.y, 2.5);
    EXPECT_NEAR(walker->state().feet.z, 0, 0.02);
}

TEST(Entering, KnowsNoUnseenFloorWhereSomethingIsBelow) {
    WalkWorld world;
    world.floor(0, 4);
    for (const double x : {0.0, 4.2}) { // half of the body is over the edge
        const auto player = world.player(x, 0, 0);
        ASSERT_TRUE(player->setMode(MotionMode::Walk));
        EXPECT_FALSE(player->onUnseenFloor()) << x;
    }
    const auto below = world.player(0, 0, -10);
    EXPECT_FALSE(below->setMode(MotionMode::Walk)) << "nothing carries there";
    EXPECT_EQ(below->mode(), MotionMode::View);
}

// A floor that is too steep to stand on, and nothing behind its lower edge.
TEST(Entering, BringsBackToWhereHeFlewWhoNeverStood) {
    WalkWorld world;
    world.quad(metres(-3, 0, 0), metres(3, 0, 0), metres(3, 2, 6), metres(-3, 2, 6));
    const auto player = world.player(0, 1, 3.5);
    const rtcore::Vec3 eye = player->camera().eye;
    ASSERT_TRUE(player->setMode(MotionMode::Walk));
    ASSERT_FALSE(player->onUnseenFloor());
    for (int i = 0; i < 900 && player->mode() == MotionMode::Walk; ++i)
        player->advance(std::chrono::milliseconds(17));
    EXPECT_EQ(player->mode(), MotionMode::View);
    player->advance(std::chrono::milliseconds(17));
    EXPECT_NEAR(length(player->camera().eye - eye), 0, 1e-4);
}

TEST(Entering, ComesBackToWhereItStoodForAMomentOnly) {
    WalkWorld world;
    world.floor(0, 0.6);
    const auto player = world.player(0, 0, 0);
    ASSERT_TRUE(player->setMode(MotionMode::Walk));
    player->hold(test::only(rtcore::Action::Forward));
    bool fell = false;
    for (int i = 0; i < 900 && player->mode() == MotionMode::Walk; ++i) {
        player->advance(std::chrono::milliseconds(17));
        if (player->camera().eye.z < -5) {
            fell = true;
            player->hold({});
        }
    }
    EXPECT_TRUE(fell);
    EXPECT_EQ(player->mode(), MotionMode::Walk);
    EXPECT_NEAR(player->camera().eye.z, 1.7, 0.02);
}

TEST(Entering, WorksWithoutTriangles) {
    test::SampleMesh empty;
    const rtcore::KdTree tree = rtcore::buildKdTree(empty.view(), {});
    rtcore::Player player(tree, empty.view(), {});
    player.hold(test::only(rtcore::Action::Forward));
    player.setMode(MotionMode::Walk);
    for (int i = 0; i < 600; ++i) player.advance(std::chrono::milliseconds(17));
    EXPECT_TRUE(isFinite(player.camera().eye));
}
