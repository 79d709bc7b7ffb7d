#include "rtcore/live/image_plane.h"

#include "unit/render/sample_view.h"

#include <gtest/gtest.h>

namespace rtcore {
namespace {

TEST(ImagePlane, FindsThePointOfARayAtItsPixel) {
    const CameraRays rays(test::sampleCamera(), 101, 67);
    const ImagePlane plane(rays, 101, 67);
    for (const float x : {0.5F, 33.25F, 100.5F}) {
        for (const float y : {0.5F, 12.75F, 66.5F}) {
            for (const float t : {0.01F, 1.0F, 5000.0F}) {
                const Vec3 offset = rays.at(x, y).direction * t;
                const float depth = dot(plane.axis, offset);
                ASSERT_GT(depth, 0);
                EXPECT_NEAR(dot(plane.column, offset) / depth, x, 1e-3F);
                EXPECT_NEAR(dot(plane.row, offset) / depth, y, 1e-3F);
            }
            EXPECT_NEAR(dot(plane.axis, plane.towards(x, y)), 1, 1e-5F);
            EXPECT_NEAR(length(cross(normalize(plane.towards(x, y)), rays.at(x, y).direction)), 0, 1e-6F);
        }
    }
}

TEST(ImagePlane, FindsThePointOfAParallelRayAtItsPixel) {
    Camera camera = test::sampleCamera();
    camera.kind = CameraKind::Orthographic;
    camera.orthographicWidth = 7;
    const CameraRays rays(camera, 101, 67);
    const ImagePlane plane(rays, 101, 67);
    EXPECT_NEAR(plane.addedDepth, 7, 1e-5F);
    for (const float x : {0.5F, 33.25F, 100.5F}) {
        for (const float y : {0.5F, 12.75F, 66.5F}) {
            for (const float t : {0.0F, 1.0F, 50.0F}) {
                const Ray ray = rays.at(x, y);
                const Vec3 point = ray.origin + ray.direction * t, offset = point - plane.eye - plane.corner;
                EXPECT_NEAR(dot(plane.column, offset), x, 1e-3F);
                EXPECT_NEAR(dot(plane.row, offset), y, 1e-3F);
                EXPECT_NEAR(plane.depthOf(point), t, 1e-5F * (1 + t));
                EXPECT_NEAR(length(plane.inDepth(x, y, t) - point), 0, 1e-5F * (1 + t));
                EXPECT_NEAR(length(plane.alongRay(point, 3) - plane.inDepth(x, y, 3)), 0, 1e-4F);
            }
        }
    }
}

TEST(ImagePlane, HasNothingInItThatIsBehindTheEye) {
    const CameraRays rays(test::sampleCamera(), 101, 67);
    const ImagePlane plane(rays, 101, 67);
    EXPECT_LT(dot(plane.axis, -rays.at(50, 30).direction), 0);
}

} // namespace
} // namespace rtcore
