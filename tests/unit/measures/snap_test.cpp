// Corners, edges and faces that a pointer catches.
#include "measured_scene.h"
#include "rtcore/accel/visible_tree.h"
#include "rtcore/measures/snap.h"
#include "support/random_numbers.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace {

using namespace rtcore;
using test::MeasuredScene;
using test::Solids;

constexpr int kWidth = 400, kHeight = 300;
constexpr float kReach = 8;

Camera cameraFrom(Vec3 eye, Vec3 to) {
    Camera camera;
    camera.eye = eye;
    camera.forward = to - eye;
    camera.up = {0, 0, 1};
    return camera;
}

/// A pointer over an image of the scene.
class Pointer {
  public:
    Pointer(const MeasuredScene& scene, const Camera& camera)
        : scene_(scene), shown_(scene.shown()), rays_(camera, kWidth, kHeight) {}

    /// So many pixels right of and below where the point is seen.
    std::optional<Snap> at(Vec3 point, float right = 0, float down = 0) const {
        const auto pixel = pixelOf(rays_, point).value();
        return snapAt(scene_.scene, *shown_, rays_, static_cast<float>(pixel[0]) + right,
                      static_cast<float>(pixel[1]) + down, kReach);
    }

  private:
    const MeasuredScene& scene_;
    std::shared_ptr<const RayTracer> shown_;
    CameraRays rays_;
};

MeasuredScene box() {
    Solids solids;
    solids.begin("box", {0.5F, 0.5F, 0.5F});
    solids.box({-1, -1, -1}, {1, 1, 1});
    return MeasuredScene(solids);
}

void expectNear(Vec3 a, Vec3 b, float within) {
    EXPECT_LT(length(a - b), within) << a.x << ' ' << a.y << ' ' << a.z;
}

TEST(PixelOf, IsWhereTheRayGoes) {
    test::Random random(4);
    for (const CameraKind kind : {CameraKind::Perspective, CameraKind::Orthographic}) {
        Camera camera = cameraFrom({3, -5, 2}, {0, 0, 0});
        camera.kind = kind;
        camera.orthographicWidth = 7;
        const CameraRays rays(camera, kWidth, kHeight);
        for (int i = 0; i < 100; ++i) {
            const float x = random.number(0, kWidth), y = random.number(0, kHeight);
            const Ray ray = rays.at(x, y);
            const auto pixel = pixelOf(rays, ray.origin + ray.direction * random.number(1, 9));
            ASSERT_TRUE(pixel);
            EXPECT_NEAR((*pixel)[0], x, 1e-3);
            EXPECT_NEAR((*pixel)[1], y, 1e-3);
        }
    }
    EXPECT_FALSE(pixelOf(CameraRays(cameraFrom({3, 0, 0}, {0, 0, 0}), kWidth, kHeight), {4, 0, 0}))
        << "behind";
}

TEST(SnapAt, CatchesCornersBeforeMiddlesBeforeEdgesBeforeFaces) {
    const MeasuredScene scene = box();
    const Pointer pointer(scene, cameraFrom({4, -6, 3}, {0, 0, 0}));
    const std::optional<Snap> corner = pointer.at({1, -1, 1}, 3, -4);
    ASSERT_TRUE(corner);
    EXPECT_EQ(corner->kind, SnapKind::Corner);
    EXPECT_EQ(corner->point, (Vec3{1, -1, 1})) << "to the bit";
    const std::optional<Snap> middle = pointer.at({0, -1, 1}, 2, 2);
    ASSERT_TRUE(middle);
    EXPECT_EQ(middle->kind, SnapKind::Middle);
    EXPECT_EQ(middle->point, (Vec3{0, -1, 1}));
    const std::optional<Snap> edge = pointer.at({0.6F, -1, 1}, 0, 3);
    ASSERT_TRUE(edge);
    EXPECT_EQ(edge->kind, SnapKind::Edge);
    EXPECT_NEAR(edge->point.y, -1, 1e-6);
    EXPECT_NEAR(edge->point.z, 1, 1e-6);
    EXPECT_NEAR(edge->point.x, 0.6F, 0.05F);
    const std::optional<Snap> face = pointer.at({0.3F, -1, 0.2F});
    ASSERT_TRUE(face);
    EXPECT_EQ(face->kind, SnapKind::Face) << "the diagonal of the face is no edge";
    expectNear(face->point, {0.3F, -1, 0.2F}, 1e-4F);
    expectNear(face->normal, {0, -1, 0}, 1e-6F);
}

