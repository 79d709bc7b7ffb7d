#include "rtcore/motion/separation.h"
#include "rtcore/motion/sweep.h"

#include "walk_world.h"

#include <algorithm>
#include <cmath>

using rtcore::SolidTriangle;
using rtcore::UprightLine;
using rtcore::Vec3d;

namespace {

SolidTriangle triangle(Vec3d a, Vec3d b, Vec3d c) {
    return {a,
            b,
            c,
            {{std::min({a.x, b.x, c.x}), std::min({a.y, b.y, c.y}), std::min({a.z, b.z, c.z})},
             {std::max({a.x, b.x, c.x}), std::max({a.y, b.y, c.y}), std::max({a.z, b.z, c.z})}}};
}

Vec3d randomPoint(test::Random& random, double size) {
    const rtcore::Vec3 v = random.vector(static_cast<float>(size));
    return {double{v.x}, double{v.y}, double{v.z}};
}

/// Random, flat, thin as a needle or a point.
SolidTriangle randomTriangle(test::Random& random, int kind) {
    const Vec3d a = randomPoint(random, 1), b = a + randomPoint(random, 1);
    Vec3d c = a + randomPoint(random, 1);
    if (kind == 1) c = a + (b - a) * 0.3 + randomPoint(random, 1e-6);
    if (kind == 2) c = a + (b - a) * 0.5;
    if (kind == 3) return triangle(a, a, a);
    if (kind == 4) return triangle(a, b, {a.x, a.y, c.z});
    return triangle(a, b, c);
}

/// By trying points of both, ever more finely around the best.
double sampledDistance(const UprightLine& line, const SolidTriangle& t) {
    double best = 1e9, u0 = 0.5, v0 = 0.5, h0 = 0.5, size = 0.5;
    for (int level = 0; level < 40; ++level) {
        double u1 = u0, v1 = v0, h1 = h0;
        for (int i = -3; i <= 3; ++i) {
            for (int j = -3; j <= 3; ++j) {
                for (int k = -3; k <= 3; ++k) {
                    const double u = std::clamp(u0 + size * i / 3, 0.0, 1.0);
                    const double v = std::clamp(v0 + size * j / 3, 0.0, 1.0);
                    const double h = std::clamp(h0 + size * k / 3, 0.0, 1.0);
                    const Vec3d p = t.a + (t.b - t.a) * u + (t.c - t.b) * (u * v);
                    const double d = length(line.foot + Vec3d{0, 0, h * line.height} - p);
                    if (d < best) {
                        best = d;
                        u1 = u;
                        v1 = v;
                        h1 = h;
                    }
                }
            }
        }
        u0 = u1;
        v0 = v1;
        h0 = h1;
        size *= 0.7;
    }
    return best;
}

} // namespace

TEST(Separation, IsTheShortest) {
    test::Random random(1);
    for (int i = 0; i < 1000; ++i) {
        const SolidTriangle t = randomTriangle(random, i % 5);
        const UprightLine line{randomPoint(random, 1.5), i % 3 == 0 ? 0.0 : 1.2 * test::fraction(random)};
        const rtcore::Separation s = separate(line, t);
        const double sampled = sampledDistance(line, t);
        ASSERT_LE(s.distance, sampled + 1e-9) << i;
        ASSERT_NEAR(s.distance, sampled, 0.02) << i;
        ASSERT_NEAR(length(s.normal), 1, 1e-9);
    }
}

TEST(Separation, SweepsStopAtTheSurface) {
    test::Random random(2);
    int hits = 0;
    for (int i = 0; i < 20000; ++i) {
        const SolidTriangle t = randomTriangle(random, i % 5);
        const UprightLine line{randomPoint(random, 2), i % 3 == 0 ? 0.0 : 1.2 * test::fraction(random)};
        constexpr double kRadius = 0.29, kSkin = 0.01;
        if (separate(line, t).distance < kRadius) continue;
        const Vec3d direction = normalize(t.a - line.foot + randomPoint(random, 1));
        const double distance = 3 * test::fraction(random);
        const rtcore::Sweep sweep = sweepCapsule({&t, 1}, line, kRadius, kSkin, direction, distance);
        hits += sweep.hit ? 1 : 0;
        for (int part = 0; part <= 20; ++part) {
            UprightLine moved = line;
            moved.foot += direction * (sweep.travel * part / 20);
            ASSERT_GE(separate(moved, t).distance, kRadius - 1e-9) << i;
        }
        if (!sweep.hit) {
            EXPECT_EQ(sweep.travel, distance);
        }
    }
    EXPECT_GT(hits, 1500);
}
