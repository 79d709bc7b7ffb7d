// Random walks: nothing is ever inside the player, and he gets through nothing. RT_WALKS sets the number of
// walks, RT_WALK_SCENE (a .bsp) adds a scene to them.
#include "walk_world.h"

#include "support/random_numbers.h"

#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <string>
#include <vector>

using rtcore::Vec3d;
using rtcore::WalkInput;
using test::metres;
using test::WalkWorld;

namespace {

constexpr int kTicks = 240;
constexpr double kRadius = 0.29, kReach = 0.30;

int walks(int usual) {
    const char* wanted = std::getenv("RT_WALKS");
    return wanted != nullptr ? std::atoi(wanted) : usual;
}

/// Keys that a child would press.
class RandomKeys {
  public:
    explicit RandomKeys(test::Random& random) : random_(random) {}

    WalkInput next() {
        if (random_.index(20) == 0) angle_ = 6.28 * test::share(random_);
        angle_ += 0.02 * (test::share(random_) - 0.5);
        toggle(input_.jump, 15);
        toggle(input_.crouch, 60);
        toggle(input_.crawl, 60);
        toggle(input_.sprint, 20);
        if (random_.index(25) == 0) input_.forward = static_cast<double>(random_.index(3)) - 1;
        if (random_.index(25) == 0) input_.right = static_cast<double>(random_.index(3)) - 1;
        if (random_.index(30) == 0) input_.forward = 1;
        input_.ahead = {std::sin(angle_), std::cos(angle_), 0};
        return input_;
    }

  private:
    void toggle(bool& key, std::size_t every) {
        if (random_.index(every) == 0) key = !key;
    }
    test::Random& random_;
    WalkInput input_;
    double angle_ = 0;
};

/// The distance of the core to all triangles of a mesh, without a tree.
class BruteForce {
  public:
    explicit BruteForce(const rtcore::Mesh& mesh) {
        for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) {
            Vec3d p[3];
            for (int corner = 0; corner < 3; ++corner) {
                const rtcore::Vec3 v = mesh.position(i, corner);
                p[corner] = {double{v.x}, double{v.y}, double{v.z}};
            }
            triangles_.push_back({p[0], p[1], p[2], {}});
        }
    }

    double clearance(Vec3d feet, double height) const {
        const rtcore::UprightLine core{feet + Vec3d{0, 0, kReach}, std::max(0.0, height - 2 * kReach)};
        double least = std::numeric_limits<double>::max();
        for (const rtcore::SolidTriangle& t : triangles_) least = std::min(least, separate(core, t).distance);
        return least;
    }

    /// Whether the core of two heights' lower one, moved from `a` to `b`, goes through a triangle: both ends
    /// and the middle of the core as rays.
    bool crosses(Vec3d a, Vec3d b, double height) const {
        for (const double share : {0.0, 0.5, 1.0}) {
            const Vec3d up{0, 0, kReach + share * std::max(0.0, height - 2 * kReach)};
            for (const rtcore::SolidTriangle& t : triangles_) {
                if (through(t, a + up, b + up)) return true;
            }
        }
        return false;
    }

  private:
    static double volume(Vec3d a, Vec3d b, Vec3d c, Vec3d d) { return dot(a - d, cross(b - d, c - d)); }
    static bool sameSign(double a, double b, double c) {
        return (a >= 0 && b >= 0 && c >= 0) || (a <= 0 && b <= 0 && c <= 0);
    }
    static bool through(const rtcore::SolidTriangle& t, Vec3d p, Vec3d q) {
        const double from = volume(t.a, t.b, t.c, p), to = volume(t.a, t.b, t.c, q);
        if (!((from < 0 && to > 0) || (from > 0 && to < 0))) return false;
        return sameSign(volume(p, q, t.a, t.b), volume(p, q, t.b, t.c), volume(p, q, t.c, t.a));
    }
    std::vector<rtcore::SolidTriangle> triangles_;
};

