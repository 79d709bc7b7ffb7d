// Walking in a model that sections cut open: through walls that are taken away, and on floors that are.
#include "walk_world.h"

#include "rtcore/motion/cut_surroundings.h"
#include "support/random_numbers.h"

#include <algorithm>
#include <cmath>
#include <vector>

using rtcore::SectionPlane;
using rtcore::Vec3d;
using test::ahead;
using test::metres;
using test::stand;
using test::walkFor;
using test::WalkWorld;

namespace {

/// What lies at x > `x` is taken away.
std::vector<SectionPlane> from(double x) { return {{metres(x, 0, 0), {1, 0, 0}}}; }

/// A wall across the way, 3 m ahead.
WalkWorld walled() {
    WalkWorld world;
    world.floor();
    return world.box(metres(-5, 3, -1), metres(5, 3.2, 3));
}

TEST(CutSurroundings, LetWalkThroughAWallThatIsTakenAway) {
    WalkWorld world = walled();
    for (const double x : {-2.0, 2.0}) {
        const auto walker = world.walker(x, 0, 0);
        walker->useSections(from(0));
        walkFor(*walker, ahead(), 300);
        if (x < 0) {
            EXPECT_NEAR(walker->state().feet.y, 2.7, 0.02) << "what is left of it";
        } else {
            EXPECT_GT(walker->state().feet.y, 6);
        }
        EXPECT_NEAR(walker->state().feet.z, 0, 0.011) << "the floor carries on both sides";
    }
    const auto again = world.walker(2, 0, 0);
    again->useSections(from(0));
    again->useSections({});
    walkFor(*again, ahead(), 300);
    EXPECT_NEAR(again->state().feet.y, 2.7, 0.02) << "without the section it is there";
}

TEST(CutSurroundings, KeepWhatIsLeftWhole) {
    WalkWorld world = walled();
    const auto walker = world.walker(2, 0, 0);
    const std::vector<std::uint8_t> uncut(world.view().triangles.size(), 1);
    walker->useSections(from(0), uncut);
    walkFor(*walker, ahead(), 300);
    EXPECT_NEAR(walker->state().feet.y, 2.7, 0.02);
}

TEST(CutSurroundings, KeepAFaceInThePlane) {
    WalkWorld world = walled();
    const auto walker = world.walker(0, 0, 0);
    walker->useSections(std::vector<SectionPlane>{{metres(0, 3, 0), {0, -1, 0}}});
    walkFor(*walker, ahead(), 300);
    EXPECT_NEAR(walker->state().feet.y, 2.7, 0.02);
}

TEST(CutSurroundings, LetPassThroughATableAndUnderALintel) {
    WalkWorld world;
    world.floor();
    world.box(metres(-1, 2, 0.7), metres(1, 3, 0.75)).box(metres(-1, 4, 1.5), metres(1, 5, 2.5));
    const auto walker = world.walker(0, 0, 0);
    walker->useSections(from(-2));
    walkFor(*walker, ahead(), 400);
    EXPECT_GT(walker->state().feet.y, 7);
    EXPECT_NEAR(walker->state().feet.z, 0, 0.011);
}

TEST(CutSurroundings, CarryOnStairsThatAreTakenAway) {
    WalkWorld world;
    world.floor();
    for (int i = 0; i < 8; ++i) world.box(metres(-3, 1 + i * 0.28, -1), metres(3, 30, (i + 1) * 0.18));
    const auto walker = world.walker(0, 0, 0);
    walker->useSections(from(-10));
    walkFor(*walker, ahead(), 400);
    EXPECT_NEAR(walker->state().feet.z, 8 * 0.18, 0.011);
}

TEST(CutSurroundings, LetStandInAWallThatIsTakenAway) {
    WalkWorld world = walled();
    rtcore::Walker walker(world.tree(), world.view(), rtcore::WorldFrame({0, 0, 1}, 1), WalkWorld::shape());
    walker.useSections(from(0));
    ASSERT_TRUE(walker.enter({2, 3.1, 1.7}));
    EXPECT_NEAR(walker.state().feet.y, 3.1, 1e-6) << "nothing pushes the body out";
    stand(walker);
    EXPECT_NEAR(walker.state().feet.z, 0, 0.011);
}

// Random triangles and boxes of sections beside points: what is left has just those of the triangle that no
// section takes away.
TEST(CutSurroundings, LeaveWhatNoSectionTakesAway) {
    test::Random random(7);
    const auto exact = [](rtcore::Vec3 v) { return Vec3d{v.x, v.y, v.z}; };
    const auto point = [&] { return exact(random.vector(1)); };
    const auto inside = [](const rtcore::SolidTriangle& t, Vec3d p) {
        const Vec3d n = cross(t.b - t.a, t.c - t.a);
        return dot(cross(t.b - t.a, p - t.a), n) >= 0 && dot(cross(t.c - t.b, p - t.b), n) >= 0 &&
               dot(cross(t.a - t.c, p - t.c), n) >= 0;
    };
    int kept = 0, removed = 0;
    for (int round = 0; round < 200; ++round) {
        std::vector<SectionPlane> planes;
        for (int i = 0; i < 1 + round % 3; ++i) {
            const rtcore::Vec3 at = random.vector(1);
            planes.push_back({at, random.unitVector()});
        }
        const rtcore::CutSurroundings cut(planes, {}, rtcore::WorldFrame({0, 0, 1}, 1), 0, 2);
        const rtcore::SolidTriangle whole = rtcore::solidTriangle(point(), point(), point());
        std::vector<rtcore::SolidTriangle> left;
        cut.cut(whole, {}, 0, left);
        for (int i = 0; i < 50; ++i) {
            double u = test::fraction(random), v = test::fraction(random);
            if (u + v > 1) u = 1 - u, v = 1 - v;
            const Vec3d p = whole.a + (whole.b - whole.a) * u + (whole.c - whole.a) * v;
            double highest = -1;
            for (const SectionPlane& plane : planes) {
                const Vec3d from = p - exact(plane.point);
                highest = std::max(highest, dot(exact(plane.normal), from));
            }
            if (std::fabs(highest) < 1e-5) continue;
            bool found = false;
            for (const rtcore::SolidTriangle& t : left) found = found || inside(t, p);
            EXPECT_EQ(found, highest < 0) << round;
            ++(found ? kept : removed);
        }
    }
    EXPECT_GT(kept, 500);
    EXPECT_GT(removed, 500);
}

} // namespace
