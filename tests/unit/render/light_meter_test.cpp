// The meter, against light whose strength is known.
#include "rtcore/render/light_meter.h"
#include "rtcore/render/view_light.h"

#include "rtcore/post/develop.h"

#include "sample_view.h"
#include "support/one_frame.h"

#include <gtest/gtest.h>

#include <numbers>
#include <optional>

namespace rtcore {
namespace {

constexpr float kPi = std::numbers::pi_v<float>;

/// Fills the image of a camera in the origin that looks along -z, in light from behind it.
Scene wallOf(const Material& material, float irradiance) {
    test::SceneBuilder b;
    b.square({0, 0, -4}, {0, 0, 1}, 50, b.material(material));
    Light sun;
    sun.kind = LightKind::Directional;
    sun.direction = {0, 0, -1};
    sun.intensity = kWhite * irradiance;
    b.scene.lights = {sun};
    return b.finish();
}

Camera ahead() {
    Camera camera;
    camera.forward = {0, 0, -1};
    camera.horizontalFov = 60;
    return camera;
}

std::optional<float> whiteOf(const Scene& scene, RenderSettings settings = test::sampleSettings(320, 200),
                             int threads = 1) {
    const test::TracedScene traced(scene);
    RenderControl control{.threads = threads};
    const Camera camera = ahead();
    return LightMeter().white({traced.scene, traced.tracer, camera, settings}, control);
}

RenderSettings byPaths() {
    RenderSettings settings = test::sampleSettings(320, 200);
    settings.integrator = Integrator::Path;
    return settings;
}

TEST(LightMeter, MeasuresTheLightAndNotTheSurface) {
    for (const float albedo : {0.05F, 0.18F, 0.5F, 0.9F}) {
        const Scene scene = wallOf(test::matte(albedo), 7);
        EXPECT_NEAR(whiteOf(scene).value_or(0), 7 / kPi, 0.01F) << albedo;
        EXPECT_NEAR(whiteOf(scene, byPaths()).value_or(0), 7 / kPi, 0.01F) << albedo;
    }
}

TEST(LightMeter, ShowsWhiteAsWhiteGreyAsGreyAndBlackAsBlack) {
    RenderSettings settings = test::sampleSettings(64, 40);
    settings.exposure.mode = ExposureMode::Incident;
    settings.dithering = false;
    for (const ToneMapping curve : {ToneMapping::Luminance, ToneMapping::AgX, ToneMapping::Neutral}) {
        settings.toneMapping = curve;
        int before = 0;
        for (const float albedo : {0.02F, 0.18F, 0.9F}) {
            const test::TracedScene traced(wallOf(test::matte(albedo), 0.03F));
            RenderControl control{.threads = 1};
            const Camera camera = ahead();
            const View view{traced.scene, traced.tracer, camera, settings};
            const std::optional<float> white = LightMeter().white(view, control);
            Frame frame;
            ASSERT_TRUE(test::renderFrame(view, control, frame));
            PictureDeveloper developer;
            LdrImage image;
            developer.develop(frame, settings, developer.exposure(frame, settings, white, 1), 1, image);
            const int shown = image.at(32, 20).g;
            EXPECT_GT(shown, before == 0 ? 4 : before + 30);
            before = shown;
        }
        EXPECT_NEAR(before, 236, 1);
    }
}

TEST(LightMeter, ATenthOfWhatIsSeenMayHaveMoreLight) {
    // A patch of the wall in a second light, above or below a tenth of the image.
    for (const float side : {0.5F, 1.2F}) {
        Scene scene = wallOf(test::matte(0.5F), 1);
        Light spot = test::pointLight({0, 0, 0}, 16 * 20);
        spot.kind = LightKind::Spot;
        spot.direction = {0, 0, -1};
        spot.cosInner = spot.cosOuter = 4 / std::hypot(4.0F, side);
        scene.lights.push_back(spot);
        const float white = whiteOf(scene).value_or(0) * kPi;
        if (side < 1) {
            EXPECT_NEAR(white, 1, 0.1F);
        } else {
            EXPECT_GT(white, 15);
        }
    }
}

/// In a scene whose light is sampled, and varies over the image.
TEST(LightMeter, RoughlyItMeasuresTheSame) {
    test::SceneBuilder b;
    b.square({0, -1, -4}, {0, 1, 0}, 6, b.material(test::matte(0.5F)));
    b.square({0, 0, -9}, {0, 0, 1}, 6, b.material(test::matte(0.8F)));
    b.box({-1, -1, -5}, {0.5F, 0.3F, -4}, b.material(test::matte(0.2F)));
    Light light = test::pointLight({2, 3, -3}, 20);
    light.kind = LightKind::Sphere;
    light.radius = 0.8F;
    b.scene.lights = {light};
    b.scene.background = kWhite * 0.4F;
    const test::TracedScene traced(b.finish());
    RenderSettings settings = test::sampleSettings(320, 200);
    settings.skyLight.on = settings.ambientOcclusion.on = true;
    const Camera camera = ahead();
    RenderControl control{.threads = 2};
    const View view{traced.scene, traced.tracer, camera, settings};
    const std::optional<float> exact = LightMeter().white(view, control),
                               rough = LightMeter().roughWhite(view, control);
    ASSERT_TRUE(exact && rough);
    EXPECT_NEAR(*rough / *exact, 1, 0.08F);
    EXPECT_NE(*rough, *exact) << "it took fewer samples";
}

/// In a closed room, where most light comes by way of its walls.
TEST(LightMeter, TakesIndirectLightThatIsKnown) {
    test::SceneBuilder b;
    b.box({-2, -2, -8}, {2, 2, 2}, b.material(test::matte(0.7F)));
    b.scene.lights = {test::pointLight({0.3F, 1, -3}, 5)};
    const test::TracedScene traced(b.finish());
    RenderSettings settings = test::sampleSettings(48, 30);
    const Camera camera = ahead();
    RenderControl control{.threads = 2};
    LightMeter meter;
    const auto white = [&] { return meter.white({traced.scene, traced.tracer, camera, settings}, control); };
    const std::optional<float> direct = white();
    settings.indirect.mode = IndirectMode::Live;
    const std::optional<float> own = white();
    ViewLight light;
    ASSERT_TRUE(light.learn({traced.scene, traced.tracer, camera, settings}, control));
    meter.lightIndirectlyFrom(&light.light());
    const std::optional<float> known = white();
    ASSERT_TRUE(direct && own && known);
    EXPECT_GT(*own, 1.2F * *direct);
    EXPECT_NEAR(*known / *own, 1, 0.05F);
    meter.lightIndirectlyFrom(nullptr);
    EXPECT_EQ(white(), own);
}

TEST(LightMeter, LeavesOutSkyLightsAndMirrors) {
    test::SceneBuilder b;
    Material shining = test::matte(0.5F);
    shining.emission = {90, 90, 90};
    b.square({0, 1, -4}, {0, 0, 1}, 0.5F, b.material(shining));
    b.square({0, -1, -4}, {0, 0, 1}, 0.5F, b.material(test::matte(0.4F)));
    b.square({-1.2F, 0, -4}, {0, 0, 1}, 0.5F, b.material(test::mirror(0.9F)));
    b.scene.background = {40, 40, 40};
    Light sun;
    sun.kind = LightKind::Directional;
    sun.direction = {0, 0, -1};
    sun.intensity = {2, 2, 2};
    b.scene.lights = {sun};
    EXPECT_NEAR(whiteOf(b.finish()).value_or(0), 2 / kPi, 0.01F);
}

// As in games that were made without lights: what shines is all that there is.
TEST(LightMeter, CountsWhatShinesAndScattersWhereThatIsAll) {
    Material shining = test::matte(0.4F);
    shining.emission = {0.3F, 0.3F, 0.3F};
    EXPECT_NEAR(whiteOf(wallOf(shining, 2)).value_or(0), 2 / kPi + 0.3F / 0.4F, 0.01F);
    shining.diffuse = {0.05F, 0.05F, 0.05F};
    EXPECT_FALSE(whiteOf(wallOf(shining, 2))) << "a light";
}

TEST(LightMeter, SaysNothingWhereThereIsNothingToMeasure) {
    EXPECT_FALSE(whiteOf(wallOf(test::mirror(0.9F), 3)));
    EXPECT_FALSE(whiteOf(wallOf(test::matte(0.5F), 0)));
    EXPECT_FALSE(whiteOf(wallOf(test::matte(0.0F), 3)));
}

TEST(LightMeter, GivesTheSameBitsForAnySizeAndAnyThreads) {
    const Scene scene = test::softlyLitScene();
    for (const Integrator integrator : {Integrator::Whitted, Integrator::Path}) {
        RenderSettings settings = test::sampleSettings(320, 200);
        settings.integrator = integrator;
        const std::optional<float> white = whiteOf(scene, settings);
        ASSERT_TRUE(white);
        EXPECT_EQ(whiteOf(scene, settings, 3), white);
        settings.width = 640;
        settings.height = 400;
        settings.antialiasing = 4;
        settings.path.samples = 3;
        settings.depthOfField.on = true;
        EXPECT_EQ(whiteOf(scene, settings), white);
    }
}

} // namespace
} // namespace rtcore
