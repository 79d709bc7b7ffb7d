// Visible edges from above: lengths that are known, and bits that do not depend on threads.
#include "rtcore/accel/builder.h"
#include "rtcore/plans/seen_edges.h"
#include "support/random_numbers.h"
#include "support/solids.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <vector>

#ifdef _OPENMP
#include <omp.h>
#endif

namespace {

using namespace rtcore;
using test::Solids;

constexpr Colour kChalk{0.5F, 0.5F, 0.5F};
constexpr double kStep = 0.02;

class View {
  public:
    explicit View(Solids& solids)
        : scene_(solids.scene()), tree_(buildKdTree(scene_.model.mesh, {})),
          tracer_(tree_, scene_.model.mesh) {
        scene_.up = {0, 0, 1};
    }
    /// From above, of what is below `height`.
    std::vector<FlatLine> seen(float height, const std::vector<FlatLoop>& solids = {}) const {
        const std::atomic<bool> cancel{false};
        return seenEdges(scene_, tracer_,
                         cutPlaneOf({{0, 0, height}, {0, 0, 1}}, tracer_.bounds(), scene_.up),
                         FlatRegion(solids), kStep, cancel);
    }

  private:
    Scene scene_;
    KdTree tree_;
    KdRayTracer tracer_;
};

double seenLength(const std::vector<FlatLine>& lines) {
    double sum = 0;
    for (const FlatLine& line : lines) sum += std::hypot(line.b[0] - line.a[0], line.b[1] - line.a[1]);
    return sum;
}

TEST(SeenEdges, OfABoxAreItsOutlineOnce) {
    Solids solids;
    solids.begin("box", kChalk);
    solids.box({1, 2, 0}, {4, 4, 1});
    const std::vector<FlatLine> seen = View(solids).seen(2);
    EXPECT_EQ(seen.size(), 4U) << "those below are the same lines, diagonals of faces none";
    EXPECT_NEAR(seenLength(seen), 10, 1e-6);
}

// A slab over the right half of a box: of the box its left half is left, and the whole slab is seen.
TEST(SeenEdges, EndWhereSomethingIsAbove) {
    Solids solids;
    solids.begin("box", kChalk);
    solids.box({0, 0, 0}, {4, 2, 1});
    solids.begin("slab", kChalk);
    solids.box({2.005F, -1, 1.5F}, {6, 3, 1.6F});
    const View view(solids);
    EXPECT_NEAR(seenLength(view.seen(3)), 2 + 2 * 2.005 + 2 * (3.995 + 4), 2 * kStep / 64 + 1e-4);
    EXPECT_NEAR(seenLength(view.seen(1.2F)), 12, 1e-5) << "the slab is taken away";
}

TEST(SeenEdges, AreClippedByThePlaneAndNotInsideOfWhatItCuts) {
    Solids solids;
    solids.begin("wedge", kChalk); // leans: its edges rise from 0 to 4
    solids.box({0, 0, 0}, {1, 1, 4}, false, false, [](Vec3 p) { return Vec3{p.x + p.z, p.y, p.z}; });
    solids.begin("floor", kChalk);
    solids.box({-5, -5, -1}, {10, 6, -0.5F});
    const View view(solids);
    // Below 2: the floor's outline, and the wedge as far as it is there, without its foot, over which it
    // leans.
    const double floor = 2 * (15 + 11);
    EXPECT_NEAR(seenLength(view.seen(2)) - floor, 1 + 2 * 3, 0.01);
    const std::vector<FlatLoop> cut{{{2, -.1}, {3, -.1}, {3, 1.1}, {2, 1.1}}};
    EXPECT_NEAR(seenLength(view.seen(2, cut)) - floor, 1 + 2 * 2, 0.03);
}

TEST(SeenEdges, RoundThingsHaveTheirOutline) {
    Solids solids;
    solids.begin("ring", kChalk);
    solids.ring(2, 0.5F, 128, 64);
    const double seen = seenLength(View(solids).seen(3));
    EXPECT_NEAR(seen, 2 * M_PI * (2.5 + 1.5), 0.02) << "outer and inner outline";
}

TEST(SeenEdges, AreTheSameByEachNumberOfThreads) {
    Solids solids;
    solids.begin("boxes", kChalk);
    test::Random random(8);
    for (int i = 0; i < 60; ++i) {
        const Vec3 at = random.vector(3),
                   size{random.number(.1F, 1), random.number(.1F, 1), random.number(.1F, 1)};
        solids.box(at, at + size, false, false, test::turned(random.vector(1), random.number(0, 180)));
    }
    const View view(solids);
    const std::vector<FlatLine> seen = view.seen(5);
    EXPECT_GT(seen.size(), 100U);
#ifdef _OPENMP
    const int before = omp_get_max_threads();
    for (const int threads : {1, 2, 7}) {
        omp_set_num_threads(threads);
        EXPECT_TRUE(view.seen(5) == seen) << threads;
    }
    omp_set_num_threads(before);
#endif
}

// Each point that is drawn, or is on an edge and not drawn, beside rays to the eye from both of its sides.
TEST(SeenEdges, AreThoseFromWhichTheEyeIsSeen) {
    Solids solids;
    solids.begin("boxes", kChalk);
    test::Random random(12);
    struct Box {
        Vec3 lo, hi;
    };
    std::vector<Box> boxes;
    for (int i = 0; i < 25; ++i) {
        const Vec3 lo = random.vector(2),
                   hi = lo + Vec3{random.number(.2F, 1), random.number(.2F, 1), random.number(.2F, 1)};
        boxes.push_back({lo, hi});
        solids.box(lo, hi);
    }
    const std::vector<FlatLine> seen = View(solids).seen(5);
    const auto isDrawn = [&](const FlatPoint& p) {
        return std::ranges::any_of(seen, [&](const FlatLine& line) {
            const double dx = line.b[0] - line.a[0], dy = line.b[1] - line.a[1], length = std::hypot(dx, dy);
            const double along = ((p[0] - line.a[0]) * dx + (p[1] - line.a[1]) * dy) / length;
            const double off = ((p[1] - line.a[1]) * dx - (p[0] - line.a[0]) * dy) / length;
            return std::fabs(off) < 1e-6 && along > -1e-6 && along < length + 1e-6;
        });
    };
    int drawn = 0, hidden = 0;
    for (const Box& box : boxes) {
        for (int i = 0; i < 40; ++i) {
            // On an upper edge along x.
            const FlatPoint p{random.number(box.lo.x, box.hi.x), random.coin() ? box.lo.y : box.hi.y};
            bool covered = false, near = false;
            for (const Box& other : boxes) {
                if (other.hi.z <= box.hi.z) continue;
                const double margin =
                    std::min({p[0] - other.lo.x, other.hi.x - p[0], p[1] - other.lo.y, other.hi.y - p[1]});
                covered |= margin > 0;
                near |= std::fabs(margin) < kStep;
            }
            if (near) continue;
            EXPECT_EQ(isDrawn(p), !covered) << p[0] << ' ' << p[1];
            ++(covered ? hidden : drawn);
        }
    }
    EXPECT_GT(drawn, 200);
    EXPECT_GT(hidden, 100);
}

} // namespace
