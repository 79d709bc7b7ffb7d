// Places that buildings have and bodies do not like: narrow doors, thin walls, spiral stairs, low ceilings,
// and the alley between two blocks.
#include "walk_world.h"

#include <algorithm>
#include <cmath>
#include <vector>

using rtcore::Vec3d;
using rtcore::WalkInput;
using test::ahead;
using test::metres;
using test::stand;
using test::walkFor;
using test::WalkWorld;

namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr double kRadius = 0.29;

/// A wall across the y axis at y = 2, so thick, with a door in the middle.
WalkWorld door(double width, double height, double thick) {
    WalkWorld world;
    world.floor();
    world.box(metres(-5, 2, -1), metres(-width / 2, 2 + thick, 3));
    world.box(metres(width / 2, 2, -1), metres(5, 2 + thick, 3));
    return world.box(metres(-width / 2, 2, height), metres(width / 2, 2 + thick, 3));
}

/// Wedge-shaped steps around the z axis between two radii, with the newel and the wall around it: `turns` of
/// sixteen steps each.
WalkWorld spiral(double inner, double outer, double rise, int turns) {
    WalkWorld world;
    world.floor();
    const auto at = [](double radius, double angle, double z) {
        return metres(radius * std::sin(angle), radius * std::cos(angle), z);
    };
    for (int i = 0; i < 16 * turns; ++i) {
        const double a = i * kPi / 8, b = (i + 1) * kPi / 8, z = (i + 1) * rise,
                     top = (16 * turns + 20) * rise;
        world.quad(at(inner, a, z), at(inner, b, z), at(outer, b, z), at(outer, a, z));
        world.quad(at(inner, a, z - rise), at(inner, a, z), at(outer, a, z), at(outer, a, z - rise));
        if (i >= 16) continue;
        world.quad(at(inner, a, -1), at(inner, b, -1), at(inner, b, top), at(inner, a, top));
        if (i > 0) world.quad(at(outer, a, -1), at(outer, b, -1), at(outer, b, top), at(outer, a, top));
    }
    return world;
}

/// The greatest change of the eye's velocity between two frames at 60 Hz, metres a frame.
class EyeJerk {
  public:
    void look(Vec3d eye) {
        eyes_.push_back(eye);
        const std::size_t n = eyes_.size();
        if (n < 5 || n % 2 == 0) return;
        const Vec3d change = eyes_[n - 1] - eyes_[n - 3] - (eyes_[n - 3] - eyes_[n - 5]);
        upright = std::max(upright, std::fabs(change.z));
        max = std::max(max, length(change));
    }
    double upright = 0, max = 0;

  private:
    std::vector<Vec3d> eyes_;
};

} // namespace

TEST(AwkwardPlaces, DoorsThatAreWideEnough) {
    for (const double width : {0.60, 0.65, 0.70}) {
        for (const double aside : {0.0, 0.2}) {
            for (const double turned : {0.0, 20.0}) {
                WalkWorld world = door(width, 2, 0.2);
                const auto walker = world.walker(-aside, 0, 0);
                stand(*walker);
                // Whoever comes in askew or beside the middle is led in by the frame's edges, or slides along
                // the wall: then he steps aside until the door lets him.
                walkFor(*walker, ahead(turned), 90);
                for (int i = 0; i < 480 && walker->state().feet.y < 2.6; ++i) {
                    WalkInput input = ahead();
                    input.right = walker->state().feet.x < 0 ? 0.2 : -0.2;
                    walker->tick(input);
                }
                EXPECT_GT(walker->state().feet.y, 2.6) << width << " " << aside << " " << turned;
            }
        }
    }
    WalkWorld low = door(0.8, 1.7, 0.2);
    const auto walker = low.walker(0, 0, 0);
    stand(*walker);
    walkFor(*walker, ahead(), 180);
    EXPECT_LT(walker->state().feet.y, 2);
    WalkInput crouched = ahead();
    crouched.crouch = true;
    walkFor(*walker, crouched, 240);
    EXPECT_GT(walker->state().feet.y, 2.6);
}

TEST(AwkwardPlaces, WallsThinnerThanTheBody) {
    for (const double thick : {0.0, 0.001, 0.1}) {
        for (const bool sprints : {false, true}) {
            WalkWorld world;
            world.floor();
            if (thick > 0) {
                world.box(metres(-50, 1, -1), metres(50, 1 + thick, 4));
            } else {
                world.quad(metres(-50, 1, -1), metres(50, 1, -1), metres(50, 1, 4), metres(-50, 1, 4));
            }
            const auto walker = world.walker(0, -4, 0);
            stand(*walker);
            for (int i = 0; i < 600; ++i) {
                WalkInput input = ahead(i < 300 ? 0 : 30);
                input.sprint = sprints;
                input.jump = i % 50 == 0;
                walker->tick(input);
                ASSERT_LE(walker->state().feet.y, 1 - kRadius + 1e-9);
            }
        }
    }
}

TEST(AwkwardPlaces, SpiralStairs) {
    constexpr double kInner = 0.15, kOuter = 1.15, kRise = 0.19;
    WalkWorld world = spiral(kInner, kOuter, kRise, 2);
    const auto walker = world.walker(0, 0.65, 3 * kRise);
    stand(*walker);
    EyeJerk jerk;
    // He looks along the stairs, as one does.
    const auto around = [&](double way) {
        const Vec3d feet = walker->state().feet;
        WalkInput input;
        input.ahead = normalize(Vec3d{feet.y * way, -feet.x * way, 0});
        input.forward = 1;
        walker->tick(input);
        jerk.look(walker->eye());
    };
    int ticks = 0;
    const double top = 30 * kRise;
    for (; walker->state().feet.z < top && ticks < 1200; ++ticks) around(1);
    EXPECT_GE(walker->state().feet.z, top);
    EXPECT_LT(ticks, 600);
    for (ticks = 0; walker->state().feet.z > 3 * kRise && ticks < 1200; ++ticks) around(-1);
    EXPECT_LE(walker->state().feet.z, 3 * kRise);
    EXPECT_LT(ticks, 600);
    EXPECT_LT(jerk.upright, 0.0095);
}

