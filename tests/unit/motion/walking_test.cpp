// Walking, falling and jumping against what mechanics says.
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
constexpr double kRadius = 0.29, kReach = 0.30;

/// The highest that the feet get, and the ticks in the air.
struct Jump {
    double apex = 0;
    int ticks = 0;
};
Jump jump(rtcore::Walker& walker, WalkInput input = {}) {
    Jump jump;
    const double from = walker.state().feet.z;
    input.jump = true;
    walker.tick(input);
    for (jump.ticks = 1; !walker.state().grounded && jump.ticks < 1000; ++jump.ticks) {
        jump.apex = std::max(jump.apex, walker.state().feet.z - from);
        walker.tick(input);
    }
    return jump;
}

/// A plane through the x axis that rises by `degrees` along y, beginning at y = 0.
WalkWorld ramp(double degrees) {
    WalkWorld world;
    const double far = 20 * std::cos(degrees * kPi / 180), high = 20 * std::sin(degrees * kPi / 180);
    world.floor();
    world.quad(metres(-5, 0, 0), metres(5, 0, 0), metres(5, far, high), metres(-5, far, high));
    return world;
}

WalkWorld stairs(int steps, double rise, double tread) {
    WalkWorld world;
    world.floor();
    for (int i = 0; i < steps; ++i) {
        world.box(metres(-3, i * tread, -1), metres(3, 30, (i + 1) * rise));
    }
    return world;
}

WalkWorld slit(double width) {
    WalkWorld world;
    world.floor();
    world.box(metres(-5, 2, -1), metres(-width / 2, 3, 3)).box(metres(width / 2, 2, -1), metres(5, 3, 3));
    return world;
}

WalkWorld corridor(double height) {
    WalkWorld world;
    world.floor();
    return world.box(metres(-5, 2, height), metres(5, 6, height + 2));
}

} // namespace

TEST(Walking, StandsStill) {
    WalkWorld world;
    world.floor();
    const auto walker = world.walker(0.3, 0.2, 0.05);
    stand(*walker);
    EXPECT_TRUE(walker->atRest());
    EXPECT_NEAR(walker->state().feet.z, 0, 1e-6);
    EXPECT_NEAR(walker->eye().z, 1.7, 1e-6);
    const rtcore::WalkState before = walker->state();
    stand(*walker, 100);
    EXPECT_EQ(walker->state().feet, before.feet);
}

TEST(Walking, KeepsItsSpeed) {
    WalkWorld world;
    world.floor();
    const auto walker = world.walker(0, 0, 0);
    stand(*walker);
    walkFor(*walker, ahead(30), 240);
    // 9 ticks of acceleration by 40 m/s^2 / 120, then 3 m/s.
    const double expected = (1 + 2 + 3 + 4 + 5 + 6 + 7 + 8) / 3.0 / 120 + 3 * 232.0 / 120;
    EXPECT_NEAR(walker->state().feet.x, expected * std::sin(kPi / 6), 1e-3);
    EXPECT_NEAR(walker->state().feet.y, expected * std::cos(kPi / 6), 1e-3);
    WalkInput sprint = ahead();
    sprint.sprint = true;
    walkFor(*walker, sprint, 60);
    EXPECT_NEAR(length(walker->state().velocity), 6, 1e-9);
    WalkInput diagonal = ahead();
    diagonal.right = 1;
    walkFor(*walker, diagonal, 60);
    EXPECT_NEAR(length(walker->state().velocity), 3, 1e-9);
}

TEST(Walking, JumpsAsHighAsGravityLets) {
    WalkWorld world;
    world.floor();
    const auto walker = world.walker(0, 0, 0);
    stand(*walker);
    const Jump high = jump(*walker);
    EXPECT_NEAR(high.apex, 0.6, 1e-3);
    const double seconds = 2 * std::sqrt(2 * 0.6 / 9.81);
    EXPECT_NEAR(high.ticks, seconds * 120, 2);
    // Held down, it does not jump again.
    WalkInput held;
    held.jump = true;
    walkFor(*walker, held, 60);
    EXPECT_TRUE(walker->state().grounded);
}

