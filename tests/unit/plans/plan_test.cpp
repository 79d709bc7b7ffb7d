// Whole drawings: in metres of the file, and by the plane that was asked for.
#include "rtcore/accel/builder.h"
#include "rtcore/plans/plan.h"
#include "rtcore/platform/sentence.h"
#include "rtcore/sections/cut_outlines.h"
#include "support/solids.h"

#include <gtest/gtest.h>

#include <atomic>
#include <cmath>

namespace {

using namespace rtcore;
using test::Solids;

constexpr Colour kPlaster{0.5F, 0.5F, 0.5F};

/// A room of 5 x 4 m inside, 2.5 m high, with walls of .3 m, in millimetres, up along z; a table in it.
class Room {
  public:
    Room() {
        Solids solids;
        solids.begin("floor", kPlaster);
        solids.box({-300, -300, -200}, {5300, 4300, 0});
        solids.begin("walls", kPlaster);
        solids.box({-300, -300, 0}, {5300, 0, 2500});
        solids.box({-300, 4000, 0}, {5300, 4300, 2500});
        solids.box({-300, 0, 0}, {0, 4000, 2500});
        solids.box({5000, 0, 0}, {5300, 4000, 2500});
        solids.begin("table", kPlaster);
        solids.box({1000, 1000, 700}, {2000, 1800, 750});
        scene_ = solids.scene();
        scene_.up = {0, 0, 1};
        scene_.metresPerUnit = 0.001F;
        scene_.origin.at = {450e6, 5400e6, 200e3};
        tree_ = buildKdTree(scene_.model.mesh, {});
        tracer_ = std::make_unique<KdRayTracer>(tree_, scene_.model.mesh);
    }
    Scene& scene() { return scene_; }
    ChosenPlan choose(const PlanChoice& choice) const {
        return choosePlan(choice, scene_, tracer_->bounds(), Vec3{1000, 1000, 1600});
    }
    Drawing draw(const SectionPlane& plane, bool cancelled = false) const {
        ClosedPieces pieces(scene_.model);
        const std::atomic<bool> cancel{cancelled};
        return drawingOf(scene_, *tracer_, pieces, plane, {}, cancel);
    }

  private:
    Scene scene_;
    KdTree tree_;
    std::unique_ptr<KdRayTracer> tracer_;
};

TEST(Plan, IsInMetresOfTheFile) {
    Room room;
    const ChosenPlan chosen = room.choose({});
    EXPECT_EQ(chosen.storey, 1U);
    ASSERT_TRUE(chosen.floor);
    EXPECT_NEAR(*chosen.floor, 200, 1e-6);
    const Drawing drawing = room.draw(chosen.plane);
    EXPECT_NEAR(drawing.low[0], 450e3 - .3, 1e-6);
    EXPECT_NEAR(drawing.low[1], 5400e3 - .3, 1e-6);
    EXPECT_NEAR(drawing.high[0], 450e3 + 5.3, 1e-6);
    EXPECT_NEAR(drawing.high[1], 5400e3 + 4.3, 1e-6);
    double cut = 0;
    for (const FlatLoop& loop : drawing.solids) cut += areaOf(loop);
    EXPECT_NEAR(cut, 5.6 * 4.6 - 20, 1e-6);
    ASSERT_EQ(drawing.rooms.size(), 1U);
    EXPECT_NEAR(drawing.rooms[0].area, 20, 20 * 1e-6);
    EXPECT_FALSE(drawing.north) << "there is no sky that has one";
}

TEST(Plan, SeesTheTableBelowTheCut) {
    Room room;
    const auto tableLength = [&](double height) {
        const Drawing drawing = room.draw(room.choose({.height = height}).plane);
        double sum = 0;
        for (const FlatLine& line : drawing.seen) {
            const bool inside = line.a[0] > 450e3 + .5 && line.a[0] < 450e3 + 4.5 && line.a[1] > 5400e3 + .5;
            if (inside) sum += std::hypot(line.b[0] - line.a[0], line.b[1] - line.a[1]);
        }
        return sum;
    };
    EXPECT_NEAR(tableLength(1.2), 3.6, 1e-4);
    EXPECT_NEAR(tableLength(0.5), 0, 1e-4) << "it is above";
}

TEST(Plan, NorthIsThatOfTheSky) {
    Room room;
    room.scene().sky.emplace();
    room.scene().sky->north = 90;
    const Drawing drawing = room.draw(room.choose({}).plane);
    ASSERT_TRUE(drawing.north);
    EXPECT_NEAR(*drawing.north, M_PI / 2, 1e-9);
}

TEST(Plan, ElevationsAreNotCut) {
    Room room;
    for (const PlanSide side : {PlanSide::Front, PlanSide::Left, PlanSide::Back, PlanSide::Right}) {
        const Drawing drawing = room.draw(room.choose({.side = side}).plane);
        EXPECT_TRUE(drawing.solids.empty() && drawing.rooms.empty());
        const bool wide = side == PlanSide::Front || side == PlanSide::Back;
        EXPECT_NEAR(drawing.high[0] - drawing.low[0], wide ? 5.6 : 4.6, 1e-5);
        EXPECT_NEAR(drawing.high[1] - drawing.low[1], 2.7, 1e-5);
        EXPECT_NEAR(drawing.low[1], 200 - .2, 1e-5) << "heights are those of the file";
    }
}

TEST(Plan, FloorsCanBeNamed) {
    Room room;
    const ChosenPlan chosen = room.choose({.height = 1, .floor = 201});
    EXPECT_EQ(chosen.storey, 0U);
    EXPECT_NEAR(chosen.plane.point.z, 2000, 1e-2);
    EXPECT_EQ(choosePlan({}, room.scene(), {{0, 0, 0}, {1, 1, 1}}, {}).storey, 1U) << "the lowest";
    EXPECT_THROW(room.choose({.storey = 2}), Refusal);
    EXPECT_THROW(room.choose({.storey = 0}), Refusal);
}

TEST(Plan, ASectionIsTheOnlyOneOfTheScene) {
    Room room;
    EXPECT_THROW(room.choose({.side = PlanSide::Section}), Refusal);
    room.scene().sections.planes = {{{2500, 0, 0}, {1, 0, 0}}};
    const Drawing drawing = room.draw(room.choose({.side = PlanSide::Section}).plane);
    double cut = 0;
    for (const FlatLoop& loop : drawing.solids) cut += areaOf(loop);
    EXPECT_NEAR(cut, 2 * .3 * 2.5 + 4.6 * .2, 1e-5) << "two walls and the floor";
    EXPECT_TRUE(drawing.rooms.empty());
    room.scene().sections.planes.push_back({{0, 0, 0}, {0, 1, 0}});
    EXPECT_THROW(room.choose({.side = PlanSide::Section}), Refusal);
}

TEST(Plan, EndsWhenItIsCancelled) {
    Room room;
    EXPECT_TRUE(room.draw(room.choose({}).plane, true).empty());
}

} // namespace
