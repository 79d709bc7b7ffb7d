// Outlines of storeys: lengths of what is cut, in all coordinates that models have.
#include "rtcore/plans/level_outline.h"
#include "rtcore/plans/storeys.h"
#include "support/solids.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

namespace {

using namespace rtcore;
using test::Solids;

constexpr Colour kBrick{0.5F, 0.5F, 0.5F};

double outlineLength(const FlatLoop& line) {
    double sum = 0;
    for (std::size_t i = 1; i < line.size(); ++i)
        sum += std::hypot(line[i][0] - line[i - 1][0], line[i][1] - line[i - 1][1]);
    return sum;
}

double outlineLength(const std::vector<FlatLoop>& lines) {
    return std::accumulate(lines.begin(), lines.end(), 0.0,
                           [](double sum, const FlatLoop& line) { return sum + outlineLength(line); });
}

/// Two storeys of 10 x 8 m with walls of 0.5 m, in metres times `unit`: a bench of 2 x 1 m, 0.5 m high, in
/// the lower one, a post of 1 x 1 m in the upper one. Up is +z, or +y.
Scene twoStoreys(float unit, bool upright = false) {
    Solids solids;
    const auto move = [upright](Vec3 p) { return upright ? Vec3{p.x, p.z, -p.y} : p; };
    const auto box = [&](Vec3 lo, Vec3 hi) { solids.box(unit * lo, unit * hi, false, false, move); };
    solids.begin("house", kBrick);
    for (const float floor : {0.F, 3.F, 6.F}) box({0, 0, floor - .25F}, {10, 8, floor});
    for (const float floor : {0.F, 3.F}) {
        box({0, 0, floor}, {10, .5F, floor + 2.75F});
        box({0, 7.5F, floor}, {10, 8, floor + 2.75F});
        box({0, .5F, floor}, {.5F, 7.5F, floor + 2.75F});
        box({9.5F, .5F, floor}, {10, 7.5F, floor + 2.75F});
    }
    solids.begin("bench", kBrick);
    box({2, 2, 0}, {4, 3, .5F});
    solids.begin("post", kBrick);
    box({5, 5, 3}, {6, 6, 5.75F});
    Scene scene = solids.scene();
    scene.up = upright ? Vec3{0, 1, 0} : Vec3{0, 0, 1};
    scene.metresPerUnit = 1 / unit;
    return scene;
}

LevelOutline storeyOutline(const Scene& scene, std::size_t storey, bool cancelled = false) {
    ClosedPieces pieces(scene.model);
    const std::atomic<bool> cancel{cancelled};
    return outlineOfStorey(scene, scene.model.mesh.bounds(), storeysOf(scene).at(storey).height, pieces,
                           cancel);
}

constexpr double kWallLines = 36 + 32; ///< metres: around, outside and inside

TEST(LevelOutline, HasTheLengthsOfWhatIsCut) {
    for (const float unit : {1.F, 1000.F, 0.5F}) {
        for (const bool upright : {false, true}) {
            const Scene scene = twoStoreys(unit, upright);
            const LevelOutline below = storeyOutline(scene, 0), above = storeyOutline(scene, 1);
            EXPECT_NEAR(outlineLength(below.solids) / unit, kWallLines, 1e-4) << "the bench is lower";
            EXPECT_NEAR(outlineLength(below.light) / unit, kWallLines + 6, 1e-4) << "and is seen as such";
            EXPECT_NEAR(outlineLength(above.solids) / unit, kWallLines + 4, 1e-4) << "with the post";
            EXPECT_TRUE(below.lines.empty());
            EXPECT_NEAR((below.high[0] - below.low[0]) / unit, 10, 1e-5);
            EXPECT_NEAR((below.high[1] - below.low[1]) / unit, 8, 1e-5);
        }
    }
}

TEST(LevelOutline, StandsOnItsPlane) {
    const LevelOutline outline = storeyOutline(twoStoreys(1, true), 1);
    const Vec3d corner = outline.plane.point(outline.low), other = outline.plane.point(outline.high);
    EXPECT_NEAR(corner.x, 0, 1e-5);
    EXPECT_NEAR(corner.z, 0, 1e-5) << "what is up on paper lies at -z";
    EXPECT_NEAR(other.x, 10, 1e-5);
    EXPECT_NEAR(other.z, -8, 1e-5);
    EXPECT_NEAR(corner.y, 4.2, 1e-4);
}

TEST(LevelOutline, LeavesHiddenPartsOut) {
    Scene scene = twoStoreys(1);
    scene.hiddenParts = std::make_shared<const std::vector<std::uint8_t>>(std::vector<std::uint8_t>{0, 1, 1});
    EXPECT_NEAR(outlineLength(storeyOutline(scene, 0).light), kWallLines, 1e-4);
    EXPECT_NEAR(outlineLength(storeyOutline(scene, 1).solids), kWallLines, 1e-4);
}

TEST(LevelOutline, IsEmptyOnceItIsGivenUp) {
    EXPECT_FALSE(storeyOutline(twoStoreys(1), 0).empty());
    EXPECT_TRUE(storeyOutline(twoStoreys(1), 0, true).empty());
}

// Three heights cut the block, three what stands on it.
TEST(ContourLines, OfASolidAreThoseOfItsHeights) {
    Solids solids;
    solids.begin("block", kBrick);
    solids.box({0, 0, 0}, {4, 3, 2});
    solids.box({0, 0, 2}, {1, 1, 4});
    Scene scene = solids.scene();
    scene.up = {0, 0, 1};
    ClosedPieces pieces(scene.model);
    const LevelOutline outline = contourLines(scene, scene.model.mesh.bounds(), pieces, false);
    EXPECT_TRUE(outline.solids.empty() && outline.lines.empty());
    EXPECT_NEAR(outlineLength(outline.light), 3 * 14 + 3 * 4, 1e-4) << "six heights, three of them of each";
}

TEST(Simplified, KeepsWhatIsFartherThanTheTolerance) {
    const FlatLoop line{{0, 0}, {1, 0.1}, {2, -0.1}, {3, 0}, {3, 5}};
    EXPECT_EQ(simplified(line, 0.2), (FlatLoop{{0, 0}, {3, 0}, {3, 5}}));
    EXPECT_EQ(simplified(line, 0.01), line);
    EXPECT_EQ(simplified(line, 100), FlatLoop());
    EXPECT_EQ(simplified({{0, 0}, {1, 0}, {1, 1}, {0, 0}}, 0.1).size(), 4U) << "a loop stays one";
    EXPECT_EQ(simplified({{1, 1}}, 0.1), FlatLoop());
}

} // namespace