/// Furniture, ramps, a stair, slits, pillars in a closed room of 16 x 16 x 5 m.
WalkWorld room(std::uint64_t seed) {
    WalkWorld world;
    test::SampleMesh walls = test::boxGrid(4);
    walls.map(
        [](rtcore::Vec3 p) { return metres(8 * double{p.x}, 8 * double{p.y}, 2.5 + 2.5 * double{p.z}); });
    world.add(walls);
    test::Random random(seed);
    const auto place = [&] { return 14 * test::share(random) - 7; };
    for (int i = 0; i < 25; ++i) {
        const double x = place(), y = place(), w = 0.2 + test::share(random),
                     h = 2 * test::share(random) * test::share(random);
        const double z = i % 4 == 0 ? 0.5 + test::share(random) : -0.5;
        world.box(metres(x, y, z), metres(x + w, y + 0.3 + test::share(random), z + 0.5 + h));
    }
    for (int i = 0; i < 6; ++i) {
        const double x = place(), y = place(), slope = 3 * test::share(random);
        world.quad(metres(x, y, -0.1), metres(x + 2, y, -0.1), metres(x + 2, y + 1.5, 1.5 * slope),
                   metres(x, y + 1.5, 1.5 * slope));
    }
    for (int i = 0; i < 8; ++i) world.box(metres(5, -7 + 0.3 * i, 0), metres(7, -4, 0.2 * (i + 1)));
    return world;
}

/// What no modeller should leave: duplicates, slivers, points, slits, sheets that end in the air.
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

struct Watch {
    bool sealed = false; ///< in the closed room: nobody leaves it
    int refused = 0, walked = 0;
    double least = std::numeric_limits<double>::max();
};

void walkOnce(WalkWorld& world, const BruteForce& all, std::uint64_t seed, Watch& watch) {
    test::Random random(seed);
    rtcore::Walker walker(world.tree(), world.view(), rtcore::WorldFrame({0, 0, 1}, 1), WalkWorld::shape());
    const Vec3d eye{15 * test::share(random) - 7.5, 15 * test::share(random) - 7.5,
                    0.2 + 4.5 * test::share(random)};
    if (!walker.enter(eye)) {
        ++watch.refused;
        return;
    }
    ++watch.walked;
    RandomKeys keys(random);
    rtcore::Trace trace;
    for (int tick = 0; tick < kTicks; ++tick) {
        const rtcore::WalkState before = walker.state();
        trace.clear();
        if (!walker.tick(keys.next(), &trace)) return;
        const rtcore::WalkState& now = walker.state();
        ASSERT_TRUE(isFinite(now.feet) && isFinite(now.velocity));
        if (length(now.feet - before.feet) > 1) continue; // put back into the world
        const double lower = std::min(before.height, now.height);
        Vec3d from = before.feet;
        for (const Vec3d& to : trace) {
            const double clear = all.clearance(to, lower);
            watch.least = std::min(watch.least, clear);
            ASSERT_GE(clear, kRadius - 1e-9) << "walk " << seed << " tick " << tick;
            ASSERT_FALSE(all.crosses(from, to, lower)) << "walk " << seed << " tick " << tick;
            from = to;
        }
        ASSERT_LT(length(now.feet - from), 1e-9) << "walk " << seed << " tick " << tick;
        ASSERT_GE(all.clearance(now.feet, now.height), kRadius - 1e-9) << "walk " << seed << " tick " << tick;
        const double eyeHeight = walker.eye().z - now.feet.z;
        ASSERT_GT(eyeHeight, 0.05);
        if (!watch.sealed) continue;
        ASSERT_LE(std::max(std::fabs(now.feet.x), std::fabs(now.feet.y)), 8 - kRadius);
        ASSERT_GE(now.feet.z, -0.011);
        ASSERT_LE(now.feet.z + now.height, 5.011);
    }
}

} // namespace

TEST(RandomWalk, staysInTheRoom) {
    Watch watch;
    watch.sealed = true;
    const int count = walks(40);
    for (int i = 0; i < count && !testing::Test::HasFatalFailure(); ++i) {
        static WalkWorld world = room(1);
        static const BruteForce all(world.view());
        walkOnce(world, all, static_cast<std::uint64_t>(i), watch);
    }
    EXPECT_GT(watch.walked, count / 2);
    RecordProperty("leastClearance", std::to_string(watch.least));
}

TEST(RandomWalk, survivesASoup) {
    Watch watch;
    const int count = walks(40);
    WalkWorld world = soup(3);
    const BruteForce all(world.view());
    for (int i = 0; i < count && !testing::Test::HasFatalFailure(); ++i) {
        walkOnce(world, all, 1000 + static_cast<std::uint64_t>(i), watch);
    }
    EXPECT_GT(watch.walked, count / 4);
}