TEST(Walking, JumpsLowUnderACeiling) {
    WalkWorld world;
    world.floor().floor(2.0);
    const auto walker = world.walker(0, 0, 0);
    stand(*walker);
    EXPECT_NEAR(jump(*walker).apex, 0.2, 0.011);
}

TEST(Walking, FallsAsFastAsGravityPulls) {
    WalkWorld world;
    world.floor();
    const auto walker = world.walker(0, 0, 10);
    int ticks = 0;
    while (!walker->state().grounded && ticks < 1000) {
        walker->tick({});
        ++ticks;
    }
    EXPECT_NEAR(ticks, std::sqrt(2 * 10 / 9.81) * 120, 1.5);
    EXPECT_NEAR(walker->state().feet.z, 0, 1e-3);
}

TEST(Walking, LandsFromAnyHeight) {
    WalkWorld world;
    world.floor();
    for (const double height : {50.0, 200.0, 701.3, 2000.0}) {
        const auto walker = world.walker(0, 0, height);
        walkFor(*walker, {}, 6000);
        EXPECT_TRUE(walker->state().grounded);
        EXPECT_NEAR(walker->state().feet.z, 0, 1e-3) << height;
    }
}

TEST(Walking, SlidesAlongWalls) {
    for (const double angle : {20.0, 45.0, 70.0}) {
        WalkWorld world;
        world.floor().box(metres(-50, 1, -1), metres(50, 2, 3));
        const auto walker = world.walker(0, 0, 0);
        stand(*walker);
        walkFor(*walker, ahead(angle), 240);
        const double from = walker->state().feet.x;
        walkFor(*walker, ahead(angle), 120);
        EXPECT_NEAR(walker->state().feet.x - from, 3 * std::sin(angle * kPi / 180), 3e-3);
        EXPECT_GE(1 - walker->state().feet.y, kRadius);
        EXPECT_LE(1 - walker->state().feet.y, kReach + 1e-3);
    }
}

TEST(Walking, ClimbsSlopesUpToTheLimit) {
    for (const double degrees : {10.0, 30.0, 45.0}) {
        WalkWorld world = ramp(degrees);
        const auto walker = world.walker(0, -1, 0);
        stand(*walker);
        walkFor(*walker, ahead(), 180);
        const Vec3d from = walker->state().feet;
        walkFor(*walker, ahead(), 120);
        const Vec3d way = walker->state().feet - from;
        EXPECT_NEAR(length(way), 3, 5e-3) << degrees;
        EXPECT_NEAR(way.z, 3 * std::sin(degrees * kPi / 180), 5e-3) << degrees;
        EXPECT_TRUE(walker->state().grounded);
        walkFor(*walker, ahead(180), 60);
        EXPECT_TRUE(walker->state().grounded);
        stand(*walker);
        const Vec3d still = walker->state().feet;
        stand(*walker);
        EXPECT_EQ(walker->state().feet, still);
    }
    WalkWorld steep = ramp(46);
    const auto walker = steep.walker(0, -1, 0);
    stand(*walker);
    walkFor(*walker, ahead(), 360);
    EXPECT_LT(walker->state().feet.z, 0.2);
}

TEST(Walking, SlidesDownWhatIsTooSteep) {
    WalkWorld world = ramp(60);
    const auto walker = world.walker(0, 3, 6);
    walkFor(*walker, {}, 360);
    EXPECT_NEAR(walker->state().feet.z, 0, 1e-3);
    EXPECT_TRUE(walker->state().grounded);
}