TEST(AwkwardPlaces, ASlopeThatEndsAtAWall) {
    WalkWorld world;
    world.floor();
    world.quad(metres(-5, 0, 0), metres(5, 0, 0), metres(5, 3, 3), metres(-5, 3, 3));
    world.box(metres(-5, 3, -1), metres(5, 4, 8));
    const auto walker = world.walker(0, -1, 0);
    stand(*walker);
    walkFor(*walker, ahead(), 360);
    const Vec3d there = walker->state().feet;
    EXPECT_NEAR(there.y, 3 - 0.3, 0.01);
    EXPECT_TRUE(walker->state().grounded);
    EyeJerk jerk;
    for (int i = 0; i < 120; ++i) {
        walker->tick(ahead());
        jerk.look(walker->eye());
    }
    EXPECT_LT(jerk.max, 1e-4);
    stand(*walker);
    EXPECT_LT(length(walker->state().feet - there), 1e-3);
    EXPECT_TRUE(walker->atRest());
    walkFor(*walker, ahead(180), 180);
    EXPECT_LT(walker->state().feet.y, 0);
}

TEST(AwkwardPlaces, StairsUnderALowCeiling) {
    for (const double room : {1.9, 1.7}) {
        WalkWorld world;
        world.floor();
        for (int i = 0; i < 10; ++i) world.box(metres(-2, 0.3 * i, -1), metres(2, 30, 0.17 * (i + 1)));
        world.box(metres(-2, 2, 1.7 + room), metres(2, 30, 6));
        const auto walker = world.walker(0, -1, 0);
        stand(*walker);
        walkFor(*walker, ahead(), 300);
        const bool fits = room > 1.8;
        EXPECT_EQ(walker->state().feet.y > 4, fits) << walker->state().feet.y;
        // Jumping there neither gets him through the ceiling nor stuck.
        WalkInput jump = ahead();
        for (int i = 0; i < 240; ++i) {
            jump.jump = i % 40 == 0;
            walker->tick(jump);
            if (walker->state().feet.y > 2.3) {
                ASSERT_LE(walker->state().feet.z + walker->state().height, 1.7 + room + 0.01);
            }
        }
        WalkInput crouched = ahead();
        crouched.crouch = true;
        walkFor(*walker, crouched, 300);
        EXPECT_GT(walker->state().feet.y, 4);
        walkFor(*walker, ahead(180), 900);
        EXPECT_LT(walker->state().feet.y, 0);
        EXPECT_NEAR(walker->state().feet.z, 0, 1e-3);
    }
}

TEST(AwkwardPlaces, PressingAgainstWallsDoesNotTremble) {
    WalkWorld world;
    world.floor().box(metres(-5, 1, -1), metres(5, 2, 3)).box(metres(1, -5, -1), metres(2, 5, 3));
    for (const double angle : {0.0, 2.0, 45.0, 60.0}) {
        const auto walker = world.walker(0.2, 0.2, 0);
        stand(*walker);
        walkFor(*walker, ahead(angle), 600);
        EyeJerk jerk;
        for (int i = 0; i < 120; ++i) {
            walker->tick(ahead(angle));
            jerk.look(walker->eye());
        }
        EXPECT_LT(jerk.max, 5e-5) << angle;
    }
}

// Walls 0.43 m high on both sides, nearer than the player's skin, and a stair between them: walked askew he
// comes upon the walls first, and their diagonals are no obstacles.
TEST(AwkwardPlaces, StairsInANarrowAlley) {
    WalkWorld world;
    world.floor(0, 20);
    world.box(metres(-3, -3, -1), metres(-0.2911, 6, 0.43)).box(metres(0.2989, -3, -1), metres(3, 6, 0.43));
    world.box(metres(-1, 1, -1), metres(1, 6, 0.14)).box(metres(-1, 1.4, -1), metres(1, 6, 0.28));
    for (const double angle : {0.0, 30.0, -30.0, 60.0, -60.0}) {
        const auto walker = world.walker(0, 0.6, 0.1);
        stand(*walker);
        walkFor(*walker, ahead(angle), 360);
        EXPECT_GT(walker->state().feet.y, 1.6) << angle;
        const auto back = world.walker(0, 0.6, 0.1);
        stand(*back);
        walkFor(*back, ahead(180 + angle), 360);
        EXPECT_LT(back->state().feet.y, -0.6) << angle;
    }
}

TEST(AwkwardPlaces, TheEyeRidesSmoothlyOverSteps) {
    WalkWorld world;
    world.floor();
    for (int i = 0; i < 20; ++i) world.box(metres(-3, 0.29 * i, -1), metres(3, 30, 0.17 * (i + 1)));
    const auto walker = world.walker(0, -1, 0);
    stand(*walker);
    EyeJerk jerk;
    for (int i = 0; i < 300; ++i) {
        walker->tick(ahead());
        jerk.look(walker->eye());
    }
    EXPECT_GT(walker->state().feet.z, 3.3);
    for (int i = 0; i < 300; ++i) {
        walker->tick(ahead(180));
        if (i > 30) jerk.look(walker->eye());
    }
    EXPECT_LT(jerk.upright, 0.0085);
}
