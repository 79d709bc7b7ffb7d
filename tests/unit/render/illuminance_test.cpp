// Images of illuminance: closed forms, and that only the light that arrives counts, not what it arrives at.
#include "sample_view.h"

#include "rtcore/post/develop.h"
#include "rtcore/render/light_probe.h"
#include "rtcore/render/path_renderer.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <memory>
#include <utility>
#include <vector>

namespace rtcore {
namespace illuminance {
namespace {

constexpr int kSide = 17;

RenderSettings luxSettings(Integrator integrator) {
    RenderSettings settings = test::exactSettings();
    settings.width = settings.height = kSide;
    settings.integrator = integrator;
    settings.path.samples = 64;
    settings.path.clampIndirect = 0;
    settings.falseColours.on = true;
    settings.falseColours.quantity = LightQuantity::Illuminance;
    return settings;
}

/// Two units above the origin, looking down.
Camera fromAbove() {
    Camera camera;
    camera.eye = {0, 2, 0};
    camera.forward = {0, -1, 0};
    camera.up = {0, 0, -1};
    camera.horizontalFov = 4;
    return camera;
}

Frame rendered(Scene scene, const RenderSettings& settings, const Camera& camera = fromAbove(),
               int threads = 1) {
    const test::TracedScene traced(std::move(scene));
    const View view{traced.scene, traced.tracer, camera, settings};
    RenderControl control{.threads = threads};
    Frame frame;
    if (settings.integrator == Integrator::Path) {
        EXPECT_TRUE(PathRenderer().render(view, control, frame));
    } else {
        EXPECT_TRUE(FrameRenderer().render(view, control, frame));
    }
    return frame;
}

double inTheMiddle(const Frame& frame) {
    return test::kPi * static_cast<double>(luminance(frame.radiance.at(kSide / 2, kSide / 2)));
}

Scene groundOf(const Material& material, const std::function<void(test::SceneBuilder&)>& furnish = {}) {
    test::SceneBuilder b;
    b.square({0, 0, 0}, {0, 1, 0}, 50, b.material(material));
    if (furnish) furnish(b);
    return b.finish();
}

std::shared_ptr<const Environment> skyOf(float radiance) {
    return std::make_shared<const Environment>(
        Environment::fromEquirectangular(HdrImage(8, 4, {radiance, radiance, radiance}), "even"));
}

class Illuminance : public testing::TestWithParam<Integrator> {};

TEST_P(Illuminance, OfAPointLightIsItsIntensityOverTheSquareTimesTheCosine) {
    const RenderSettings settings = luxSettings(GetParam());
    for (const float albedo : {0.0F, 0.1F, 0.9F}) {
        Scene scene = groundOf(test::matte(albedo));
        scene.lights = {test::pointLight({1, 2, 0}, 30)};
        EXPECT_NEAR(inTheMiddle(rendered(std::move(scene), settings)), 30 * 2 / std::pow(5, 1.5), 1e-2)
            << albedo;
    }
}

TEST_P(Illuminance, IsThatOfTheLightWhateverItMeets) {
    Material shiny = test::matte(0.3F);
    shiny.specular = {0.5F, 0.5F, 0.5F};
    shiny.shininess = 60;
    Material metal = test::matte(0.9F);
    metal.roughness = 0.3F;
    metal.metallic = 1;
    metal.coat = 0.5F;
    Material tinted = test::glass();
    tinted.transmission = {1, 0.2F, 0.1F};
    const auto seen = [&](const Material& material) {
        Scene scene = groundOf(material);
        scene.lights = {test::pointLight({1, 2, 0}, 30), test::pointLight({-0.5F, 3, 1}, 4)};
        return rendered(std::move(scene), luxSettings(GetParam()));
    };
    const Frame expected = seen(test::matte(0.1F));
    EXPECT_GT(inTheMiddle(expected), 5);
    for (const Material& material : {test::matte(0.9F), shiny, metal, test::mirror(0.8F), tinted}) {
        const Frame frame = seen(material);
        for (std::size_t i = 0; i < frame.radiance.pixels.size(); ++i) {
            ASSERT_NEAR(frame.radiance.pixels[i].r, expected.radiance.pixels[i].r, 1e-5F);
            ASSERT_EQ(frame.covered[i], 255);
        }
    }
}

TEST_P(Illuminance, LeavesOutTheLightOfTheSurfaceItself) {
    Scene scene = groundOf(test::emitter({7, 7, 7}));
    scene.lights = {test::pointLight({0, 1, 1}, 1)};
    EXPECT_NEAR(inTheMiddle(rendered(std::move(scene), luxSettings(GetParam()))), 1 / std::pow(2, 1.5), 1e-3);
}

TEST_P(Illuminance, OfARectangleLightIsItsFormFactor) {
    Light light;
    light.kind = LightKind::Rectangle;
    light.position = {0, 1, 0};
    light.direction = {0, -1, 0};
    light.right = {1, 0, 0};
    light.width = 1.4F;
    light.height = 0.8F;
    light.intensity = kWhite * (4 * light.width * light.height);
    Scene scene = groundOf(test::matte(0.1F));
    scene.lights = {light};
    RenderSettings settings = luxSettings(GetParam());
    settings.areaLights.samples = 64;
    settings.path.samples = 1024;
    // An element below the middle of 2a x 2b, one unit above it.
    const double a = 0.7, b = 0.4, p = std::sqrt(1 + a * a), q = std::sqrt(1 + b * b);
    const double expected = 4 * 2 * (a / p * std::atan(b / p) + b / q * std::atan(a / q));
    EXPECT_NEAR(inTheMiddle(rendered(std::move(scene), settings)), expected, 0.01 * expected);
}

TEST_P(Illuminance, UnderAnOpenSkyIsPiTimesItsRadiance) {
    RenderSettings settings = luxSettings(GetParam());
    settings.skyLight.on = true;
    settings.path.samples = 1024;
    for (const float albedo : {0.1F, 0.9F}) {
        Scene scene = groundOf(test::matte(albedo));
        scene.environments = {skyOf(2)};
        EXPECT_NEAR(inTheMiddle(rendered(std::move(scene), settings)), 2 * test::kPi, 0.02) << albedo;
    }
}

TEST_P(Illuminance, OfAmbientLightIsPiTimesItsRadiance) {
    for (const Material& material : {test::matte(0.1F), test::mirror(0.9F)}) {
        Scene scene = groundOf(material);
        scene.ambient = {0.5F, 0.5F, 0.5F};
        EXPECT_NEAR(inTheMiddle(rendered(std::move(scene), luxSettings(GetParam()))), 0.5 * test::kPi, 1e-2);
    }
}

TEST_P(Illuminance, IsBlackBesideAllSurfaces) {
    Camera away = fromAbove();
    away.forward = {0, 1, 0};
    for (const bool sky : {false, true}) {
        Scene scene = groundOf(test::matte(0.5F));
        scene.background = {3, 3, 3};
        if (sky) scene.environments = {skyOf(2)};
        const Frame frame = rendered(std::move(scene), luxSettings(GetParam()), away);
        for (std::size_t i = 0; i < frame.radiance.pixels.size(); ++i) {
            ASSERT_TRUE(isBlack(frame.radiance.pixels[i])) << sky;
            ASSERT_EQ(frame.covered[i], 0);
        }
    }
}

TEST_P(Illuminance, IsThatOfTheSurfaceNotOfTheFogBeforeIt) {
    const auto inFog = [&](float height) {
        Scene scene = groundOf(test::matte(0.5F));
        scene.lights = {test::pointLight({0, 1, 0}, 10)};
        scene.fog.kind = FogKind::Homogeneous;
        scene.fog.density = 0.5F;
        scene.fog.colour = {0.4F, 0.4F, 0.4F};
        scene.fog.emission = {0.4F, 0.4F, 0.4F};
        Camera camera = fromAbove();
        camera.eye.y = height;
        camera.horizontalFov = 0.1F;
        RenderSettings settings = luxSettings(GetParam());
        settings.path.bounces = 1;
        return inTheMiddle(rendered(std::move(scene), settings, camera));
    };
    EXPECT_GT(inFog(2), 10 * std::exp(-0.5) * 0.99);
    EXPECT_NEAR(inFog(2), inFog(9), 0.02 * inFog(2));
}

TEST_P(Illuminance, HasTheSameBitsForAnyNumberOfThreads) {
    RenderSettings settings = luxSettings(GetParam());
    settings.width = 70;
    settings.height = 41;
    settings.path.samples = 4;
    const Frame one = rendered(test::softlyLitScene(), settings, test::sampleCamera());
    for (const int threads : {2, 7}) {
        const Frame other = rendered(test::softlyLitScene(), settings, test::sampleCamera(), threads);
        EXPECT_EQ(one.radiance.pixels, other.radiance.pixels) << threads;
        EXPECT_EQ(one.covered, other.covered) << threads;
    }
    settings.falseColours.on = false;
    EXPECT_NE(rendered(test::softlyLitScene(), settings, test::sampleCamera()).radiance.pixels,
              one.radiance.pixels);
}

INSTANTIATE_TEST_SUITE_P(Of, Illuminance, testing::Values(Integrator::Whitted, Integrator::Path),
                         [](const auto& of) { return of.param == Integrator::Path ? "Paths" : "Whitted"; });

// A wall of albedo 1/2 lights the ground, and the ground the wall: what is seen is white, what lights is not.
TEST(IlluminanceByPaths, CountsTheLightOfOtherSurfacesAsTheyAre) {
    const auto below = [](float albedo) {
        test::SceneBuilder b;
        b.square({0, 0, 0}, {0, 1, 0}, 3, b.material(test::matte(0.5F)));
        b.square({0, 4, 0}, {0, -1, 0}, 3, b.material(test::matte(albedo)));
        b.scene.lights = {test::pointLight({0, 3, 0}, 10)};
        return inTheMiddle(rendered(b.finish(), luxSettings(Integrator::Path)));
    };
    const double direct = 10.0 / 9;
    EXPECT_NEAR(below(0), direct, 1e-3);
    EXPECT_GT(below(0.8F), 1.2 * below(0.0F));
    EXPECT_GT(below(0.8F), below(0.4F));
}

// Both see a box of colours, gloss and glass around the point.
TEST(IlluminanceByPaths, IsWhatTheLightProbeMeasuresThere) {
    const auto room = [] {
        test::SceneBuilder b;
        Material shiny = test::matte(0.4F);
        shiny.specular = {0.4F, 0.4F, 0.4F};
        shiny.shininess = 30;
        b.box({-2, 0, -2}, {2, 3, 2}, b.material(shiny));
        b.box({0.4F, 0, -0.5F}, {0.8F, 0.6F, 0.5F}, b.material(test::matte(0.8F)));
        b.scene.lights = {test::pointLight({-1, 2.5F, 0.5F}, 10)};
        return b.finish();
    };
    RenderSettings settings = luxSettings(Integrator::Path);
    settings.path.bounces = 64;
    settings.path.samples = 256;
    Camera camera = fromAbove();
    camera.horizontalFov = 0.2F;
    const Frame frame = rendered(room(), settings, camera);
    double mean = 0;
    for (const Colour& pixel : frame.radiance.pixels)
        mean += test::kPi * static_cast<double>(luminance(pixel)) / (kSide * kSide);

    const test::TracedScene traced(room());
    const ProbedLight whole{&traced.scene};
    LightProbe probe;
    probe.begin({&whole, 1}, traced.tracer, settings);
    const auto point = sideSeen(traced.scene, traced.tracer,
                                {camera.eye, 0, camera.forward, std::numeric_limits<float>::max()});
    ASSERT_TRUE(point);
    RenderControl control{.threads = 1};
    std::vector<MeasuredLight> measured;
    ASSERT_TRUE(probe.irradiance({&*point, 1}, {.relativeError = 2e-3}, control, measured));
    EXPECT_NEAR(mean, measured[0].luminance, 0.01 * mean);
}

TEST(IlluminanceByPaths, TheEffectsSpreadNoLightBesideSurfaces) {
    RenderSettings settings = luxSettings(Integrator::Whitted);
    PictureDeveloper developer;
    Frame frame;
    frame.radiance = HdrImage(3, 1, {2, 2, 2});
    frame.covered = {0, 255, 51};
    const HdrImage& finished = developer.finish(frame, settings, 1);
    EXPECT_LT(luminance(finished.pixels[0]), 0) << "there is no value";
    EXPECT_FLOAT_EQ(finished.pixels[1].g, 2);
    EXPECT_FLOAT_EQ(finished.pixels[2].g, 10) << "a fifth of the pixel is surface";
    settings.falseColours.quantity = LightQuantity::Luminance;
    EXPECT_EQ(&developer.finish(frame, settings, 1), &frame.radiance);
}

} // namespace
} // namespace illuminance
} // namespace rtcore