TEST(Walking, StepsUpToTheLimit) {
    for (const double height : {0.05, 0.2, 0.4}) {
        WalkWorld world;
        world.floor().box(metres(-5, 1, -1), metres(5, 8, height));
        const auto walker = world.walker(0, 0, 0);
        stand(*walker);
        walkFor(*walker, ahead(), 120);
        EXPECT_NEAR(walker->state().feet.z, height, 1e-3);
        EXPECT_GT(walker->state().feet.y, 2.5) << height;
    }
    WalkWorld world;
    world.floor().box(metres(-5, 1, -1), metres(5, 8, 0.41F));
    const auto walker = world.walker(0, 0, 0);
    stand(*walker);
    walkFor(*walker, ahead(), 120);
    EXPECT_NEAR(walker->state().feet.z, 0, 1e-3);
}

TEST(Walking, ClimbsStairsWithoutShaking) {
    constexpr double kLong = 20 * 0.29;
    for (const double angle : {0.0, 30.0}) {
        WalkWorld world = stairs(20, 0.17, 0.29);
        const auto walker = world.walker(-2, -0.5, 0);
        stand(*walker);
        double eye = walker->eye().z;
        double max = 0;
        const auto step = [&](const WalkInput& input) {
            walker->tick(input);
            EXPECT_TRUE(walker->state().grounded) << walker->state().feet.y;
            max = std::max(max, std::fabs(walker->eye().z - eye));
            eye = walker->eye().z;
        };
        int ticks = 0;
        for (; walker->state().feet.y < kLong && ticks < 1000; ++ticks) step(ahead(angle));
        EXPECT_NEAR(walker->state().feet.z, 3.4, 1e-2);
        EXPECT_LT(ticks, (kLong + 0.5) / (0.95 * 3 * std::cos(angle * kPi / 180)) * 120 + 9);
        for (ticks = 0; walker->state().feet.y > -0.4 && ticks < 1000; ++ticks) step(ahead(180 + angle));
        EXPECT_LT(ticks, (kLong + 0.5) / (0.95 * 3 * std::cos(angle * kPi / 180)) * 120 + 20);
        EXPECT_NEAR(walker->state().feet.z, 0, 1e-2);
        EXPECT_LT(max, 0.030);
    }
}

TEST(Walking, GoesThroughSlitsThatFit) {
    WalkWorld wide = slit(0.60);
    auto walker = wide.walker(0, 0, 0);
    stand(*walker);
    walkFor(*walker, ahead(), 240);
    EXPECT_GT(walker->state().feet.y, 4);

    WalkWorld narrow = slit(0.57);
    walker = narrow.walker(0, 0, 0);
    stand(*walker);
    walkFor(*walker, ahead(), 240);
    EXPECT_LT(walker->state().feet.y, 2.1);
}

TEST(Walking, StandsOnlyWhereThereIsRoom) {
    WalkWorld high = corridor(1.80);
    auto walker = high.walker(0, 0, 0);
    stand(*walker);
    walkFor(*walker, ahead(), 120);
    EXPECT_GT(walker->state().feet.y, 2.5);
    EXPECT_NEAR(walker->state().height, 1.8, 1e-6);

    WalkWorld low = corridor(1.77);
    walker = low.walker(0, 0, 0);
    stand(*walker);
    walkFor(*walker, ahead(), 120);
    EXPECT_LT(walker->state().feet.y, 2);
}

TEST(Walking, CrawlsWhereNobodyCanStand) {
    WalkWorld world = corridor(0.70);
    const auto walker = world.walker(0, 0, 0);
    stand(*walker);
    WalkInput crouch = ahead();
    crouch.crouch = true;
    walkFor(*walker, crouch, 240);
    EXPECT_LT(walker->state().feet.y, 2);
    EXPECT_NEAR(walker->state().height, 1.1, 1e-6);
    WalkInput crawl = ahead();
    crawl.crawl = true;
    walkFor(*walker, crawl, 240);
    EXPECT_GT(walker->state().feet.y, 2.5);
    // Released inside, he goes on crawling.
    walkFor(*walker, ahead(), 240);
    EXPECT_NEAR(walker->state().height, 0.6, 1e-6);
    int ticks = 0;
    for (; walker->state().feet.y < 6.31 && ticks < 2000; ++ticks) walker->tick(ahead());
    EXPECT_LT(ticks, 2000);
    walkFor(*walker, ahead(), 60);
    EXPECT_NEAR(walker->state().height, 1.8, 1e-6);
}

