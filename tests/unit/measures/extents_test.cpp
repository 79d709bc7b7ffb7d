// Areas, volumes and clearances that are known.
#include "measured_scene.h"
#include "rtcore/measures/extents.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

namespace {

using namespace rtcore;
using test::MeasuredScene;
using test::Solids;

constexpr Colour kStone{0.5F, 0.5F, 0.5F};

/// The first triangle whose middle is that point.
std::uint32_t triangleAt(const Scene& scene, Vec3 p) {
    RayWave rays;
    HitWave hits;
    const KdTree tree = buildKdTree(scene.model.mesh, {});
    rays.push({p, 0, {0, 0, -1}, 1e6F});
    KdRayTracer(tree, scene.model.mesh).intersect(RayKind::Primary, rays, hits);
    return hits.triangle[0];
}

TEST(AreaOfFace, IsOfWhatHangsTogetherInAPlane) {
    Solids solids;
    solids.begin("slab", kStone);
    solids.box({0, 0, 0}, {3, 2, 1});
    solids.begin("another", kStone);
    solids.box({5, 0, 0}, {6, 1, 1}); // in the same plane, apart
    const MeasuredScene scene(solids);
    EXPECT_NEAR(areaOfFace(scene.scene, triangleAt(scene.scene, {1, 1, 5})), 6, 1e-5);
    EXPECT_NEAR(areaOfFace(scene.scene, triangleAt(scene.scene, {5.5F, 0.4F, 5})), 1, 1e-5);
    EXPECT_EQ(areaOfFace(scene.scene, 1'000'000), 0) << "of what is no triangle of the model";
}

TEST(AreaOfFace, IsTheSameTurnedAndScaled) {
    for (const float scale : {0.01F, 1.F, 300.F}) {
        Solids solids;
        solids.begin("slab", kStone);
        const Solids::Move turn = test::turned({1, 1, 0.2F}, 25, {scale, 2 * scale, 0});
        solids.box(Vec3{0, 0, 0}, scale * Vec3{3, 2, 1}, false, false, turn);
        const MeasuredScene scene(solids);
        const Vec3 top = turn(scale * Vec3{1, 1, 1});
        const std::uint32_t triangle = triangleAt(scene.scene, top + Vec3{0, 0, scale});
        EXPECT_NEAR(areaOfFace(scene.scene, triangle) / (scale * scale), 6, 6e-5) << scale;
    }
}

TEST(VolumeOf, IsOfClosedPartsWithoutTheirHollows) {
    Solids solids;
    solids.begin("hollow", kStone);
    solids.box({0, 0, 0}, {3, 2, 1});
    solids.box({1, 0.5F, 0.25F}, {2, 1.5F, 0.75F}, true);
    solids.begin("ring", kStone);
    solids.ring(2, 0.5F, 400, 200);
    solids.begin("open", kStone);
    solids.box({9, 0, 0}, {10, 1, 1}, false, true);
    const MeasuredScene scene(solids);
    ClosedPieces pieces(scene.scene.model);
    const auto volume = [&](std::vector<std::uint32_t> parts) {
        return volumeOf(scene.scene.model, parts, pieces);
    };
    EXPECT_NEAR(*volume({0}), 6 - 0.5, 1e-5);
    EXPECT_NEAR(*volume({1}), 2 * M_PI * M_PI * 2 * 0.25, 0.003);
    EXPECT_NEAR(*volume({0, 1}), 5.5 + *volume({1}), 1e-6);
    EXPECT_FALSE(volume({2}));
    EXPECT_FALSE(volume({0, 2}));
}

TEST(ClearanceFrom, IsUpToTheNextSurface) {
    Solids solids;
    solids.begin("floor", kStone);
    solids.box({0, 0, -1}, {4, 4, 0});
    solids.begin("ceiling", kStone);
    solids.box({0, 0, 2.5F}, {4, 4, 3});
    const MeasuredScene scene(solids);
    EXPECT_NEAR(*clearanceFrom(*scene.shown(), {1, 1, 0}, {0, 0, 1}), 2.5, 1e-5);
    EXPECT_NEAR(*clearanceFrom(*scene.shown(), {1, 1, 2.5F}, {0, 0, -1}), 2.5, 1e-5);
    EXPECT_FALSE(clearanceFrom(*scene.shown(), {1, 1, 3}, {0, 0, 1}));
}

} // namespace
