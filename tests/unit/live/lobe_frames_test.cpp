// Polished surfaces in frames that are lit by what is learned of indirect light.

#include "rtcore/live/live_renderer.h"

#include "rtcore/gathering/indirect_light.h"
#include "rtcore/render/path_renderer.h"
#include "rtcore/render/view_light.h"
#include "rtcore/scene/metallic_roughness.h"

#include "support/small_scene.h"

#include <gtest/gtest.h>

#include <vector>

namespace rtcore {
namespace {

constexpr int kColumns = 128, kRows = 80;

Material polished(Colour base, float metallic, float roughness) {
    Material m;
    setMetallicRoughness(m, base, metallic, roughness);
    return m;
}

Material phong(float shininess) {
    Material m;
    m.diffuse = {0.2F, 0.2F, 0.2F};
    m.specular = {0.6F, 0.6F, 0.6F};
    m.shininess = shininess;
    return m;
}

/// A floor before a bright wall in a room that is dark otherwise; its light stands near the wall.
Scene polishedFloor(const Material& floor) {
    test::SceneBuilder b;
    const auto dark = b.material(test::matte(0.1F)), bright = b.material(test::matte(0.8F));
    b.quad({0, 0, 0}, {0, 0, 4}, {4, 0, 4}, {4, 0, 0}, b.material(floor));
    b.quad({0, 3, 0}, {4, 3, 0}, {4, 3, 4}, {0, 3, 4}, dark);
    b.quad({0, 0, 0}, {4, 0, 0}, {4, 3, 0}, {0, 3, 0}, bright);
    b.quad({0, 0, 4}, {0, 3, 4}, {4, 3, 4}, {4, 0, 4}, dark);
    b.quad({0, 0, 0}, {0, 3, 0}, {0, 3, 4}, {0, 0, 4}, dark);
    b.quad({4, 0, 0}, {4, 0, 4}, {4, 3, 4}, {4, 3, 0}, dark);
    Scene scene = b.finish();
    scene.lights = {test::pointLight({2, 2.6F, 0.8F}, 4)};
    return scene;
}

/// Only the floor is seen.
Camera aboveFloor(int step = 0) {
    Camera camera;
    camera.eye = {2 + 0.01F * static_cast<float>(step), 1.4F, 3.7F};
    camera.forward = {0, -0.62F, -1};
    camera.horizontalFov = 50;
    return camera;
}

double mean(const std::vector<Colour>& pixels) {
    double sum = 0;
    for (const Colour c : pixels) sum += luminance(c) / static_cast<double>(pixels.size());
    return sum;
}

RenderSettings liveSettings() {
    RenderSettings settings = test::exactSettings();
    settings.width = kColumns;
    settings.height = kRows;
    settings.indirect.mode = IndirectMode::Live;
    return settings;
}

class PolishedFloor {
  public:
    explicit PolishedFloor(const Material& floor) : traced(polishedFloor(floor)) {}

    double byPaths(int samples) const {
        RenderSettings paths = settings;
        paths.integrator = Integrator::Path;
        paths.path.samples = samples;
        RenderControl control;
        PathRenderer renderer;
        Frame frame;
        renderer.render(view(paths), control, frame);
        return mean(frame.radiance.pixels);
    }
    HdrImage whole(int threads = 0) const {
        ViewLight light;
        RenderControl control{.threads = threads};
        EXPECT_TRUE(light.learn(view(settings), control));
        FrameRenderer renderer;
        renderer.lightIndirectlyFrom(&light.light());
        Frame frame;
        EXPECT_TRUE(renderer.render(view(settings), control, frame));
        return frame.radiance;
    }
    /// Of so many frames a twentieth of whose pixels are new, the last.
    HdrImage walked(int frames, int threads = 0) const {
        IndirectLight light;
        light.begin(traced.scene, traced.tracer, settings);
        LiveRenderer live;
        live.lightIndirectly(&light, {4096, 512}, 8);
        RenderControl control{.threads = threads};
        Frame frame;
        for (int step = 0; step < frames; ++step)
            EXPECT_TRUE(live.render({traced.scene, traced.tracer, aboveFloor(step - frames + 1), settings},
                                    step == 0 ? 1 : 0.05, control, frame));
        return frame.radiance;
    }

    test::TracedScene traced;
    RenderSettings settings = liveSettings();

  private:
    View view(const RenderSettings& with) const { return {traced.scene, traced.tracer, camera_, with}; }
    Camera camera_ = aboveFloor();
};

TEST(LobeFrames, ShowWhatPolishedFloorsReflect) {
    for (const float roughness : {0.1F, 0.2F, 0.4F}) {
        for (const float metallic : {0.0F, 1.0F}) {
            const PolishedFloor floor(polished({0.8F, 0.8F, 0.8F}, metallic, roughness));
            const double truth = floor.byPaths(128);
            EXPECT_NEAR(mean(floor.whole().pixels) / truth, 1, 0.03) << roughness << ' ' << metallic;
            // A narrow lobe meets so few cells that the mean of a frame has some noise.
            double walked = 0;
            for (const int frames : {16, 24, 32, 40}) walked += mean(floor.walked(frames).pixels) / 4;
            EXPECT_NEAR(walked / truth, 1, 0.05) << roughness << ' ' << metallic;
        }
    }
}

TEST(LobeFrames, ShowWhatHighlightsOfPhongsModelReflect) {
    for (const float shininess : {60.0F, 400.0F}) {
        const PolishedFloor floor(phong(shininess));
        EXPECT_NEAR(mean(floor.whole().pixels) / floor.byPaths(128), 1, 0.03) << shininess;
    }
}

TEST(LobeFrames, TheSameBitsForAllThreads) {
    const PolishedFloor floor(polished({0.8F, 0.8F, 0.8F}, 0.5F, 0.25F));
    const HdrImage walked = floor.walked(6, 1), whole = floor.whole(1);
    for (const int threads : {2, 7}) {
        EXPECT_EQ(floor.walked(6, threads).pixels, walked.pixels) << threads;
        EXPECT_EQ(floor.whole(threads).pixels, whole.pixels) << threads;
    }
}

TEST(LobeFrames, WhiteMetalUnderAWhiteSkyIsWhite) {
    for (const float roughness : {0.2F, 0.4F, 0.48F}) {
        test::SceneBuilder b;
        const auto white = b.material(polished(kWhite, 1, roughness));
        b.quad({-8, 0, -8}, {-8, 0, 8}, {8, 0, 8}, {8, 0, -8}, white);
        b.box({-1, 0, -1}, {0, 1.5F, 0}, white);
        b.box({0.2F, 0, 0.2F}, {1, 0.4F, 1.4F}, white);
        Scene scene = b.finish();
        scene.background = kWhite;
        const test::TracedScene traced(std::move(scene));
        RenderSettings settings = liveSettings();
        settings.path.bounces = 200;
        settings.path.rouletteFrom = 1000;
        Camera camera;
        camera.eye = {1.5F, 2, 4};
        camera.forward = {-0.35F, -0.4F, -1};
        camera.horizontalFov = 40;
        const View view{traced.scene, traced.tracer, camera, settings};
        ViewLight light;
        RenderControl control;
        ASSERT_TRUE(light.learn(view, control));
        FrameRenderer renderer;
        renderer.lightIndirectlyFrom(&light.light());
        Frame frame;
        ASSERT_TRUE(renderer.render(view, control, frame));
        EXPECT_NEAR(mean(frame.radiance.pixels), 1, 0.01) << roughness;
    }
}

} // namespace
} // namespace rtcore
