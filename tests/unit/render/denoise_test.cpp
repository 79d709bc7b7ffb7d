// Noise goes, everything else stays.
#include "rtcore/post/denoise.h"
#include "rtcore/post/develop.h"
#include "rtcore/post/effects.h"

#include "sample_view.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

namespace rtcore {
namespace {

Frame rendered(const test::TracedScene& traced, const RenderSettings& settings, int threads = 1) {
    Frame frame;
    FrameRenderer renderer;
    renderer.collectAovs(effectsNeedAovs(settings));
    RenderControl control{.threads = threads};
    EXPECT_TRUE(
        renderer.render({traced.scene, traced.tracer, test::sampleCamera(), settings}, control, frame));
    return frame;
}

HdrImage denoised(const Frame& frame, const RenderSettings& settings) {
    return Denoiser().apply(frame.radiance, frame.aovs, {.settings = settings, .threads = 1});
}

double rmse(const HdrImage& a, const HdrImage& b) {
    double sum = 0;
    for (std::size_t i = 0; i < a.pixels.size(); ++i) {
        const Colour d = a.pixels[i] - b.pixels[i];
        sum += static_cast<double>(d.r * d.r + d.g * d.g + d.b * d.b);
    }
    return std::sqrt(sum / static_cast<double>(3 * a.pixels.size()));
}

/// A box and a ball on a chequered floor, under an area light.
Scene corners() {
    test::SceneBuilder b;
    Material floor = test::matte(0.8F);
    floor.diffuseTexture =
        b.texture(2, 2, {{255, 200, 90, 255}, {30, 60, 90, 255}, {60, 200, 90, 255}, {220, 220, 210, 255}});
    b.square({0, -1, 0}, {0, 1, 0}, 8, b.material(floor));
    b.square({0, 0, -3}, {0, 0, 1}, 8, b.material(test::matte(0.6F)));
    b.sphere({-1.2F, 0, 0}, 1, 24, b.material(test::matte(0.7F)));
    b.box({0.4F, -1, -1}, {1.8F, 0.8F, 0.4F}, b.material(test::matte(0.5F)));
    Light light = test::pointLight({1, 4, 3}, 40);
    light.kind = LightKind::Sphere;
    light.radius = 1;
    b.scene.lights = {light};
    b.scene.background = {0.2F, 0.3F, 0.5F};
    return b.finish();
}

RenderSettings occluded(int samples, int denoise) {
    RenderSettings settings = test::sampleSettings(160, 120);
    settings.areaLights.samples = 0;
    settings.ambientOcclusion.on = true;
    settings.ambientOcclusion.samples = samples;
    settings.denoise.passes = denoise;
    return settings;
}

TEST(Denoise, CanBeLeft) {
    const test::TracedScene traced(corners());
    const RenderSettings settings = occluded(4, 3);
    const Frame frame = rendered(traced, settings);
    Denoiser denoiser;
    const std::atomic<bool> stop{true}, goOn{false};
    EXPECT_EQ(
        &denoiser.apply(frame.radiance, frame.aovs, {.settings = settings, .threads = 2, .stop = &stop}),
        &frame.radiance);
    EXPECT_EQ(denoiser.apply(frame.radiance, frame.aovs, {.settings = settings, .threads = 2, .stop = &goOn})
                  .pixels,
              denoised(frame, settings).pixels);
}

TEST(Denoise, TakesLoneBrightPixelsOutOfImagesByPaths) {
    const test::TracedScene traced(corners());
    RenderSettings settings = occluded(4, 3);
    Frame frame = rendered(traced, settings);
    settings.integrator = Integrator::Path;
    const auto sum = [&] {
        Colour all;
        for (const Colour& pixel : denoised(frame, settings).pixels) all = all + pixel;
        return luminance(all);
    };
    const float before = sum();
    constexpr float kSpike = 1000;
    const std::size_t lone = 100 * 160 + 40, pair = 110 * 160 + 80; // of the floor
    for (const std::size_t pixel : {lone, pair, pair + 1}) frame.radiance.pixels[pixel] = kWhite * kSpike;
    EXPECT_LT(sum() - before, 0.01F * kSpike);
    // A light that is seen stays.
    for (std::size_t y = 100; y < 104; ++y)
        for (std::size_t x = 120; x < 124; ++x) frame.radiance.pixels[y * 160 + x] = kWhite * kSpike;
    EXPECT_GT(sum() - before, 10 * kSpike);
}

/// A surface covers more and more of each pixel to the right, over a background that is brighter.
TEST(Denoise, KeepsWhatIsSeenBesideASurfaceThatCoversLittle) {
    constexpr int kWidth = 64, kHeight = 16;
    const Camera camera = test::sampleCamera();
    Aovs aovs;
    aovs.begin(camera, kWidth, kHeight);
    HdrImage picture(kWidth, kHeight);
    for (int y = 0; y < kHeight; ++y) {
        for (int x = 0; x < kWidth; ++x) {
            std::vector<PrimaryHit> hits(kWidth);
            for (int i = 0; i < x; ++i) {
                PrimaryHit& hit = hits[static_cast<std::size_t>(i)];
                hit.position = camera.eye + camera.forward;
                hit.normal = {0, 1, 0};
                hit.albedo = kWhite * 0.8F;
                hit.wave = 1;
            }
            const std::vector<SampleId> ids(
                kWidth, SampleId{static_cast<std::uint16_t>(x), static_cast<std::uint16_t>(y), 0});
            aovs.add(hits, ids);
            const float part = static_cast<float>(x) / kWidth;
            picture.at(x, y) = kWhite * (1 - part + 0.7F * part);
        }
    }
    aovs.finish(1);
    RenderSettings settings;
    settings.integrator = Integrator::Path;
    settings.path.filter = 4;
    const HdrImage result = Denoiser().apply(picture, aovs, {.settings = settings, .threads = 1});
    for (int x = 0; x < kWidth; ++x) EXPECT_NEAR(result.at(x, 8).g, picture.at(x, 8).g, 0.05F) << x;
}

TEST(Denoise, HalvesTheNoiseOfAmbientOcclusion) {
    const test::TracedScene traced(corners());
    const HdrImage reference = rendered(traced, occluded(400, 0), 2).radiance;
    for (const int samples : {4, 9}) {
        const RenderSettings settings = occluded(samples, 3);
        const Frame frame = rendered(traced, settings);
        const double before = rmse(frame.radiance, reference);
        const double after = rmse(denoised(frame, settings), reference);
        EXPECT_LT(after, 0.6 * before) << samples;
    }
}

TEST(Denoise, HalvesTheNoiseOfSoftShadows) {
    const test::TracedScene traced(corners());
    RenderSettings settings = test::sampleSettings(160, 120);
    settings.areaLights.samples = 256;
    const HdrImage reference = rendered(traced, settings, 2).radiance;
    settings.areaLights.samples = 4;
    settings.denoise.passes = 3;
    const Frame frame = rendered(traced, settings);
    const double before = rmse(frame.radiance, reference);
    EXPECT_LT(rmse(denoised(frame, settings), reference), 0.7 * before);
}

TEST(Denoise, TheFilterOfPathsIsThatOfPathsAlone) {
    RenderSettings settings;
    settings.denoise.passes = 2;
    settings.path.filter = 5;
    EXPECT_EQ(filterPasses(settings), 2);
    settings.integrator = Integrator::Path;
    EXPECT_EQ(filterPasses(settings), 5);
    settings.path.filter = 0;
    EXPECT_EQ(filterPasses(settings), 2) << "as in files from before there was one";
}

TEST(Denoise, LeavesAPictureAloneThatSamplesNothing) {
    const test::TracedScene traced(test::sampleScene());
    RenderSettings settings = test::sampleSettings(160, 120);
    settings.denoise.passes = 4;
    const Frame frame = rendered(traced, settings);
    EXPECT_EQ(&Denoiser().apply(frame.radiance, frame.aovs, {settings}), &frame.radiance);
    settings.denoise.passes = 0;
    EXPECT_EQ(&Denoiser().apply(frame.radiance, frame.aovs, {settings}), &frame.radiance);
}

// Through a lens all light is filtered; with an aperture of next to nothing there is no noise, but textures,
// hard shadows, mirrors and glass.
TEST(Denoise, DoesLittleHarmWithoutNoise) {
    const test::TracedScene traced(test::sampleScene());
    RenderSettings settings = test::sampleSettings(320, 240);
    settings.depthOfField.on = true;
    settings.depthOfField.fNumber = 1000;
    settings.denoise.passes = 3;
    const Frame frame = rendered(traced, settings);
    double mean = 0;
    for (const Colour c : frame.radiance.pixels) mean += static_cast<double>(luminance(c));
    mean /= static_cast<double>(frame.radiance.pixels.size());
    EXPECT_LT(rmse(denoised(frame, settings), frame.radiance), 0.05 * mean);
}

TEST(Denoise, THOROUGH_HardlyTouchesSoftLightThatHasNoNoise) {
    const test::TracedScene traced(test::softlyLitScene());
    RenderSettings settings = test::sampleSettings(160, 120);
    settings.areaLights.samples = 256;
    settings.denoise.passes = 3;
    const Frame frame = rendered(traced, settings);
    double mean = 0;
    for (const Colour c : frame.radiance.pixels) mean += static_cast<double>(luminance(c));
    mean /= static_cast<double>(frame.radiance.pixels.size());
    EXPECT_LT(rmse(denoised(frame, settings), frame.radiance), 0.02 * mean);
}

// Every effect on.
TEST(Denoise, WithAllEffectsHasTheSameBitsForAnyThreads) {
    const test::TracedScene traced(test::softlyLitScene());
    for (const BloomKernel kernel : {BloomKernel::Gaussian, BloomKernel::Airy}) {
        RenderSettings settings = occluded(5, 2);
        settings.antialiasing = 2;
        settings.sampling = SamplingPattern::Rotated;
        settings.adaptive = 0.05F;
        settings.areaLights.samples = 3;
        settings.depthOfField.on = true;
        settings.bloom.radius = 4;
        settings.bloom.kernel = kernel;
        settings.exposure.local = 0.5F;
        const auto picture = [&](int threads, HdrImage& seen) {
            const Frame frame = rendered(traced, settings, threads);
            PictureDeveloper developer;
            const float exposure = developer.exposure(frame, settings.exposure, threads);
            seen = developer.finish(frame, settings, threads);
            LdrImage image;
            developer.develop(frame, settings, exposure, threads, image);
            return image;
        };
        HdrImage seenByOne, seenByTwo;
        const LdrImage one = picture(1, seenByOne), two = picture(2, seenByTwo);
        EXPECT_EQ(one.pixels, two.pixels);
        EXPECT_EQ(std::memcmp(seenByOne.pixels.data(), seenByTwo.pixels.data(),
                              seenByOne.pixels.size() * sizeof(Colour)),
                  0);
    }
}

} // namespace
} // namespace rtcore
