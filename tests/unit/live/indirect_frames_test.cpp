// Live frames that are lit by what is learned of indirect light.

#include "rtcore/live/live_renderer.h"

#include "rtcore/gathering/indirect_light.h"
#include "rtcore/math/packed_direction.h"
#include "rtcore/render/path_renderer.h"
#include "rtcore/render/view_light.h"

#include "support/random_numbers.h"
#include "support/small_scene.h"

#include <gtest/gtest.h>

#include <vector>

namespace rtcore {
namespace {

constexpr int kWidth = 128, kHeight = 96;

Scene lit(Scene scene) {
    scene.lights = {test::pointLight({2, 2.6F, 2}, 4)};
    scene.ambient = {5, 5, 5}; // gives way
    return scene;
}

/// A closed room of albedo 0.7 with a block and, unless it is to be matte, a mirror and a pane, seen from
/// inside.
Scene room(bool matte = false) {
    test::SceneBuilder b;
    const auto white = b.material(test::matte(0.7F)), mirror = b.material(test::mirror(0.8F));
    Material pane = test::glass();
    pane.opacity = 0.2F;
    const auto glass = b.material(pane);
    b.quad({0, 0, 0}, {0, 0, 4}, {4, 0, 4}, {4, 0, 0}, white);
    b.quad({0, 3, 0}, {4, 3, 0}, {4, 3, 4}, {0, 3, 4}, white);
    b.quad({0, 0, 0}, {4, 0, 0}, {4, 3, 0}, {0, 3, 0}, white);
    b.quad({0, 0, 4}, {0, 3, 4}, {4, 3, 4}, {4, 0, 4}, white);
    b.quad({0, 0, 0}, {0, 3, 0}, {0, 3, 4}, {0, 0, 4}, white);
    b.quad({4, 0, 0}, {4, 0, 4}, {4, 3, 4}, {4, 3, 0}, white);
    b.box({1.2F, 0, 0.6F}, {2, 1, 1.4F}, white);
    if (matte) return lit(b.finish());
    b.quad({2.6F, 0.4F, 0.3F}, {3.6F, 0.4F, 0.3F}, {3.6F, 1.8F, 0.3F}, {2.6F, 1.8F, 0.3F}, mirror);
    b.quad({0.2F, 0.2F, 1.8F}, {1, 0.2F, 1.8F}, {1, 1.4F, 1.8F}, {0.2F, 1.4F, 1.8F}, glass);
    return lit(b.finish());
}

Camera cameraAt(int step) {
    Camera camera;
    camera.eye = {2.2F + 0.01F * static_cast<float>(step), 1.4F, 3.7F - 0.01F * static_cast<float>(step)};
    camera.forward = {-0.05F, -0.1F, -1};
    return camera;
}

double mean(const HdrImage& image) {
    double sum = 0;
    for (const Colour c : image.pixels) sum += luminance(c) / static_cast<double>(image.pixels.size());
    return sum;
}

class IndirectFrames : public testing::Test {
  protected:
    IndirectFrames() {
        settings.width = kWidth;
        settings.height = kHeight;
        settings.ambientOcclusion.on = true; // gives way
        settings.indirect.mode = IndirectMode::Live;
    }
    HdrImage byPaths(const Camera& camera, int samples) const {
        RenderSettings paths = settings;
        paths.integrator = Integrator::Path;
        paths.path.samples = samples;
        RenderControl control;
        PathRenderer renderer;
        Frame frame;
        renderer.render({traced.scene, traced.tracer, camera, paths}, control, frame);
        return frame.radiance;
    }
    /// Without indirect light, or anything in its place.
    RenderSettings plain() const {
        RenderSettings plain = settings;
        plain.indirect.mode = IndirectMode::Off;
        plain.ambientOcclusion.on = true;
        plain.ambientOcclusion.light = 1e-9F;
        return plain;
    }
    /// So many frames of a walk, a twentieth of their pixels new.
    Frame walk(int frames, int threads, IndirectLight& light) const {
        light.begin(traced.scene, traced.tracer, settings);
        LiveRenderer live;
        live.lightIndirectly(&light, {4096, 512}, 8);
        RenderControl control{.threads = threads};
        Frame frame;
        for (int step = 0; step < frames; ++step)
            EXPECT_TRUE(live.render({traced.scene, traced.tracer, cameraAt(step), settings},
                                    step == 0 ? 1 : 0.05, control, frame));
        return frame;
    }

