// Random walks: nothing is ever inside the player, and he gets through nothing. RT_WALKS sets their number.
#include "walk_world.h"

#include "support/random_numbers.h"
#include "support/walk_record.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>

using rtcore::Vec3d;
using test::metres;
using test::WalkWorld;

namespace {

constexpr int kTicks = 240;
constexpr double kRadius = 0.29;

int walks(int usual) {
    const char* wanted = std::getenv("RT_WALKS");
    return wanted != nullptr ? std::atoi(wanted) : usual;
}

/// Furniture, ramps, a stair, slits, pillars in a closed room of 16 x 16 x 5 m.
WalkWorld room(std::uint64_t seed) {
    WalkWorld world;
    test::SampleMesh walls = test::boxGrid(4);
    walls.map(
        [](rtcore::Vec3 p) { return metres(8 * double{p.x}, 8 * double{p.y}, 2.5 + 2.5 * double{p.z}); });
    world.add(walls);
    test::Random random(seed);
    const auto place = [&] { return 14 * test::fraction(random) - 7; };
    for (int i = 0; i < 25; ++i) {
        const double x = place(), y = place(), w = 0.2 + test::fraction(random),
                     h = 2 * test::fraction(random) * test::fraction(random);
        const double z = i % 4 == 0 ? 0.5 + test::fraction(random) : -0.5;
        world.box(metres(x, y, z), metres(x + w, y + 0.3 + test::fraction(random), z + 0.5 + h));
    }
    for (int i = 0; i < 6; ++i) {
        const double x = place(), y = place(), slope = 3 * test::fraction(random);
        world.quad(metres(x, y, -0.1), metres(x + 2, y, -0.1), metres(x + 2, y + 1.5, 1.5 * slope),
                   metres(x, y + 1.5, 1.5 * slope));
    }
    for (int i = 0; i < 8; ++i) world.box(metres(5, -7 + 0.3 * i, 0), metres(7, -4, 0.2 * (i + 1)));
    return world;
}

/// Faults that no modeller should leave: duplicates, slivers, points, slits, sheets that end in the air.
WalkWorld soup(std::uint64_t seed) {
    WalkWorld world;
    world.floor(0, 9);
    test::SampleMesh mess = test::soup(250, 0.25F, seed);
    mess.map(
        [](rtcore::Vec3 p) { return metres(6 * double{p.x}, 6 * double{p.y}, 1.2 + 1.5 * double{p.z}); });
    world.add(mess);
    test::Random random(seed + 1);
    for (int i = 0; i < 60; ++i) {
        const rtcore::Vec3 a = random.vector(6), b = a + random.vector(3), c = (a + b) * 0.5F;
        world.mesh().addTriangle(a, b, i % 3 == 0 ? c : i % 3 == 1 ? a : c + random.vector(1e-5F));
    }
    const auto copy = world.mesh().triangles;
    for (std::size_t i = 0; i < copy.size(); i += 4) world.mesh().triangles.push_back(copy[i]);
    return world;
}

/// Walks from places in the box of `lo` and `hi`. Returns how many places had room for a player.
int walkIn(WalkWorld& world, Vec3d lo, Vec3d hi, int count, bool sealed) {
    const rtcore::WorldFrame frame({0, 0, 1}, 1);
    const test::Obstacles all(world.view(), frame);
    const test::WalkJudge judge(all, WalkWorld::shape());
    int walked = 0;
    for (int walk = 0; walk < count && !testing::Test::HasFailure(); ++walk) {
        test::Random random(static_cast<std::uint64_t>(walk));
        rtcore::Walker walker(world.tree(), world.view(), frame, WalkWorld::shape());
        const auto within = [&](double from, double to) {
            return from + (to - from) * test::fraction(random);
        };
        const double x = within(lo.x, hi.x), y = within(lo.y, hi.y);
        if (!walker.enter({x, y, within(lo.z, hi.z)})) continue;
        ++walked;
        test::RandomKeys keys(random);
        const test::WalkRecord record = test::recordWalk(walker, kTicks, [&] { return keys.next(); });
        const test::WalkClearance min = judge.judge(record, random);
        EXPECT_GE(min.atEnds, kRadius - 1e-9) << "walk " << walk << " tick " << min.endsTick;
        EXPECT_GE(min.onTheWay, kRadius - 0.005) << "walk " << walk << " tick " << min.wayTick;
        EXPECT_GE(min.ofEye, 0.05) << "walk " << walk << " tick " << min.eyeTick;
        if (!sealed) continue;
        EXPECT_EQ(record.putBack, 0) << "walk " << walk;
        for (const test::WalkMoment& now : record.moments) {
            EXPECT_LE(std::max(std::fabs(now.feet.x), std::fabs(now.feet.y)), 8 - kRadius);
            EXPECT_GE(now.feet.z, -0.011);
            EXPECT_LE(now.feet.z + now.height, 5.011);
        }
    }
    return walked;
}

} // namespace

TEST(RandomWalk, StaysInTheRoom) {
    WalkWorld world = room(1);
    const int count = walks(40);
    EXPECT_GT(walkIn(world, {-7.5, -7.5, 0.2}, {7.5, 7.5, 4.7}, count, true), count / 2);
}

TEST(RandomWalk, SurvivesASoup) {
    WalkWorld world = soup(3);
    const int count = walks(40);
    EXPECT_GT(walkIn(world, {-7.5, -7.5, 0.2}, {7.5, 7.5, 4.7}, count, false), count / 4);
}
