// Random walks: nothing is ever inside the player, and he gets through nothing. RT_WALKS sets the number of
// walks, RT_WALK_SCENE (a .bsp) adds a scene to them.
#include "walk_world.h"

#include "rtcore/io/bsp/bsp_file.h"
#include "support/random_numbers.h"

#include <algorithm>
#include <chrono>
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
    BruteForce(const rtcore::Mesh& mesh, const rtcore::WorldFrame& frame) {
        for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) {
            Vec3d p[3];
            for (int corner = 0; corner < 3; ++corner) {
                p[corner] = frame.toMetres(mesh.position(i, corner));
            }
            triangles_.push_back({p[0], p[1], p[2], boxOf(p[0], p[1], p[2])});
        }
    }

    /// At most kReach.
    double clearance(Vec3d feet, double height) const {
        const rtcore::UprightLine core{feet + Vec3d{0, 0, kReach}, std::max(0.0, height - 2 * kReach)};
        const rtcore::Box3d near =
            boxOf(core.foot, core.foot + Vec3d{0, 0, core.height}, core.foot).grown(kReach);
        double least = kReach;
        for (const rtcore::SolidTriangle& t : triangles_) {
            if (t.box.overlaps(near)) least = std::min(least, separate(core, t).distance);
        }
        return least;
    }

    /// Whether the core of two heights' lower one, moved from `a` to `b`, goes through a triangle: both ends
    /// and the middle of the core as rays.
    bool crosses(Vec3d a, Vec3d b, double height) const {
        for (const double share : {0.0, 0.5, 1.0}) {
            const Vec3d up{0, 0, kReach + share * std::max(0.0, height - 2 * kReach)};
            const rtcore::Box3d way = boxOf(a + up, b + up, b + up);
            for (const rtcore::SolidTriangle& t : triangles_) {
                if (t.box.overlaps(way) && through(t, a + up, b + up)) return true;
            }
        }
        return false;
    }

    /// Of the eye, at most 0.1.
    double clearanceOf(Vec3d eye) const {
        double least = 0.1;
        const rtcore::Box3d near = boxOf(eye, eye, eye).grown(least);
        for (const rtcore::SolidTriangle& t : triangles_) {
            if (t.box.overlaps(near)) least = std::min(least, separate({eye, 0}, t).distance);
        }
        return least;
    }

  private:
    static rtcore::Box3d boxOf(Vec3d a, Vec3d b, Vec3d c) {
        return {{std::min({a.x, b.x, c.x}), std::min({a.y, b.y, c.y}), std::min({a.z, b.z, c.z})},
                {std::max({a.x, b.x, c.x}), std::max({a.y, b.y, c.y}), std::max({a.z, b.z, c.z})}};
    }
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

/// Where walks go, and what they came to.
struct Stage {
    Stage(const rtcore::KdTree& kdTree, const rtcore::Mesh& triangles, rtcore::Vec3 up, double metresPerUnit)
        : tree(kdTree), mesh(triangles), frame(up, metresPerUnit), all(mesh, frame) {
        const Vec3d a = frame.toMetres(tree.bounds.lo), b = frame.toMetres(tree.bounds.hi);
        lo = {std::min(a.x, b.x), std::min(a.y, b.y), std::min(a.z, b.z)};
        hi = {std::max(a.x, b.x), std::max(a.y, b.y), std::max(a.z, b.z)};
    }
    void startIn(Vec3d low, Vec3d high) {
        lo = low;
        hi = high;
    }
    rtcore::KdTree tree;
    rtcore::Mesh mesh;
    rtcore::WorldFrame frame;
    BruteForce all;
    Vec3d lo, hi;
    bool sealed = false;  ///< nobody leaves the room of room()
    int checkedEvery = 1; ///< one walk of so many is checked triangle by triangle
    int walked = 0, ticks = 0;
    double slowest = 0, seconds = 0; ///< of ticks
};

