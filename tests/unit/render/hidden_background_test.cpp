// Images without their background: with any background behind them they are those that had it from the start.
#include "sample_view.h"

#include "rtcore/post/develop.h"
#include "rtcore/render/image_renderer.h"
#include "rtcore/simd/instruction_set.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

namespace rtcore {
namespace hidden_background {
namespace {

constexpr int kSide = 48;

RenderSettings settingsOf(Integrator integrator) {
    RenderSettings settings;
    settings.width = settings.height = kSide;
    settings.integrator = integrator;
    settings.antialiasing = 4;
    settings.path.samples = 16;
    settings.denoise.passes = 0;
    return settings;
}

/// From 3 units above the squares that are about the origin.
Camera fromAbove() {
    Camera camera;
    camera.eye = {0, 3, 0};
    camera.forward = {0, -1, 0};
    camera.up = {0, 0, -1};
    camera.horizontalFov = 60;
    return camera;
}

Material pane(float transmission) {
    Material material = test::matte(0);
    material.opacity = 0;
    material.indexOfRefraction = 1;
    material.transmission = {transmission, transmission, transmission};
    return material;
}

/// A turned matte square, before a background of that colour.
Scene squareBefore(Colour background) {
    test::SceneBuilder b;
    b.square({0, 0, 0}, normalize(Vec3{0.3F, 1, 0.2F}), 1.1F, b.material(test::matte(0.6F)));
    Scene scene = b.finish();
    scene.lights = {test::pointLight({1, 4, 1}, 20)};
    scene.background = background;
    return scene;
}

Frame rendered(Scene scene, const RenderSettings& settings, Background background, int threads = 2) {
    const test::TracedScene traced(std::move(scene));
    const Camera camera = fromAbove();
    RenderControl control{.threads = threads};
    Frame frame;
    ImageRequest request{.aovs = true, .guides = false};
    request.background = background;
    EXPECT_TRUE(makeImageRenderer(settings.integrator)
                    ->render({traced.scene, traced.tracer, camera, settings}, control, request, frame));
    return frame;
}

HdrImage finished(const Frame& frame, const RenderSettings& settings) {
    PictureDeveloper developer;
    return developer.finish(frame, settings, 2);
}

double largestDifference(const HdrImage& a, const HdrImage& b) {
    double largest = 0;
    for (std::size_t i = 0; i < a.pixels.size(); ++i) {
        const Colour d = a.pixels[i] - b.pixels[i];
        largest = std::max({largest, double{std::abs(d.r)}, double{std::abs(d.g)}, double{std::abs(d.b)}});
    }
    return largest;
}

HdrImage behind(const HdrImage& image, const HdrImage& transmitted, Colour background) {
    HdrImage composed = image;
    for (std::size_t i = 0; i < composed.pixels.size(); ++i)
        composed.pixels[i] += transmitted.pixels[i] * background;
    return composed;
}

class HiddenBackground : public testing::TestWithParam<Integrator> {};

TEST_P(HiddenBackground, WithAnyBehindItIsTheImageThatHadItFromTheStart) {
    for (const int passes : {0, 3}) {
        RenderSettings settings = settingsOf(GetParam());
        settings.denoise.passes = passes;
        settings.path.filter = passes;
        for (const Colour background : {Colour{1, 0, 0}, Colour{0.1F, 0.5F, 2}}) {
            // Paths are lit by the background, too: what is put behind is the one that it was lit by.
            const bool lit = GetParam() == Integrator::Path;
            const Frame hidden = rendered(squareBefore(lit ? background : Colour{0.2F, 0.2F, 0.9F}), settings,
                                          Background::Hidden);
            ASSERT_TRUE(hidden.hidesBackground());
            const HdrImage without = finished(hidden, settings);
            const bool apart = passes > 0 && GetParam() == Integrator::Path;
            const Frame shown =
                rendered(squareBefore(background), settings, apart ? Background::Apart : Background::Shown);
            EXPECT_LT(
                largestDifference(behind(without, hidden.transmitted, background), finished(shown, settings)),
                1e-5)
                << passes;
        }
    }
}

TEST_P(HiddenBackground, IsSeenWhereNothingIsAndNotWhereSomethingIs) {
    const Frame frame = rendered(squareBefore({1, 1, 1}), settingsOf(GetParam()), Background::Hidden);
    int parts = 0;
    for (std::size_t i = 0; i < frame.covered.size(); ++i) {
        const float seen = frame.transmitted.pixels[i].r;
        if (frame.covered[i] == 0 || frame.covered[i] == 255) {
            EXPECT_EQ(seen, frame.covered[i] == 0 ? 1 : 0);
        }
        EXPECT_NEAR(seen, 1 - static_cast<float>(frame.covered[i]) / 255, 0.01);
        parts += seen > 0 && seen < 1 ? 1 : 0;
    }
    EXPECT_GT(parts, kSide);
    EXPECT_EQ(frame.radiance.at(0, 0), Colour{});
}

TEST_P(HiddenBackground, IsSeenThroughPanesAsFarAsTheyLetItPass) {
    RenderSettings settings = settingsOf(GetParam());
    settings.path.samples = 512;
    test::SceneBuilder b;
    b.square({0, 0, 0}, {0, 1, 0}, 5, b.material(pane(0.5F)));
    b.square({0, -1, 0}, {0, 1, 0}, 5, b.material(pane(0.8F)));
    Scene scene = b.finish();
    scene.background = {1, 1, 1};
    const Frame frame = rendered(std::move(scene), settings, Background::Hidden);
    EXPECT_NEAR(frame.transmitted.at(kSide / 2, kSide / 2).g, 0.4F, 0.01F);
    EXPECT_NEAR(frame.radiance.at(kSide / 2, kSide / 2).g, 0, 1e-6F);
}

TEST_P(HiddenBackground, StaysInMirrors) {
    test::SceneBuilder b;
    b.square({0, 0, 0}, {0, 1, 0}, 5, b.material(test::mirror(0.5F)));
    Scene scene = b.finish();
    scene.background = {0.25F, 0.5F, 1};
    const Frame frame = rendered(std::move(scene), settingsOf(GetParam()), Background::Hidden);
    EXPECT_NEAR(frame.radiance.at(kSide / 2, kSide / 2).b, 0.5F, 0.01F);
    EXPECT_EQ(frame.transmitted.at(kSide / 2, kSide / 2), Colour{});
}

TEST_P(HiddenBackground, TheSameBitsForAnyNumberOfThreads) {
    const RenderSettings settings = settingsOf(GetParam());
    const Frame one = rendered(squareBefore({1, 1, 1}), settings, Background::Hidden, 1);
    for (const int threads : {2, 7}) {
        const Frame other = rendered(squareBefore({1, 1, 1}), settings, Background::Hidden, threads);
        EXPECT_EQ(one.radiance.pixels, other.radiance.pixels) << threads;
        EXPECT_EQ(one.transmitted.pixels, other.transmitted.pixels) << threads;
    }
}

INSTANTIATE_TEST_SUITE_P(Both, HiddenBackground, testing::Values(Integrator::Whitted, Integrator::Path));

} // namespace
} // namespace hidden_background
} // namespace rtcore