TEST(Walking, ClimbsLedgesByJumpingAgainstThem) {
    for (const double height : {0.5, 0.8, 1.1}) {
        WalkWorld world;
        world.floor().box(metres(-5, 1, -1), metres(5, 8, height));
        const auto walker = world.walker(0, 0.5, 0);
        stand(*walker);
        walkFor(*walker, ahead(), 60);
        EXPECT_NEAR(walker->state().feet.z, 0, 1e-3);
        WalkInput input = ahead();
        input.jump = true;
        walkFor(*walker, input, 180);
        EXPECT_NEAR(walker->state().feet.z, height, 1e-3);
        EXPECT_TRUE(walker->state().grounded);
    }
    WalkWorld world;
    world.floor().box(metres(-5, 1, -1), metres(5, 8, 1.15));
    const auto walker = world.walker(0, 0.5, 0);
    stand(*walker);
    WalkInput input = ahead();
    input.jump = true;
    walkFor(*walker, input, 240);
    EXPECT_NEAR(walker->state().feet.z, 0, 1e-3);
}

TEST(Walking, ComesOutOfWedges) {
    WalkWorld world;
    const double half = 0.5 * kPi / 180;
    const double end = 60;
    world.floor();
    for (const double side : {-1.0, 1.0}) {
        const double x = side * end * std::tan(half);
        world.quad(metres(0, 0, -1), metres(x, -end, -1), metres(x, -end, 4), metres(0, 0, 4));
    }
    const auto walker = world.walker(0, -40, 0);
    stand(*walker);
    walkFor(*walker, ahead(), 600);
    const Vec3d stuck = walker->state().feet;
    EXPECT_GT(-stuck.y, kRadius / std::sin(half) - 0.01);
    EXPECT_LT(-stuck.y, kReach / std::sin(half) + 0.2);
    stand(*walker);
    const Vec3d still = walker->state().feet;
    stand(*walker);
    EXPECT_EQ(walker->state().feet, still);
    walkFor(*walker, ahead(180), 60);
    const double from = walker->state().feet.y;
    walkFor(*walker, ahead(180), 120);
    EXPECT_NEAR(from - walker->state().feet.y, 3, 0.01);
}

TEST(Walking, LeavesCrevicesByJumping) {
    WalkWorld world;
    for (const double side : {-1.0, 1.0}) {
        world.quad(metres(0, -20, 0), metres(side * 2, -20, 5), metres(side * 2, 20, 5), metres(0, 20, 0));
    }
    const auto walker = world.walker(0, 0, 2);
    stand(*walker, 240);
    EXPECT_TRUE(walker->state().grounded);
    const double from = walker->state().feet.z;
    WalkInput input;
    input.jump = true;
    walkFor(*walker, input, 30);
    EXPECT_GT(walker->state().feet.z, from + 0.3);
}

TEST(Walking, JumpsShortlyAfterTheEdge) {
    for (const int late : {5, 20}) {
        WalkWorld world;
        world.floor(-5).box(metres(-5, -5, -1), metres(5, 1, 0));
        const auto walker = world.walker(0, 0, 0);
        stand(*walker);
        for (int i = 0; i < 200 && walker->state().grounded; ++i) walker->tick(ahead());
        ASSERT_FALSE(walker->state().grounded);
        walkFor(*walker, ahead(), late);
        WalkInput input = ahead();
        input.jump = true;
        walker->tick(input);
        EXPECT_EQ(walker->state().velocity.z > 0, late < 12);
    }
}
