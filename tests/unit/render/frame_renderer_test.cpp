#include "rtcore/render/frame_renderer.h"

#include "sample_view.h"
#include "support/one_frame.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <cstdint>
#include <thread>
#include <vector>

namespace rtcore {
namespace {

using test::sampleSettings;
using test::TracedScene;

std::size_t at(int x, int y, int width) {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
}

TEST(RenderFrame, TheSameBitsForAnyNumberOfThreads) {
    const TracedScene s(test::sampleScene());
    for (const int antialiasing : {1, 3}) {
        const RenderSettings settings = sampleSettings(101, 67, antialiasing);
        const Frame one = test::render(s, settings, 1);
        for (const int threads : {0, 2, 7}) {
            const Frame other = test::render(s, settings, threads);
            EXPECT_EQ(one.radiance.pixels, other.radiance.pixels) << threads;
            EXPECT_EQ(one.covered, other.covered);
            EXPECT_EQ(one.statistics.rays, other.statistics.rays);
        }
    }
}

TEST(RenderFrame, TheSameSoftShadowsForAnyNumberOfThreadsAndInEveryFrame) {
    const test::TracedScene s(test::softlyLitScene());
    const RenderSettings settings = test::sampleSettings(150, 90, 2);
    const Frame one = test::render(s, settings, 1);
    for (const int threads : {1, 2, 7})
        EXPECT_EQ(one.radiance.pixels, test::render(s, settings, threads).radiance.pixels) << threads;
}

TEST(RenderFrame, THOROUGH_TheSameFogForAnyNumberOfThreads) {
    for (const FogKind kind : {FogKind::Homogeneous, FogKind::Exponential}) {
        const test::TracedScene s(test::foggyScene(kind));
        RenderSettings settings = test::sampleSettings(150, 101, 2);
        for (const int shafts : {0, 5}) {
            settings.fog.shafts = shafts;
            EXPECT_EQ(test::render(s, settings, 1).radiance.pixels,
                      test::render(s, settings, 2).radiance.pixels);
        }
    }
}

TEST(RenderFrame, WithShadowMapsIsNearlyTheSameAndLeavesNoTrace) {
    const std::atomic<bool> cancel{false};
    for (const FogKind kind : {FogKind::None, FogKind::Homogeneous}) {
        const test::TracedScene s(test::foggyScene(kind));
        const auto maps = ShadowMaps::make(s.scene, s.tracer, cancel);
        RenderSettings settings = test::sampleSettings(160, 90);
        settings.fog.shafts = 2;
        const Frame exact = test::render(s, settings, 2);
        FrameRenderer renderer;
        RenderControl control{.threads = 2};
        Frame quick, after;
        renderer.takeShadowsFrom(maps.get());
        renderer.render({s.scene, s.tracer, test::sampleCamera(), settings}, control, quick);
        EXPECT_EQ(quick.statistics.rays[static_cast<std::size_t>(RayKind::Shadow)], 0U);
        double sum = 0, exactSum = 0, quickSum = 0;
        for (std::size_t i = 0; i < exact.radiance.pixels.size(); ++i) {
            const double a = luminance(exact.radiance.pixels[i]), b = luminance(quick.radiance.pixels[i]);
            sum += std::abs(a - b);
            exactSum += a;
            quickSum += b;
        }
        EXPECT_LT(sum, 0.02 * exactSum);
        EXPECT_NEAR(quickSum, exactSum, 0.01 * exactSum);
        EXPECT_GT(sum, 0) << "else no map was asked";
        renderer.takeShadowsFrom(nullptr);
        renderer.render({s.scene, s.tracer, test::sampleCamera(), settings}, control, after);
        EXPECT_EQ(after.radiance.pixels, exact.radiance.pixels);
    }
}

TEST(RenderFrame, TheSameBitsForAnyTree) {
    const TracedScene exact(test::sampleScene(), BuildMethod::Exact);
    const TracedScene fast(test::sampleScene(), BuildMethod::Fast);
    EXPECT_EQ(test::render(exact, sampleSettings(101, 67)).radiance.pixels,
              test::render(fast, sampleSettings(101, 67)).radiance.pixels);
}

TEST(RenderFrame, SurfacesInOnePlaceShowTheFirst) {
    test::SceneBuilder b;
    for (int i = 0; i < 20; ++i) {
        b.square({0.1F, 0.2F, -3}, {0, 0, 1}, 5,
                 b.material(test::emitter({static_cast<float>(i + 1), 0, 0})));
    }
    const Scene scene = b.finish();
    const TracedScene exact(scene, BuildMethod::Exact), fast(scene, BuildMethod::Fast);
    for (const Colour c : test::render(exact, sampleSettings(20, 20)).radiance.pixels) EXPECT_EQ(c.r, 1);
    for (const Colour c : test::render(fast, sampleSettings(20, 20)).radiance.pixels) EXPECT_EQ(c.r, 1);
}

TEST(RenderFrame, AntialiasingIsTheMeanOfThePictureThatIsSoMuchLarger) {
    const TracedScene s(test::sampleScene());
    constexpr int n = 4, w = 30, h = 20;
    const Frame fine = test::render(s, sampleSettings(w * n, h * n));
    const Frame averaged = test::render(s, sampleSettings(w, h, n));
    int different = 0;
    for (int y = 0; y < h; ++y) {
        for (int x = 0; x < w; ++x) {
            Colour sum;
            int covered = 0;
            for (int i = 0; i < n * n; ++i) {
                sum += fine.radiance.at(x * n + i % n, y * n + i / n);
                covered += fine.covered[at(x * n + i % n, y * n + i / n, w * n)] / 255;
            }
            const Colour mean = sum / (n * n), got = averaged.radiance.at(x, y);
            // The two round directions differently: a ray at an edge may meet the other side.
            if (std::fabs(mean.g - got.g) > 1e-3F * (1 + mean.g)) ++different;
            const int fraction = 255 * covered / (n * n);
            if (averaged.covered[at(x, y, w)] != fraction) ++different;
        }
    }
    EXPECT_LE(different, w * h / 100);
}

TEST(RenderFrame, OddSizes) {
    const TracedScene s(test::sampleScene());
    for (const auto& [w, h, n] :
         {std::tuple{1, 1, 1}, {33, 7, 1}, {1, 40, 2}, {5, 3, 16}, {1, 1, 16}, {97, 2, 5}}) {
        const Frame frame = test::render(s, sampleSettings(w, h, n), 2);
        ASSERT_EQ(frame.radiance.width, w);
        ASSERT_EQ(frame.radiance.height, h);
        ASSERT_EQ(frame.covered.size(), static_cast<std::size_t>(w * h));
        for (const Colour c : frame.radiance.pixels) {
            EXPECT_TRUE(isFinite(c));
            EXPECT_GT(luminance(c), 0); // each sample adds something, if only the background
        }
        EXPECT_EQ(frame.statistics.rays[0], static_cast<std::uint64_t>(w * h * n * n));
    }
}

TEST(RenderFrame, APictureIsIndependentOfItsPlaceInTiles) {
    // The middle pixels of two images of different size, through which the same rays go.
    const TracedScene s(test::sampleScene());
    Camera camera = test::sampleCamera();
    RenderControl control{.threads = 1};
    Frame small, large;
    camera.horizontalFov = 2 * std::atan(0.1F) * 180 / static_cast<float>(test::kPi);
    ASSERT_TRUE(test::renderFrame({s.scene, s.tracer, camera, sampleSettings(16, 16)}, control, small));
    camera.horizontalFov = 2 * std::atan(0.7F) * 180 / static_cast<float>(test::kPi);
    ASSERT_TRUE(test::renderFrame({s.scene, s.tracer, camera, sampleSettings(112, 112)}, control, large));
    int different = 0;
    for (int y = 0; y < 16; ++y) {
        for (int x = 0; x < 16; ++x) {
            const Colour a = small.radiance.at(x, y), b = large.radiance.at(x + 48, y + 48);
            if (std::fabs(a.g - b.g) > 1e-3F * (1 + a.g)) ++different;
        }
    }
    EXPECT_LE(different, 3);
}

TEST(RenderFrame, CoveredTellsGeometryFromBackground) {
    test::SceneBuilder b;
    b.quad({-100, -100, -1}, {0, -100, -1}, {0, 100, -1}, {-100, 100, -1},
           b.material(test::matte(1))); // the left half
    const TracedScene s(b.finish());
    Camera camera;
    RenderControl control{.threads = 1};
    Frame frame;
    ASSERT_TRUE(test::renderFrame({s.scene, s.tracer, camera, sampleSettings(9, 3, 2)}, control, frame));
    for (std::size_t y = 0; y < 3; ++y) {
        for (std::size_t x = 0; x < 9; ++x) {
            EXPECT_EQ(frame.covered[y * 9 + x], x < 4 ? 255 : x == 4 ? 127 : 0) << x;
        }
    }
}

TEST(RenderFrame, AnOrthographicViewShowsTheSameSizeNearAndFar) {
    test::SceneBuilder b;
    const std::uint32_t white = b.material(test::emitter({1, 1, 1}));
    b.square({-2, 0, -1}, {0, 0, 1}, 0.5F, white);
    b.square({2, 0, -100}, {0, 0, 1}, 0.5F, white);
    const test::TracedScene s(b.finish());
    Camera camera;
    camera.kind = CameraKind::Orthographic;
    camera.orthographicWidth = 8;
    RenderSettings settings = test::sampleSettings(160, 80);
    const auto render = [&] {
        Frame frame;
        RenderControl control{.threads = 2};
        EXPECT_TRUE(test::renderFrame({s.scene, s.tracer, camera, settings}, control, frame));
        return frame;
    };
    const Frame frame = render();
    for (int y = 0; y < 80; ++y) {
        for (int x = 0; x < 160; ++x) {
            const bool inside = y >= 30 && y < 50 && ((x >= 30 && x < 50) || (x >= 110 && x < 130));
            ASSERT_EQ(frame.radiance.at(x, y).g, inside ? 1.0F : 0.0F) << x << " " << y;
        }
    }
    settings.depthOfField.on = true; // an orthographic view has no lens
    EXPECT_EQ(render().radiance.pixels, frame.radiance.pixels);
}

TEST(RenderFrame, CountsItsTiles) {
    const TracedScene s(test::sampleScene());
    Frame frame;
    RenderControl control{.threads = 2};
    ASSERT_TRUE(test::renderFrame({s.scene, s.tracer, test::sampleCamera(), sampleSettings(100, 70)}, control,
                                  frame));
    EXPECT_EQ(control.tiles, 4U * 3U); // of 32 x 32 pixels
    EXPECT_EQ(control.tilesDone, control.tiles);
}

TEST(RenderFrame, ReusesAFrameOfAnySize) {
    const TracedScene s(test::sampleScene());
    Frame frame;
    RenderControl control{.threads = 1};
    ASSERT_TRUE(
        test::renderFrame({s.scene, s.tracer, test::sampleCamera(), sampleSettings(64, 64)}, control, frame));
    ASSERT_TRUE(
        test::renderFrame({s.scene, s.tracer, test::sampleCamera(), sampleSettings(20, 10)}, control, frame));
    const Frame fresh = test::render(s, sampleSettings(20, 10));
    EXPECT_EQ(frame.radiance.pixels, fresh.radiance.pixels);
    EXPECT_EQ(frame.covered, fresh.covered);
    EXPECT_EQ(frame.statistics.rays, fresh.statistics.rays);
}

/// Each third pixel has what render() gives there. `rounding`: of the order in which light is added.
void expectPixelsOf(const Scene& scene, const RenderSettings& settings, float rounding) {
    const test::TracedScene traced(scene);
    const Frame whole = test::render(traced, settings);
    std::vector<SampleId> pixels;
    for (std::size_t i = 0; i < whole.radiance.pixels.size(); i += 3) {
        const auto width = static_cast<std::size_t>(settings.width);
        pixels.push_back({static_cast<std::uint16_t>(i % width), static_cast<std::uint16_t>(i / width), 0});
    }
    std::vector<Colour> first;
    for (const int threads : {1, 3}) {
        std::vector<Colour> found(pixels.size());
        RenderControl control{.threads = threads};
        RayStatistics statistics;
        ASSERT_TRUE(
            FrameRenderer().renderPixels({traced.scene, traced.tracer, test::sampleCamera(), settings},
                                         pixels, control, {found}, statistics));
        for (std::size_t i = 0; i < pixels.size(); ++i) {
            const Colour there = whole.radiance.at(pixels[i].x, pixels[i].y);
            const float max = rounding * luminance(there);
            ASSERT_NEAR(found[i].r, there.r, max) << i;
            ASSERT_NEAR(found[i].g, there.g, max) << i;
            ASSERT_NEAR(found[i].b, there.b, max) << i;
        }
        EXPECT_LT(statistics.total(), whole.statistics.total());
        if (threads == 1) first = found;
        EXPECT_TRUE(found == first);
    }
}

/// Without secondary rays.
Scene plainScene() {
    Scene scene = test::softlyLitScene();
    for (Material& m : scene.materials) {
        m.mirror = {};
        m.opacity = 1;
        m.alphaTexture = kNoTexture;
    }
    return scene;
}

TEST(RenderFrame, SomePixelsAreThoseOfTheWholeFrame) {
    constexpr float kRounding = 1e-5F;
    for (const int antialiasing : {1, 3}) {
        RenderSettings settings = test::sampleSettings(101, 67, antialiasing);
        const float few = antialiasing == 1 ? 0 : kRounding;
        expectPixelsOf(plainScene(), settings, few);
        expectPixelsOf(test::softlyLitScene(), settings, kRounding);
        settings.ambientOcclusion.on = true;
        settings.sampling = SamplingPattern::Poisson;
        settings.depthOfField.on = true;
        expectPixelsOf(plainScene(), settings, few);
        expectPixelsOf(test::softlyLitScene(), settings, kRounding);
    }
}

std::vector<SampleId> allPixels(const RenderSettings& settings) {
    std::vector<SampleId> pixels;
    for (int y = 0; y < settings.height; ++y) {
        for (int x = 0; x < settings.width; ++x)
            pixels.push_back({static_cast<std::uint16_t>(x), static_cast<std::uint16_t>(y), 0});
    }
    return pixels;
}

TEST(RenderFrame, PixelsWhoseLightsAreKnownNeedNoShadowRays) {
    Scene scene = plainScene();
    for (auto& [light, name, notes, ofSky] : scene.lights)
        light.kind = isAreaLight(light) ? LightKind::Point : light.kind;
    const test::TracedScene traced(scene);
    const RenderSettings settings = test::sampleSettings(101, 67);
    const View view{traced.scene, traced.tracer, test::sampleCamera(), settings};
    const std::vector<SampleId> pixels = allPixels(settings);
    FrameRenderer renderer;
    RenderControl control{.threads = 1};
    std::vector<LightVisibility> visibility(pixels.size());
    std::vector<Colour> first(pixels.size()), second(pixels.size());
    RayStatistics traced1, traced2;
    renderer.renderPixels(view, pixels, control, {first, visibility}, traced1);
    renderer.renderPixels(view, pixels, control, {second, visibility}, traced2);
    EXPECT_EQ(first, second);
    EXPECT_EQ(first, test::render(traced, settings).radiance.pixels);
    EXPECT_GT(traced1.rays[static_cast<std::size_t>(RayKind::Shadow)], pixels.size() / 2);
    EXPECT_EQ(traced2.rays[static_cast<std::size_t>(RayKind::Shadow)], 0U);
    // Known visibility is taken for true.
    std::vector<LightVisibility> dark(pixels.size(), {0, 0xFFFF});
    RayStatistics none;
    renderer.renderPixels(view, pixels, control, {second, dark}, none);
    double brighter = 0;
    for (std::size_t i = 0; i < pixels.size(); ++i)
        brighter += luminance(first[i]) > luminance(second[i]) ? 1 : 0;
    EXPECT_GT(brighter, 0.2 * static_cast<double>(pixels.size()));
}

TEST(RenderFrame, PixelsWhoseLightsWithASizeAreKnownNeedOneRayToEach) {
    Scene scene = plainScene();
    Light globe = test::pointLight({2, 2, 3}, 30);
    globe.kind = LightKind::Sphere;
    globe.radius = 0.5F;
    scene.lights = {globe};
    const test::TracedScene traced(scene);
    RenderSettings settings = test::sampleSettings(101, 67);
    settings.areaLights.samples = 6;
    settings.reflections = settings.refractions = false;
    const View view{traced.scene, traced.tracer, test::sampleCamera(), settings};
    const std::vector<SampleId> pixels = allPixels(settings);
    FrameRenderer renderer;
    RenderControl control{.threads = 1};
    const auto drawn = [&](std::vector<LightVisibility>& visibility, std::uint64_t& rays) {
        std::vector<Colour> light(pixels.size());
        RayStatistics statistics;
        renderer.renderPixels(view, pixels, control, {light, visibility}, statistics);
        rays = statistics.rays[static_cast<std::size_t>(RayKind::Shadow)];
        return light;
    };
    std::vector<LightVisibility> visibility(pixels.size());
    std::uint64_t all = 0, few = 0;
    const std::vector<Colour> first = drawn(visibility, all);
    const std::vector<LightVisibility> found = visibility;
    EXPECT_EQ(first, test::render(traced, settings).radiance.pixels);
    EXPECT_EQ(drawn(visibility, few), first);
    EXPECT_EQ(visibility, found);
    const auto sees = [&](auto visible) { return std::ranges::count_if(found, visible); };
    const auto lit = sees([](LightVisibility v) { return v.clear == 1; }),
               dark = sees([](LightVisibility v) { return v.dark == 1; });
    EXPECT_GT(lit, std::ssize(pixels) / 10);
    EXPECT_GT(dark, std::ssize(pixels) / 50);
    EXPECT_GE(few,
              all - 5 * static_cast<std::uint64_t>(lit + dark)); // at its horizon a light is seen in part
    EXPECT_LT(few, all / 2);
    // Known visibility that the first ray does not confirm does not count.
    std::vector<LightVisibility> wrong(pixels.size());
    std::ranges::transform(found, wrong.begin(), [](LightVisibility v) {
        return LightVisibility{v.dark, v.clear};
    });
    std::uint64_t rays = 0;
    EXPECT_EQ(drawn(wrong, rays), first);
    EXPECT_EQ(wrong, found);
    EXPECT_EQ(rays, all);
}

TEST(RenderFrame, SaysWhatPixelsSee) {
    const test::TracedScene traced(plainScene());
    RenderSettings settings = test::sampleSettings(101, 67);
    FrameRenderer renderer;
    RenderControl control{.threads = 2};
    Frame frame;
    renderer.render({traced.scene, traced.tracer, test::sampleCamera(), settings}, control, frame);
    EXPECT_TRUE(frame.seen.empty()) << "nobody asked";
    renderer.collectSeen(true);
    const CameraRays rays(test::sampleCamera(), settings.width, settings.height);
    for (const int antialiasing : {1, 3}) {
        settings.antialiasing = antialiasing;
        const View view{traced.scene, traced.tracer, test::sampleCamera(), settings};
        renderer.render(view, control, frame);
        ASSERT_EQ(frame.seen.size(), frame.radiance.pixels.size());
        std::vector<SampleId> pixels;
        for (std::uint16_t y = 0; y < 67; y = static_cast<std::uint16_t>(y + 3)) pixels.push_back({y, y, 0});
        std::vector<Colour> light(pixels.size());
        std::vector<SeenPoint> seen(pixels.size());
        RayStatistics none;
        if (antialiasing == 1) renderer.renderPixels(view, pixels, control, {light, {}, seen}, none);
        int hits = 0;
        for (std::size_t i = 0; i < pixels.size(); ++i) {
            const int x = pixels[i].x, y = pixels[i].y;
            const Ray ray = rays.at(static_cast<float>(x) + 0.5F, static_cast<float>(y) + 0.5F);
            RayWave one;
            HitWave hit;
            one.push(ray);
            traced.tracer.intersect(RayKind::Primary, one, hit);
            const SeenPoint& of = frame.seen[static_cast<std::size_t>(y) * 101 + static_cast<std::size_t>(x)];
            ASSERT_EQ(of.any, hit.triangle[0] != kNoTriangle);
            if (antialiasing == 1) {
                EXPECT_EQ(seen[i].any, of.any);
                EXPECT_EQ(seen[i].position, of.position);
            }
            if (!of.any) continue;
            ++hits;
            EXPECT_NEAR(length(of.position - ray.origin), hit.t[0], 1e-4F * hit.t[0]);
        }
        EXPECT_GT(hits, 5);
    }
}

/// The point that the middle pixel sees: a mirror 4 units from the eye, and a wall 5 units before the mirror.
SeenPoint seenInMirror(float curvature) {
    test::SceneBuilder b;
    Material silvered = test::mirror(0.5F);
    silvered.diffuse = {0.5F, 0.5F, 0.5F};
    const auto silver = b.material(silvered);
    if (curvature == 0) {
        b.square({0, 0, -4}, {0, 0, 1}, 1, silver);
    } else {
        b.sphere({0, 0, -4 - 1 / curvature}, 1 / curvature, 64, silver);
    }
    b.square({0, 0, 1}, {0, 0, -1}, 20, b.material(test::matte(0.5F)));
    b.scene.ambient = {1, 1, 1};
    const test::TracedScene traced(b.finish());
    const RenderSettings settings = test::sampleSettings(9, 9);
    Camera camera;
    camera.eye = {};
    camera.forward = {0, 0, -1};
    camera.horizontalFov = 1;
    FrameRenderer renderer;
    renderer.collectSeen(true);
    RenderControl control{.threads = 1};
    Frame frame;
    renderer.render({traced.scene, traced.tracer, camera, settings}, control, frame);
    return frame.seen[4 * 9 + 4];
}

TEST(RenderFrame, SaysHowPanesTintWhatIsSeenThroughThem) {
    test::SceneBuilder b;
    Material glass = test::matte(0.0F);
    glass.opacity = 0;
    glass.transmission = {0.25F, 0.5F, 0.75F};
    const auto pane = b.material(glass);
    // Behind a pane another one: the first tints the light that the second lets through.
    b.square({0, 0, -4}, {0, 0, 1}, 1, pane);
    b.square({0, 0, -6}, {0, 0, 1}, 1, pane);
    b.scene.background = {1, 1, 1};
    const test::TracedScene traced(b.finish());
    RenderSettings settings = test::sampleSettings(9, 9);
    settings.minContribution = 0;
    settings.reflections = false;
    Camera camera;
    camera.eye = {};
    camera.forward = {0, 0, -1};
    camera.horizontalFov = 0.1F;
    FrameRenderer renderer;
    renderer.collectSeen(true);
    RenderControl control{.threads = 1};
    Frame frame;
    renderer.render({traced.scene, traced.tracer, camera, settings}, control, frame);
    const SeenPoint& seen = frame.seen[4 * 9 + 4];
    EXPECT_TRUE(seen.any);
    EXPECT_TRUE(std::isinf(seen.specularDistance));
    const Colour light = frame.radiance.pixels[4 * 9 + 4];
    EXPECT_NEAR(light.r / seen.tint.r, 0.25F, 0.05F);
    EXPECT_NEAR(light.g / seen.tint.g, 0.5F, 0.05F);
    EXPECT_NEAR(light.b / seen.tint.b, 0.75F, 0.05F);
}

TEST(RenderFrame, SaysWhatPixelsSeeThatAreNotRefined) {
    const test::TracedScene traced(plainScene());
    RenderSettings settings = test::sampleSettings(101, 67);
    FrameRenderer renderer;
    renderer.collectSeen(true);
    RenderControl control{.threads = 2};
    Frame frame;
    settings.antialiasing = 3;
    for (const float adaptive : {0.0F, 0.05F}) {
        settings.adaptive = adaptive;
        const View view{traced.scene, traced.tracer, test::sampleCamera(), settings};
        ASSERT_TRUE(renderer.render(view, control, frame));
        int hits = 0;
        for (std::size_t i = 0; i < frame.seen.size(); ++i) {
            if (frame.covered[i] != 255) continue;
            ++hits;
            EXPECT_TRUE(frame.seen[i].any) << i;
        }
        EXPECT_GT(hits, 1000);
    }
}

TEST(RenderFrame, SaysHowFarAwayMirroredLightSeemsToBe) {
    const SeenPoint flat = seenInMirror(0);
    EXPECT_NEAR(flat.position.z, -4, 1e-3);
    EXPECT_NEAR(flat.specularDistance, 4 + 5, 1e-2);
    EXPECT_NEAR(flat.tint.g, 0.5F, 1e-3F);
    EXPECT_GT(flat.surfaceFraction.g, 0.1F);
    EXPECT_LT(flat.surfaceFraction.g, 0.9F);
    // The mirror equation: 1 / image = 1 / 5 + 2 / radius. Below 0: it is bent.
    const SeenPoint ball = seenInMirror(0.5F);
    EXPECT_NEAR(ball.specularDistance, -(4 + 1 / (1.0F / 5 + 2 * 0.5F)), 0.02);
}

TEST(RenderFrame, StopsWhenItIsTold) {
    const TracedScene s(test::sampleScene());
    Frame frame;
    RenderControl control{.threads = 1};
    control.cancel = true;
    EXPECT_FALSE(
        test::renderFrame({s.scene, s.tracer, test::sampleCamera(), sampleSettings(64, 64)}, control, frame));
    EXPECT_EQ(control.tilesDone, 0U);
}

TEST(RenderFrame, StopsSoonWhenItIsToldWhileItWorks) {
    const TracedScene s(test::sampleScene());
    Frame frame;
    RenderControl control{.threads = 2};
    std::thread stopper([&] {
        while (control.tilesDone == 0) std::this_thread::yield();
        control.cancel = true;
    });
    // Minutes of work.
    EXPECT_FALSE(test::renderFrame({s.scene, s.tracer, test::sampleCamera(), sampleSettings(4000, 3000, 4)},
                                   control, frame));
    stopper.join();
    EXPECT_LT(control.tilesDone, control.tiles / 10);
}

TEST(RenderFrame, AnEmptySceneIsBackground) {
    test::SceneBuilder b;
    b.scene.background = {1, 2, 3};
    const TracedScene s(b.finish());
    const Frame frame = test::render(s, sampleSettings(8, 8));
    for (const Colour c : frame.radiance.pixels) EXPECT_EQ(c, (Colour{1, 2, 3}));
    for (const std::uint8_t c : frame.covered) EXPECT_EQ(c, 0);
}

} // namespace
} // namespace rtcore