    test::TracedScene traced{room()};
    RenderSettings settings = test::exactSettings();
};

TEST_F(IndirectFrames, HaveTheLightOfPaths) {
    const double truth = mean(byPaths(cameraAt(24), 64));
    IndirectLight light;
    EXPECT_NEAR(mean(walk(1, 0, light).radiance) / mean(byPaths(cameraAt(0), 64)), 1, 0.1);
    EXPECT_NEAR(mean(walk(25, 0, light).radiance) / truth, 1, 0.03);
}

TEST_F(IndirectFrames, TheSameBitsForAllThreads) {
    IndirectLight light;
    const HdrImage expected = walk(6, 1, light).radiance;
    for (const int threads : {2, 7}) {
        const HdrImage image = walk(6, threads, light).radiance;
        EXPECT_EQ(image.pixels, expected.pixels) << threads;
    }
}

TEST_F(IndirectFrames, SamplesFollowALightThatIsSwitchedOff) {
    IndirectLight light;
    light.begin(traced.scene, traced.tracer, settings);
    LiveRenderer live;
    live.lightIndirectly(&light, {16384, 1536}, 4);
    RenderControl control;
    Frame frame;
    for (int step = 0; step < 8; ++step)
        live.render({traced.scene, traced.tracer, cameraAt(0), settings}, step == 0 ? 1 : 0.01, control,
                    frame);
    Scene dark = traced.scene;
    dark.lights[0].light.on = 0;
    light.changeLight(dark, traced.tracer, settings);
    const double before = mean(frame.radiance);
    live.forget();
    for (int step = 0; step < 20; ++step)
        live.render({dark, traced.tracer, cameraAt(0), settings}, step == 0 ? 1 : 0.01, control, frame);
    EXPECT_LT(mean(frame.radiance), 0.02 * before);
}

/// After the light of a whole frame, of one sample per pixel or more, is switched off: without any new sample
/// what is left is direct light.
TEST_F(IndirectFrames, SamplesOfWholeFramesFollow) {
    constexpr double kNone = 1e-9; // new samples
    const test::TracedScene matte{room(true)};
    const View view{matte.scene, matte.tracer, cameraAt(0), settings};
    Scene dark = matte.scene;
    dark.lights[0].light.on = 0;
    for (const int antialiasing : {1, 2}) {
        RenderSettings finer = settings;
        finer.antialiasing = antialiasing;
        IndirectLight light;
        ViewSteps steps;
        RenderControl control;
        light.begin(matte.scene, matte.tracer, settings);
        std::vector<SampleId> pixels;
        for (std::uint16_t y = 0; y < kHeight; ++y)
            for (std::uint16_t x = 0; x < kWidth; ++x) pixels.push_back({x, y, 0});
        for (int step = 0; step < 4; ++step) steps.step(view, pixels, {16384, 1536}, control, light);
        FrameRenderer renderer;
        renderer.collectSeen(true);
        Frame direct, whole;
        renderer.render({matte.scene, matte.tracer, cameraAt(0), plain()}, control, direct);
        EXPECT_TRUE(direct.matter.empty()) << "there is no indirect light";
        renderer.lightIndirectlyFrom(&light);
        renderer.render({matte.scene, matte.tracer, cameraAt(0), finer}, control, whole);
        LiveRenderer live;
        live.lightIndirectly(&light, {16384, 1536}, 4);
        live.seed(LiveRenderer::planeOf(view), whole, 0);
        Frame frame;
        live.render(view, kNone, control, frame);
        EXPECT_NEAR(mean(frame.radiance) / mean(whole.radiance), 1, 0.03) << antialiasing;
        light.changeLight(dark, matte.tracer, settings);
        for (int step = 0; step < 16; ++step) live.render(view, kNone, control, frame);
        EXPECT_NEAR(mean(frame.radiance) / mean(direct.radiance), 1, 0.06) << antialiasing;
        EXPECT_LT(mean(direct.radiance), 0.7 * mean(whole.radiance));
    }
}

TEST_F(IndirectFrames, WholeFramesOfAViewHaveItsLightAndTheSameBits) {
    const View view{traced.scene, traced.tracer, cameraAt(0), settings};
    const auto whole = [&](int threads) {
        ViewLight light;
        RenderControl control{.threads = threads};
        EXPECT_TRUE(light.learn(view, control));
        FrameRenderer renderer;
        renderer.lightIndirectlyFrom(&light.light());
        Frame frame;
        EXPECT_TRUE(renderer.render(view, control, frame));
        return frame.radiance;
    };
    const HdrImage expected = whole(2);
    EXPECT_EQ(whole(1).pixels, expected.pixels);
    EXPECT_NEAR(mean(expected) / mean(byPaths(cameraAt(0), 64)), 1, 0.02);
}

TEST(PackedDirection, IsExactToASmallAngle) {
    test::Random random(3);
    for (int i = 0; i < 10000; ++i) {
        const Vec3 direction = random.unitVector();
        EXPECT_LT(length(unpackDirection(packDirection(direction)) - direction), 1e-4);
    }
    for (const Vec3 axis : {Vec3{1, 0, 0}, Vec3{0, -1, 0}, Vec3{0, 0, 1}})
        EXPECT_LT(length(unpackDirection(packDirection(axis)) - axis), 1e-4);
}

} // namespace
} // namespace rtcore
