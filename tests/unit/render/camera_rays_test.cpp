#include "rtcore/render/camera_rays.h"

#include "support/steps.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace rtcore {
namespace {

constexpr double kHalfTurn = 3.14159265358979323846; // radians

Camera cameraOf(float fov) {
    Camera camera;
    camera.eye = {1, 2, 3};
    camera.horizontalFov = fov;
    return camera;
}
double angleBetween(Vec3 a, Vec3 b) { return std::atan2(length(cross(a, b)), dot(a, b)) * 180 / kHalfTurn; }

TEST(CameraRays, TheMiddleLooksForward) {
    const CameraRays rays(cameraOf(60), 640, 480);
    const Ray ray = rays.at(320, 240);
    EXPECT_EQ(ray.origin, (Vec3{1, 2, 3}));
    EXPECT_NEAR(angleBetween(ray.direction, {0, 0, -1}), 0, 1e-5);
    EXPECT_EQ(ray.tMin, 0);
    EXPECT_EQ(ray.tMax, std::numeric_limits<float>::max());
}

TEST(CameraRays, RightIsRightAndUpIsUp) {
    const CameraRays rays(cameraOf(60), 640, 480);
    EXPECT_GT(rays.at(640, 240).direction.x, 0.1F);
    EXPECT_GT(rays.at(320, 0).direction.y, 0.1F);
    EXPECT_NEAR(rays.at(640, 240).direction.y, 0, 1e-7);
    EXPECT_NEAR(rays.at(320, 0).direction.x, 0, 1e-7);
}

TEST(CameraRays, TheFieldOfViewIsExactBetweenLeftAndRightEdge) {
    for (const float fov : {0.5F, 1.0F, 30.0F, 60.0F, 90.0F, 120.0F, 150.0F, 175.0F, 179.0F}) {
        const CameraRays rays(cameraOf(fov), 1920, 1080);
        const Vec3 left = rays.at(0, 540).direction, right = rays.at(1920, 540).direction;
        EXPECT_NEAR(angleBetween(left, right), fov, 2e-5) << fov;
        EXPECT_NEAR(angleBetween(left, {0, 0, -1}), fov / 2, 2e-5) << fov;
    }
}

/// Tangents of the angles from the middle to the right and to the upper edge.
std::pair<float, float> extentOf(const Camera& camera, int width, int height) {
    const CameraRays rays(camera, width, height);
    const auto w = static_cast<float>(width), h = static_cast<float>(height);
    const Vec3 right = rays.at(w, h / 2).direction, top = rays.at(w / 2, 0).direction;
    return {right.x / -right.z, top.y / -top.z};
}

TEST(CameraRays, AllThatTheAuthorFramedIsSeen) {
    Camera camera = cameraOf(90);
    camera.aspect = 2;
    for (const auto& [width, height] : {std::pair{300, 100}, {200, 100}, {100, 100}, {50, 100}}) {
        const auto [across, up] = extentOf(camera, width, height);
        EXPECT_NEAR(across, std::max(1.0, 0.5 * width / height), 1e-5) << width;
        EXPECT_NEAR(up, std::max(0.5, 1.0 * height / width), 1e-5) << width;
        EXPECT_NEAR(fieldOfView(camera, width, height), 2 * std::atan(across) * 180 / kHalfTurn, 1e-3);
    }
    EXPECT_EQ(extentOf(camera, 200, 100), extentOf(cameraOf(90), 200, 100));
    EXPECT_EQ(fieldOfView(cameraOf(71.3F), 300, 100), 71.3F);
}

TEST(CameraRays, OrthographicOnesAreParallel) {
    Camera camera = cameraOf(60);
    camera.kind = CameraKind::Orthographic;
    camera.orthographicWidth = 8;
    const CameraRays rays(camera, 400, 200);
    EXPECT_TRUE(rays.parallel());
    for (const auto& [x, y] : {std::pair{0.0F, 0.0F}, {200.0F, 100.0F}, {400.0F, 200.0F}, {30.5F, 7.5F}}) {
        const Ray ray = rays.at(x, y);
        EXPECT_EQ(ray.direction, (Vec3{0, 0, -1}));
        EXPECT_NEAR(ray.origin.x, 1 + (x - 200) / 50, 1e-5F);
        EXPECT_NEAR(ray.origin.y, 2 - (y - 100) / 50, 1e-5F);
        EXPECT_EQ(ray.origin.z, 3);
        const Ray coarse = rays.coarser(2).at(x / 2, y / 2);
        EXPECT_NEAR(length(coarse.origin - ray.origin), 0, 1e-5F);
    }
    EXPECT_EQ(fieldOfView(camera, 400, 200), 0);
    camera.aspect = 1;
    EXPECT_NEAR(CameraRays(camera, 400, 200).at(400, 100).origin.x, 1 + 8, 1e-5F);
    EXPECT_NEAR(CameraRays(camera, 200, 400).at(200, 200).origin.x, 1 + 4, 1e-5F);
}

TEST(CameraRays, CornersAreSymmetric) {
    const CameraRays rays(cameraOf(90), 200, 100);
    const Vec3 corner = normalize({1, 0.5F, -1});
    EXPECT_NEAR(angleBetween(rays.at(200, 0).direction, corner), 0, 1e-4);
    EXPECT_NEAR(angleBetween(rays.at(0, 0).direction, {-corner.x, corner.y, corner.z}), 0, 1e-4);
    EXPECT_NEAR(angleBetween(rays.at(200, 100).direction, {corner.x, -corner.y, corner.z}), 0, 1e-4);
    EXPECT_NEAR(angleBetween(rays.at(0, 100).direction, {-corner.x, -corner.y, corner.z}), 0, 1e-4);
}

TEST(CameraRays, PixelsAreSquare) {
    for (const auto& [w, h] : {std::pair{640, 480}, {100, 1000}, {1, 1}, {1920, 1080}}) {
        const CameraRays rays(cameraOf(40), w, h);
        const auto x = static_cast<float>(w) / 2, y = static_cast<float>(h) / 2;
        const double aside =
            std::tan(angleBetween(rays.at(x, y).direction, rays.at(x + 1, y).direction) * kHalfTurn / 180);
        const double below =
            std::tan(angleBetween(rays.at(x, y).direction, rays.at(x, y + 1).direction) * kHalfTurn / 180);
        EXPECT_NEAR(aside / below, 1, 1e-3);
        EXPECT_NEAR(aside, 2 * std::tan(20 * kHalfTurn / 180) / w, 1e-6);
    }
}

TEST(CameraRays, AHundredAndFiftyDegreesRectilinear) {
    const CameraRays rays(cameraOf(150), 1920, 1080);
    const Vec3 forward{0, 0, -1};
    // The focal length is 257.231225 pixels: so is the distance at which the angle is 45 degrees.
    EXPECT_NEAR(angleBetween(rays.at(960 + 257.231225F, 540).direction, forward), 45, 1e-4);
    EXPECT_NEAR(angleBetween(rays.at(960 + 480, 540).direction, forward), 61.813215, 1e-4);
    EXPECT_NEAR(angleBetween(rays.at(960, 0).direction, rays.at(960, 1080).direction), 129.058025, 1e-4);
    // Stretched at the edge: radial by 14.928203, tangential by 3.863703.
    const double middle = angleBetween(rays.at(960, 540).direction, rays.at(961, 540).direction);
    EXPECT_NEAR(middle / angleBetween(rays.at(1919.5F, 540).direction, rays.at(1920.5F, 540).direction),
                14.928203, 0.01);
    EXPECT_NEAR(middle / angleBetween(rays.at(1920, 539.5F).direction, rays.at(1920, 540.5F).direction),
                3.863703, 0.01);
}

TEST(CameraRays, DirectionsAreOfUnitLength) {
    const CameraRays rays(cameraOf(170), 640, 480);
    for (const float y : test::steps(0.0F, 480.0F + 37.0F / 2, 37.0F)) {
        for (const float x : test::steps(0.0F, 640.0F + 41.0F / 2, 41.0F))
            EXPECT_NEAR(length(rays.at(x, y).direction), 1, 2e-7);
    }
}

TEST(CameraRays, ForwardAndUpOfAnyLength) {
    Camera camera = cameraOf(60);
    camera.forward = {1, 2, 3};
    camera.up = {0, 1, 0.5F};
    const CameraRays expected(camera, 64, 48);
    for (const float size : {1e-20F, 1e20F}) {
        camera.forward = Vec3{1, 2, 3} * size;
        camera.up = Vec3{0, 1, 0.5F} * (1 / size);
        EXPECT_NEAR(angleBetween(CameraRays(camera, 64, 48).at(7, 9).direction, expected.at(7, 9).direction),
                    0, 1e-4);
    }
}

/// How far the image is from an image: angles between its axes and of its width, in degrees.
void expectSound(const Camera& camera) {
    const CameraRays rays(camera, 100, 100);
    const Vec3 forward = normalize(camera.forward);
    const Vec3 left = rays.at(0, 50).direction, right = rays.at(100, 50).direction;
    const Vec3 top = rays.at(50, 0).direction, bottom = rays.at(50, 100).direction;
    EXPECT_NEAR(angleBetween(left, right), camera.horizontalFov, 1e-3);
    EXPECT_NEAR(angleBetween(top, bottom), camera.horizontalFov, 1e-3);
    EXPECT_NEAR(angleBetween(rays.at(50, 50).direction, forward), 0, 1e-4);
    EXPECT_NEAR(dot(right - left, bottom - top), 0, 1e-5);
    EXPECT_NEAR(dot(right - left, forward), 0, 1e-5);
    EXPECT_LT(dot(cross(forward, normalize(top - bottom)), right - left) * -1, 0); // not mirrored
}

TEST(CameraRays, UpNearlyParallelToForward) {
    for (const Vec3 forward :
         {Vec3{0, -1, 0}, {0, 1, 0}, normalize({1, 2, 3}), {0, 0, 1}, normalize({-3, 0.1F, 1})}) {
        const Vec3 aside = basisAround(forward).tangent;
        for (const float tilt : {0.0F, 1e-8F, 1e-7F, 1e-6F, 3e-6F, 1e-5F, 1e-4F, 1e-2F}) {
            for (const float sign : {1.0F, -1.0F}) {
                Camera camera = cameraOf(70);
                camera.forward = forward;
                camera.up = (forward * sign + aside * tilt) * 3.3F;
                SCOPED_TRACE(tilt);
                expectSound(camera);
            }
        }
    }
}

TEST(CameraRays, UpTurnsThePicture) {
    Camera camera = cameraOf(60);
    camera.up = {1, 0, 0}; // lying on its side
    const CameraRays rays(camera, 100, 100);
    EXPECT_GT(rays.at(50, 0).direction.x, 0.1F);
    EXPECT_LT(rays.at(100, 50).direction.y, -0.1F);
}

TEST(CameraRays, TheWidestFieldOfViewIsNotTurnedOver) {
    const CameraRays rays(cameraOf(std::nextafter(180.0F, 0.0F)), 100, 100);
    EXPECT_GT(rays.at(100, 50).direction.x, 0.99F);
    EXPECT_LE(rays.at(100, 50).direction.z, 0);
}

TEST(CameraRays, APanoramaSeesEachDirectionWhereItBelongs) {
    constexpr int kWidth = 720, kHeight = 360; // half a degree a pixel
    Camera camera = cameraOf(60);
    camera.kind = CameraKind::Panorama;
    camera.forward = {0, 0, -1};
    const CameraRays rays(camera, kWidth, kHeight);
    EXPECT_TRUE(rays.panorama());
    float dx[kCameraBlockRays], dy[kCameraBlockRays], dz[kCameraBlockRays];
    for (int y = 0; y < kHeight; y += kCameraBlock) {
        for (int x = 0; x < kWidth; x += kCameraBlock) {
            rays.directions({0, 0, x, y, 1}, dx, dy, dz);
            for (int i = 0; i < kCameraBlockRays; ++i) {
                const double right = (x + columnInBlock(i) + 0.5) / kWidth * 2 * kHalfTurn - kHalfTurn;
                const double above = kHalfTurn / 2 - (y + rowInBlock(i) + 0.5) / kHeight * kHalfTurn;
                ASSERT_NEAR(dx[i], std::cos(above) * std::sin(right), 1e-6) << x << " " << y;
                ASSERT_NEAR(dy[i], std::sin(above), 1e-6) << x << " " << y;
                ASSERT_NEAR(dz[i], -std::cos(above) * std::cos(right), 1e-6) << x << " " << y;
            }
        }
    }
    EXPECT_LT(angleBetween(rays.at(360, 180).direction, {0, 0, -1}), 1e-4);
    EXPECT_LT(angleBetween(rays.at(540, 180).direction, {1, 0, 0}), 1e-4);
    EXPECT_LT(angleBetween(rays.at(0, 180).direction, rays.at(720, 180).direction), 1e-4) << "the seam";
    EXPECT_LT(angleBetween(rays.at(100, 0).direction, {0, 1, 0}), 1e-4);
    EXPECT_NEAR(length(rays.plane().right) * kWidth, 2 * kHalfTurn, 1e-5) << "the size of a pixel";
    EXPECT_EQ(fieldOfView(camera, kWidth, kHeight), 360);
    // Coarser: the same view in fewer pixels.
    EXPECT_LT(angleBetween(rays.coarser(4).at(135, 45).direction, {1, 0, 0}), 1e-4);
}

} // namespace
} // namespace rtcore