void walkOnce(Stage& stage, std::uint64_t seed) {
    test::Random random(seed);
    rtcore::Walker walker(stage.tree, stage.mesh, stage.frame, WalkWorld::shape());
    const auto within = [&](double lo, double hi) { return lo + (hi - lo) * test::share(random); };
    const Vec3d start{within(stage.lo.x, stage.hi.x), within(stage.lo.y, stage.hi.y),
                      within(stage.lo.z, stage.hi.z)};
    if (!walker.enter(start)) return;
    ++stage.walked;
    RandomKeys keys(random);
    rtcore::Trace trace;
    for (int tick = 0; tick < kTicks; ++tick) {
        const rtcore::WalkState before = walker.state();
        trace.clear();
        const WalkInput input = keys.next();
        const auto begin = std::chrono::steady_clock::now();
        if (!walker.tick(input, &trace)) return;
        const std::chrono::duration<double> took = std::chrono::steady_clock::now() - begin;
        ++stage.ticks;
        stage.seconds += took.count();
        stage.slowest = std::max(stage.slowest, took.count());
        const rtcore::WalkState& now = walker.state();
        ASSERT_TRUE(isFinite(now.feet) && isFinite(now.velocity));
        if (length(now.feet - before.feet) > 1) continue; // put back into the world
        if (seed % static_cast<std::uint64_t>(stage.checkedEvery) != 0) continue;
        const double lower = std::min(before.height, now.height);
        Vec3d from = before.feet;
        for (const Vec3d& to : trace) {
            ASSERT_GE(stage.all.clearance(to, lower), kRadius - 1e-9) << "walk " << seed << " tick " << tick;
            ASSERT_FALSE(stage.all.crosses(from, to, lower)) << "walk " << seed << " tick " << tick;
            from = to;
        }
        ASSERT_LT(length(now.feet - from), 1e-9) << "walk " << seed << " tick " << tick;
        ASSERT_GE(stage.all.clearance(now.feet, now.height), kRadius - 1e-9)
            << "walk " << seed << " tick " << tick;
        ASSERT_GE(stage.all.clearanceOf(walker.eye()), 0.08) << "walk " << seed << " tick " << tick;
        if (!stage.sealed) continue;
        ASSERT_LE(std::max(std::fabs(now.feet.x), std::fabs(now.feet.y)), 8 - kRadius);
        ASSERT_GE(now.feet.z, -0.011);
        ASSERT_LE(now.feet.z + now.height, 5.011);
    }
}

void walkOften(Stage& stage, int count) {
    for (int i = 0; i < count && !testing::Test::HasFatalFailure(); ++i) {
        walkOnce(stage, static_cast<std::uint64_t>(i));
    }
    testing::Test::RecordProperty("walks", stage.walked);
    testing::Test::RecordProperty("microsecondsPerTick",
                                  static_cast<int>(1e6 * stage.seconds / (1 + stage.ticks)));
    testing::Test::RecordProperty("slowestMicroseconds", static_cast<int>(1e6 * stage.slowest));
}

} // namespace

TEST(RandomWalk, staysInTheRoom) {
    WalkWorld world = room(1);
    Stage stage(world.tree(), world.view(), {0, 0, 1}, 1);
    stage.sealed = true;
    stage.startIn({-7.5, -7.5, 0.2}, {7.5, 7.5, 4.7});
    const int count = walks(40);
    walkOften(stage, count);
    EXPECT_GT(stage.walked, count / 2);
}

TEST(RandomWalk, survivesASoup) {
    WalkWorld world = soup(3);
    Stage stage(world.tree(), world.view(), {0, 0, 1}, 1);
    stage.startIn({-7.5, -7.5, 0.2}, {7.5, 7.5, 4.7});
    const int count = walks(40);
    walkOften(stage, count);
    EXPECT_GT(stage.walked, count / 4);
}

TEST(RandomWalk, throughAScene) {
    const char* file = std::getenv("RT_WALK_SCENE");
    if (file == nullptr) GTEST_SKIP() << "RT_WALK_SCENE names no .bsp";
    const rtcore::BspContent content = rtcore::readBsp(file);
    ASSERT_TRUE(content.tree);
    const rtcore::Vec3 up{0, 1, 0};
    Stage stage(*content.tree, content.model.mesh, up, rtcore::guessMetresPerUnit(content.tree->bounds, up));
    stage.checkedEvery = 20;
    walkOften(stage, walks(40));
}
