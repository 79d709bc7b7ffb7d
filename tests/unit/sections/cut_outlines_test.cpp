// Where a plane cuts solids: lengths, areas and windings against closed forms and against rays.
#include "rtcore/sections/cut_outlines.h"
#include "rtcore/sections/section_caps.h"
#include "support/random_numbers.h"
#include "support/solids.h"
#include "windings.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <numbers>
#include <string>
#include <vector>

namespace {

using namespace rtcore;
using test::Solids;
using test::turned;
using test::windings;

constexpr Colour kGrey{0.5F, 0.5F, 0.5F};

CutPlane planeAt(Vec3 point, Vec3 normal) { return cutPlaneOf({point, normal}, {}, {0, 0, 1}); }

std::vector<CutOutline> outlinesOf(const Scene& scene, const CutPlane& plane) {
    ClosedPieces pieces(scene.model);
    return cutOutlines(scene.model, scene.hiddenParts, plane, pieces);
}

double areaOfAll(const std::vector<CutOutline>& outlines) {
    double sum = 0;
    for (const CutOutline& outline : outlines)
        for (const FlatLoop& loop : outline.loops) sum += areaOf(loop);
    return sum;
}

TEST(CutOutlines, OfABoxAreASquareToTheLeft) {
    Solids solids;
    solids.begin("box", kGrey);
    solids.box({-1, -2, -3}, {1, 2, 3});
    const std::vector<CutOutline> outlines = outlinesOf(solids.scene(), planeAt({0, 0, 0.5F}, {0, 0, 2}));
    ASSERT_EQ(outlines.size(), 1U);
    EXPECT_TRUE(outlines[0].closed);
    ASSERT_EQ(outlines[0].loops.size(), 1U);
    EXPECT_NEAR(areaOfAll(outlines), 8, 1e-6) << "anticlockwise";
    for (const FlatPoint& p : outlines[0].loops[0])
        EXPECT_TRUE(std::fabs(std::fabs(p[0]) - 1) < 1e-6 || std::fabs(std::fabs(p[1]) - 2) < 1e-6 ||
                    std::fabs(std::fabs(p[0]) - 2) < 1e-6 || std::fabs(std::fabs(p[1]) - 1) < 1e-6);
}

TEST(CutOutlines, AxesAreThoseOfWhoLooksAtTheCut) {
    const CutPlane wall = planeAt({0, 0, 0}, {1, 0, 0});
    EXPECT_NEAR(wall.up.z, 1, 1e-12);
    EXPECT_NEAR(wall.right.y, 1, 1e-12) << "the viewer stands at +x and looks along -x";
    const CutPlane floor = planeAt({0, 0, 0}, {0, 0, 1});
    EXPECT_NEAR(floor.up.y, 1, 1e-12) << "north is up";
    EXPECT_NEAR(floor.right.x, 1, 1e-12);
    EXPECT_NEAR(dot(cross(floor.right, floor.up), floor.normal), 1, 1e-12);
}

TEST(CutOutlines, HollowsAndOverlapsAreTold) {
    Solids solids;
    solids.begin("tube", kGrey);
    solids.box({-2, -2, -2}, {2, 2, 2});
    solids.box({-1, -1, -1}, {1, 1, 1}, true);
    EXPECT_NEAR(areaOfAll(outlinesOf(solids.scene(), planeAt({0, 0, 0.3F}, {0, 0, 1}))), 16 - 4, 1e-6);
    EXPECT_NEAR(areaOfAll(outlinesOf(solids.scene(), planeAt({0, 0, 1.3F}, {0, 0, 1}))), 16, 1e-6);
}

// Four triangles meet at the edge where two boxes touch, which have all their vertices in common there.
TEST(CutOutlines, OfSolidsThatTouchAreClosed) {
    Solids solids;
    solids.begin("walls", kGrey);
    solids.box({0, 0, 0}, {1, 1, 1});
    solids.box({1, 1, 0}, {2, 2, 1});
    solids.weld();
    const std::vector<CutOutline> outlines = outlinesOf(solids.scene(), planeAt({0, 0, 0.5F}, {0, 0, 1}));
    ASSERT_EQ(outlines.size(), 1U);
    EXPECT_TRUE(outlines[0].closed);
    EXPECT_TRUE(outlines[0].chains.empty());
    EXPECT_NEAR(areaOfAll(outlines), 2, 1e-6);
}

// What lies in the plane is below: it is seen as it is, and needs no cap.
TEST(CutOutlines, AFaceInThePlaneIsNotCut) {
    Solids solids;
    solids.begin("box", kGrey);
    solids.box({0, 0, 0}, {1, 1, 1});
    EXPECT_TRUE(outlinesOf(solids.scene(), planeAt({0, 0, 1}, {0, 0, 1})).empty());
    EXPECT_NEAR(areaOfAll(outlinesOf(solids.scene(), planeAt({0, 0, 0}, {0, 0, 1}))), 1, 1e-6);
    EXPECT_TRUE(outlinesOf(solids.scene(), planeAt({0, 0, 0}, {0, 0, -1})).empty());
    EXPECT_TRUE(outlinesOf(solids.scene(), planeAt({0, 0, 1.5F}, {0, 0, 1})).empty());
    EXPECT_TRUE(outlinesOf(solids.scene(), planeAt({1, 1, 1}, {1, 1, 1})).empty()) << "at a corner";
    EXPECT_NEAR(areaOfAll(outlinesOf(solids.scene(), planeAt({0, 0, 0}, {1, -1, 0}))), std::sqrt(2), 1e-6)
        << "through four corners";
}

TEST(CutOutlines, OfOpenPiecesAreLines) {
    Solids solids;
    solids.begin("cup", kGrey);
    solids.box({0, 0, 0}, {1, 1, 1}, false, true);
    solids.begin("solid", kGrey);
    solids.box({2, 0, 0}, {3, 1, 1});
    Scene scene = solids.scene();
    const std::vector<CutOutline> across = outlinesOf(scene, planeAt({0, 0.5F, 0}, {0, 1, 0}));
    ASSERT_EQ(across.size(), 2U);
    EXPECT_FALSE(across[0].closed);
    ASSERT_EQ(across[0].chains.size(), 1U);
    EXPECT_TRUE(across[0].loops.empty());
    double length = 0;
    const FlatLoop& chain = across[0].chains[0];
    for (std::size_t i = 0; i + 1 < chain.size(); ++i)
        length += std::hypot(chain[i + 1][0] - chain[i][0], chain[i + 1][1] - chain[i][1]);
    EXPECT_NEAR(length, 3, 1e-6) << "a bottom and two walls";
    scene.sections.planes = {{{0, 0.5F, 0}, {0, 1, 0}}};
    ClosedPieces pieces(scene.model);
    const SectionCaps caps = sectionCapsOf(scene, pieces);
    EXPECT_EQ(caps.openParts, std::vector<std::string>{"cup"});
    ASSERT_EQ(caps.planes.size(), 1U);
    EXPECT_EQ(caps.planes[0].shapes.size(), 1U) << "an open part has no cap";
    scene.hiddenParts = std::make_shared<const std::vector<std::uint8_t>>(std::vector<std::uint8_t>{0, 1});
    EXPECT_TRUE(sectionCapsOf(scene, pieces).empty()) << "nor has a hidden one";
}

TEST(CutOutlines, OtherSectionsCutThemShort) {
    Solids solids;
    solids.begin("box", kGrey);
    solids.box({0, 0, 0}, {4, 4, 4});
    Scene scene = solids.scene();
    scene.sections.planes = {{{0, 0, 2}, {0, 0, 1}}, {{1, 0, 0}, {-1, 0, 0}}, {{3, 0, 0}, {1, 0, 0}}};
    ClosedPieces pieces(scene.model);
    const SectionCaps caps = sectionCapsOf(scene, pieces);
    ASSERT_EQ(caps.planes.size(), 3U);
    EXPECT_NEAR(areaOf(caps.planes[0].shapes[0].loops[0]), 2 * 4, 1e-3);
    EXPECT_NEAR(areaOf(caps.planes[1].shapes[0].loops[0]), 4 * 2, 1e-3);
}

/// How often the surface winds around a point: the solid angles that its triangles are seen under (van
/// Oosterom and Strackee 1983), over 4 pi. Knows nothing of planes and edges.
double windingsOfSurface(const Mesh& mesh, Vec3d p) {
    double sum = 0;
    for (const Triangle& t : mesh.triangles) {
        const auto corner = [&](int i) {
            const Vertex& v = mesh.vertices[t.v[i]];
            return Vec3d{v.x, v.y, v.z} - p;
        };
        const Vec3d a = corner(0), b = corner(1), c = corner(2);
        const double la = length(a), lb = length(b), lc = length(c);
        sum += 2 * std::atan2(dot(a, cross(b, c)),
                              la * lb * lc + dot(a, b) * lc + dot(b, c) * la + dot(c, a) * lb);
    }
    return sum / (4 * std::numbers::pi);
}

TEST(CutOutlines, WindAsTheSurfaceDoes) {
    test::Random random(3);
    for (int round = 0; round < 12; ++round) {
        Solids solids;
        solids.begin("rings", kGrey);
        for (int i = 0; i < 3; ++i) {
            const Solids::Move move = turned(random.unitVector(), random.number(0, 180), random.vector(0.5F));
            if (random.coin()) {
                solids.ring(1, 0.4F, 17, 9, move);
            } else {
                solids.box({-0.7F, -0.7F, -0.7F}, {0.7F, 0.7F, 0.7F}, random.coin(), false, move);
            }
        }
        const Scene scene = solids.scene();
        const CutPlane plane = planeAt(random.vector(0.5F), random.unitVector());
        const std::vector<CutOutline> outlines = outlinesOf(scene, plane);
        int unsure = 0;
        for (int sample = 0; sample < 200; ++sample) {
            const FlatPoint p{double{random.number(-2, 2)}, double{random.number(-2, 2)}};
            const double expected = windingsOfSurface(scene.model.mesh, plane.point(p));
            if (std::fabs(expected - std::round(expected)) > 1e-3) {
                ++unsure;
                continue;
            }
            int sum = 0;
            for (const CutOutline& outline : outlines) {
                EXPECT_TRUE(outline.chains.empty());
                for (const FlatLoop& loop : outline.loops) sum += windings(loop, p);
            }
            ASSERT_EQ(sum, std::lround(expected)) << round;
        }
        EXPECT_LT(unsure, 10);
    }
}

} // namespace
