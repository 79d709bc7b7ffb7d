// Starting to walk anywhere, and falling out of the world.
#include "walk_world.h"

using rtcore::MotionMode;
using rtcore::Vec3d;
using test::metres;
using test::WalkWorld;

TEST(Entering, keepsTheEyeWhereThereIsRoom) {
    WalkWorld world;
    world.floor();
    rtcore::Walker walker(world.tree(), world.view(), rtcore::WorldFrame({0, 0, 1}, 1), WalkWorld::shape());
    for (const double eye : {1.75, 1.2, 0.7}) {
        ASSERT_TRUE(walker.enter({0, 0, eye}));
        EXPECT_EQ(walker.eye().x, 0);
        EXPECT_NEAR(walker.eye().z, eye, 1e-12);
    }
}

TEST(Entering, movesAsideInSight) {
    WalkWorld world;
    world.floor().box(metres(-5, 0, -1), metres(5, 1, 3));
    rtcore::Walker walker(world.tree(), world.view(), rtcore::WorldFrame({0, 0, 1}, 1), WalkWorld::shape());
    ASSERT_TRUE(walker.enter({0, -0.05, 1.7}));
    EXPECT_LE(walker.eye().y, -0.29);
}

TEST(Entering, refusesWhereThereIsNone) {
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

TEST(Entering, comesBackFromBelowTheWorld) {
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

TEST(Entering, fliesWhereThereIsNoWorld) {
    WalkWorld world;
    world.floor(0, 1);
    const auto player = world.player(30, 0, 0);
    ASSERT_TRUE(player->setMode(MotionMode::Walk));
    for (int i = 0; i < 600; ++i) player->advance(std::chrono::milliseconds(17));
    EXPECT_EQ(player->mode(), MotionMode::View);
    EXPECT_TRUE(isFinite(player->camera().eye));
}

TEST(Entering, worksWithoutTriangles) {
    test::SampleMesh empty;
    const rtcore::KdTree tree = rtcore::buildKdTree(empty.view(), {});
    rtcore::Player player(tree, empty.view(), {});
    player.press(rtcore::Action::Forward);
    player.setMode(MotionMode::Walk);
    for (int i = 0; i < 600; ++i) player.advance(std::chrono::milliseconds(17));
    EXPECT_TRUE(isFinite(player.camera().eye));
}