TEST(SnapAt, CatchesFromBesideTheModelAndNothingInTheVoid) {
    const MeasuredScene scene = box();
    const Pointer pointer(scene, cameraFrom({0, -6, 0}, {0, 0, 0}));
    const std::optional<Snap> corner = pointer.at({1, -1, 1}, 5, -5);
    ASSERT_TRUE(corner) << "off the silhouette";
    EXPECT_EQ(corner->kind, SnapKind::Corner);
    EXPECT_FALSE(pointer.at({1, -1, 1}, 30, -30));
}

TEST(SnapAt, LeavesWhatIsHidden) {
    Solids solids;
    solids.begin("box", {0.5F, 0.5F, 0.5F});
    solids.box({-1, -1, -1}, {1, 1, 1});
    solids.begin("screen", {0.5F, 0.5F, 0.5F});
    solids.box({-3, -3, -3}, {3, -2.9F, 3});
    MeasuredScene scene(solids);
    const Camera camera = cameraFrom({0, -9, 0}, {0, 0, 0});
    const std::optional<Snap> snap = Pointer(scene, camera).at({1, -1, 1});
    ASSERT_TRUE(snap);
    EXPECT_EQ(snap->kind, SnapKind::Face) << "the screen is before it";
    scene.scene.hiddenParts =
        std::make_shared<const std::vector<std::uint8_t>>(std::vector<std::uint8_t>{0, 1});
    scene.tree = buildVisibleTree(
        scene.scene.model.mesh, partTriangles(scene.scene.model, scene.scene.hiddenParts), scene.tree.bounds);
    scene.surfaces = std::make_shared<const KdRayTracer>(scene.tree, scene.scene.model.mesh);
    EXPECT_EQ(Pointer(scene, camera).at({1, -1, 1})->kind, SnapKind::Corner);
}

TEST(SnapAt, LeavesWhatSectionsTookAway) {
    MeasuredScene scene = box();
    scene.scene.sections.planes = {{{0, 0, 0.5F}, {0, 0, 1}}};
    const Pointer pointer(scene, cameraFrom({4, -6, 3}, {0, 0, 0}));
    const std::optional<Snap> gone = pointer.at({1, -1, 1});
    EXPECT_TRUE(!gone || gone->kind == SnapKind::Face);
    EXPECT_EQ(pointer.at({1, -1, -1})->kind, SnapKind::Corner) << "it is still there";
}

// Faces of many triangles: only what is an edge of the solid is caught, and turned and far away the same.
TEST(SnapAt, CatchesNoCornersOfTriangulations) {
    for (const float far : {0.F, 1000.F}) {
        Solids solids;
        solids.begin("ring", {0.5F, 0.5F, 0.5F});
        solids.ring(2, 0.5F, 200, 100, test::turned({1, 2, 3}, 40, {far, far, far}));
        const MeasuredScene scene(solids);
        const Vec3 middle{far, far, far};
        const Pointer pointer(scene, cameraFrom(middle + Vec3{4, -6, 3}, middle));
        test::Random random(6);
        int caught = 0;
        for (int i = 0; i < 40; ++i) {
            const std::optional<Snap> snap =
                pointer.at(middle, random.number(-80, 80), random.number(-60, 60));
            if (!snap) continue;
            EXPECT_EQ(snap->kind, SnapKind::Face);
            ++caught;
        }
        EXPECT_GT(caught, 10);
    }
}

TEST(SnapAt, WorksByParallelCameras) {
    const MeasuredScene scene = box();
    Camera camera = cameraFrom({0, -6, 0}, {0, 0, 0});
    camera.kind = CameraKind::Orthographic;
    camera.orthographicWidth = 4;
    const Pointer pointer(scene, camera);
    EXPECT_EQ(pointer.at({1, -1, 1}, -3, 3)->point, (Vec3{1, -1, 1}));
    const std::optional<Snap> edge = pointer.at({1, -1, 0.4F}, -3, 0);
    ASSERT_TRUE(edge);
    EXPECT_EQ(edge->kind, SnapKind::Edge);
    expectNear(edge->point, {1, -1, 0.4F}, 1e-5F);
}

} // namespace
