// A view that turns about a point keeps it where it is in the image, and stays upright.
#include "rtcore/motion/orbit.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace {

using rtcore::Camera;
using rtcore::CameraKind;
using rtcore::Vec3;

constexpr float kTurn = 6.2831853F;

/// Right, up: halves of the image's width.
struct Place {
    double right, up;
};

Place placeOf(const Camera& camera, Vec3 point) {
    const Vec3 forward = normalize(camera.forward);
    const Vec3 right = normalize(cross(forward, camera.up)), up = cross(right, forward);
    const Vec3 way = point - camera.eye;
    const float half = camera.kind == CameraKind::Orthographic
                           ? camera.orthographicWidth / 2
                           : dot(way, forward) * std::tan(camera.horizontalFov * kTurn / 720);
    return {double{dot(way, right) / half}, double{dot(way, up) / half}};
}

void expectSamePlace(const Camera& a, const Camera& b, Vec3 point) {
    const Place before = placeOf(a, point), after = placeOf(b, point);
    constexpr double kHalfPixel = 1e-3; // of an image of 1000 pixels
    EXPECT_NEAR(before.right, after.right, kHalfPixel);
    EXPECT_NEAR(before.up, after.up, kHalfPixel);
}

/// Cameras around the origin, and a point that each sees.
class AnyView {
  public:
    explicit AnyView(bool orthographic) : orthographic_(orthographic) {}
    float number(float from, float to) { return std::uniform_real_distribution<float>(from, to)(random_); }
    Vec3 within(float size) { return {number(-size, size), number(-size, size), number(-size, size)}; }
    Vec3 up() { return axes_[static_cast<std::size_t>(number(0, 5.99F))]; }
    Camera camera(Vec3 up) {
        Camera camera;
        do camera.eye = within(20);
        while (length(camera.eye) < 8 || std::fabs(dot(normalize(camera.eye), up)) > 0.95F);
        camera.forward = within(2) - camera.eye;
        camera.up = up;
        camera.horizontalFov = number(20, 90);
        if (orthographic_) camera.kind = CameraKind::Orthographic;
        if (orthographic_) camera.orthographicWidth = number(1, 40);
        return camera;
    }

  private:
    bool orthographic_;
    std::mt19937 random_{7};
    const std::array<Vec3, 6> axes_{{{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}}};
};

class Orbit : public testing::TestWithParam<bool> {};

TEST_P(Orbit, KeepsThePointInTheImageAndStaysUpright) {
    AnyView any(GetParam());
    for (int i = 0; i < 1000; ++i) {
        const Vec3 up = any.up(), pivot = any.within(2);
        const Camera before = any.camera(up);
        const Camera after = orbited(before, up, pivot, any.number(-3, 3), any.number(-0.5F, 0.5F));
        expectSamePlace(before, after, pivot);
        EXPECT_NEAR(length(after.eye - pivot) / length(before.eye - pivot), 1, 1e-4);
        EXPECT_EQ(after.up, up);
    }
}

TEST_P(Orbit, GoesTowardsThePointWhichStaysInTheImage) {
    AnyView any(GetParam());
    for (int i = 0; i < 1000; ++i) {
        const Camera before = any.camera({0, 1, 0});
        const Vec3 pivot = any.within(2);
        const Camera after = approached(before, pivot, std::exp(double{any.number(-2, 2)}));
        expectSamePlace(before, after, pivot);
        EXPECT_EQ(after.forward, before.forward);
    }
}

INSTANTIATE_TEST_SUITE_P(Cameras, Orbit, testing::Bool());

TEST(OrbitOfAThing, TurnsItTheWayTheHandGoes) {
    Camera camera;
    camera.eye = {0, 0, 10};
    // Its right side comes away, so that its left side is seen.
    EXPECT_LT(orbited(camera, {0, 1, 0}, {}, 0.5, 0).eye.x, -1);
    EXPECT_LT(orbited(camera, {0, 1, 0}, {}, 0, 0.5).eye.y, -1);
    // Over the top it goes no further.
    const Camera top = orbited(camera, {0, 1, 0}, {}, 0, -3);
    EXPECT_GT(top.eye.y, 9.9F);
    EXPECT_LT(top.eye.z, 0.2F);
    EXPECT_GT(top.eye.z, 0);
}

TEST(OrbitOfAThing, IsShiftedAcrossTheImage) {
    Camera camera;
    camera.eye = {0, 0, 10};
    EXPECT_EQ(shifted(camera, 2, 3).eye, Vec3(2, 3, 10));
}

} // namespace
