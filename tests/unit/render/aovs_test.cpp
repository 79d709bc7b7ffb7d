// The AOVs of images against the true values of their surfaces.
#include "rtcore/render/frame_renderer.h"

#include "sample_view.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

namespace rtcore {
namespace {

Frame aovsOf(const Scene& scene, const Camera& camera, const RenderSettings& settings, int threads = 1) {
    const test::TracedScene traced(scene);
    FrameRenderer renderer;
    renderer.collectAovs(true);
    RenderControl control{.threads = threads};
    Frame frame;
    EXPECT_TRUE(renderer.render({traced.scene, traced.tracer, camera, settings}, control, frame));
    return frame;
}

const AovPixel& at(const Frame& frame, int x, int y) {
    return frame.aovs.pixels()[static_cast<std::size_t>(y) * static_cast<std::size_t>(frame.aovs.width()) +
                               static_cast<std::size_t>(x)];
}

/// Looks along -z from the origin at a wall 4 away, which fills the left half, under a light beside the eye.
Scene wall(const Material& material) {
    test::SceneBuilder b;
    b.square({-20, 0, -4}, {0, 0, 1}, 20, b.material(material));
    b.scene.lights = {test::pointLight({0, 0, -1}, 10)};
    b.scene.ambient = {0.3F, 0.3F, 0.3F};
    return b.finish();
}

Camera straight() {
    Camera camera;
    camera.forward = {0, 0, -3};
    camera.horizontalFov = 90;
    return camera;
}

TEST(Aovs, AreThoseOfAWall) {
    Material grey = test::matte(0.5F);
    grey.diffuse = {0.5F, 0.25F, 0.125F};
    for (const int antialiasing : {1, 3}) {
        const Frame frame = aovsOf(wall(grey), straight(), test::sampleSettings(40, 30, antialiasing));
        for (int y = 0; y < 30; ++y) {
            for (int x = 0; x < 20; ++x) {
                const AovPixel& pixel = at(frame, x, y);
                // Along the axis, not along the ray.
                ASSERT_NEAR(pixel.depth, 4, 1e-4F);
                ASSERT_NEAR(pixel.normal.z, 1, 1e-5F);
                ASSERT_NEAR(pixel.albedo.r, 0.5F, 1e-5F);
                ASSERT_NEAR(pixel.albedo.g, 0.25F, 1e-5F);
                ASSERT_EQ(pixel.covered, 1);
                ASSERT_EQ(pixel.soft, Colour{});
            }
            for (int x = 20; x < 40; ++x) {
                const AovPixel& pixel = at(frame, x, y);
                ASSERT_EQ(pixel.depth, kBackgroundDepth);
                ASSERT_EQ(pixel.normal, Vec3{});
                ASSERT_EQ(pixel.albedo, Colour{});
                ASSERT_EQ(pixel.direct, Colour{});
                ASSERT_EQ(pixel.covered, 0);
            }
        }
        // The light is 3 off the wall: E = I cos / d^2, and ambient light is no light of lights.
        const AovPixel& pixel = at(frame, 10, 12);
        const float px = (10.5F - 20) / 20 * 4, py = (15 - 12.5F) / 20 * 4;
        const float d2 = px * px + py * py + 9;
        const float expected = 0.5F / 3.14159265F * 10 * 3 / (d2 * std::sqrt(d2));
        EXPECT_NEAR(pixel.direct.r, expected, 0.002F * expected);
        EXPECT_NEAR(frame.radiance.at(10, 12).r, expected + 0.3F * 0.5F, 0.002F);
    }
}

TEST(Aovs, TakeTheNearestDepthOfAPixelAndMeansOfTheRest) {
    // With two samples across, the wall covers half of one column of pixels of 41.
    const Frame frame = aovsOf(wall(test::matte(0.5F)), straight(), test::sampleSettings(41, 31, 2));
    const AovPixel& pixel = at(frame, 20, 15);
    EXPECT_EQ(pixel.covered, 0.5F);
    EXPECT_NEAR(pixel.depth, 4, 1e-4F);
    EXPECT_NEAR(pixel.normal.z, 0.5F, 1e-5F);
    EXPECT_NEAR(pixel.albedo.g, 0.25F, 1e-5F);
}

TEST(Aovs, OfMirrorsAndGlassAreThoseOfTheirOwnSurface) {
    const Frame mirror = aovsOf(wall(test::mirror(0.6F)), straight(), test::sampleSettings(40, 30));
    EXPECT_NEAR(at(mirror, 10, 15).albedo.r, 0.6F, 1e-4F);
    EXPECT_NEAR(at(mirror, 10, 15).depth, 4, 1e-4F);
    const Frame glass = aovsOf(wall(test::glass()), straight(), test::sampleSettings(40, 30));
    EXPECT_NEAR(at(glass, 10, 15).albedo.r, 1, 1e-4F);
    EXPECT_NEAR(at(glass, 10, 15).depth, 4, 1e-4F);
}

TEST(Aovs, SeeThroughHoles) {
    test::SceneBuilder b;
    Material leaf = test::matte(0.9F);
    leaf.alphaTexture = b.texture(1, 1, {{0, 0, 0, 255}});
    b.square({0, 0, -2}, {0, 0, 1}, 20, b.material(leaf));
    b.square({0, 0, -7}, {0, 0, 1}, 40, b.material(test::matte(0.4F)));
    b.scene.lights = {test::pointLight({0, 0, -4}, 10)};
    const Frame frame = aovsOf(b.finish(), straight(), test::sampleSettings(20, 16));
    const AovPixel& pixel = at(frame, 10, 8);
    EXPECT_NEAR(pixel.depth, 7, 1e-3F);
    EXPECT_NEAR(pixel.albedo.r, 0.4F, 1e-4F);
    EXPECT_NEAR(pixel.direct.r, frame.radiance.at(10, 8).r, 1e-5F);
    EXPECT_GT(pixel.direct.r, 0);
}

// An infinite corner sees half of the ambient light at its edge, all of it far from it.
TEST(Aovs, TellAmbientOcclusion) {
    test::SceneBuilder b;
    const std::uint32_t material = b.material(test::matte(0.5F));
    b.square({0, 0, -10}, {0, 0, 1}, 500, material);
    b.square({0, -1, -10}, {0, 1, 0}, 500, material);
    RenderSettings settings = test::sampleSettings(40, 30);
    settings.ambientOcclusion.on = true;
    settings.ambientOcclusion.samples = 64;
    settings.ambientOcclusion.distance = 2;
    const Frame frame = aovsOf(b.finish(), straight(), settings);
    EXPECT_NEAR(at(frame, 20, 2).visible, 1, 0.01F);
    const AovPixel& low = at(frame, 20, 16); // just above the floor
    EXPECT_LT(low.visible, 0.75F);
    EXPECT_NEAR(low.soft.r, frame.radiance.at(20, 16).r, 1e-5F);
    EXPECT_EQ(low.direct, Colour{});
}

TEST(Aovs, ChangeNothingOfThePicture) {
    RenderSettings settings = test::sampleSettings(97, 61, 2);
    settings.ambientOcclusion.on = true;
    const Scene scene = test::softlyLitScene();
    const Frame with = aovsOf(scene, test::sampleCamera(), settings);
    EXPECT_EQ(with.radiance.pixels, test::render(test::TracedScene(scene), settings).radiance.pixels);
    EXPECT_TRUE(test::render(test::TracedScene(scene), settings).aovs.empty());
    for (const int threads : {2, 3}) {
        const Frame again = aovsOf(scene, test::sampleCamera(), settings, threads);
        ASSERT_EQ(again.aovs.pixels().size(), with.aovs.pixels().size());
        EXPECT_EQ(std::memcmp(again.aovs.pixels().data(), with.aovs.pixels().data(),
                              with.aovs.pixels().size() * sizeof(AovPixel)),
                  0);
    }
}

} // namespace
} // namespace rtcore
