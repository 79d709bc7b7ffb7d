// Images by paths that a net denoises come with a steady one where indirect light is on, and are else as
// ever.
#include "rtcore/render/image_renderer.h"
#include "rtcore/render/ray_images.h"
#include "rtcore/render/steady_image.h"

#include "sample_view.h"

#include <gtest/gtest.h>

#include <vector>

namespace rtcore {
namespace {

class SteadyImageTest : public testing::Test {
  protected:
    SteadyImageTest() {
        settings.integrator = Integrator::Path;
        settings.path.samples = 4;
        settings.denoise.net = DenoiseNet::Base;
        settings.indirect.mode = IndirectMode::Live;
    }

    Frame byPaths(int threads, const ImageRequest& request = {.guides = true}) {
        const auto renderer = makeImageRenderer(Integrator::Path);
        RenderControl control{.threads = threads};
        Frame frame;
        EXPECT_TRUE(
            renderer->render({traced.scene, traced.tracer, camera, settings}, control, request, frame));
        EXPECT_NEAR(renderer->fraction(control), 1, 1e-9);
        return frame;
    }

    const test::TracedScene traced{test::softlyLitScene()};
    const Camera camera = test::sampleCamera();
    RenderSettings settings = test::sampleSettings(70, 41);
};

TEST_F(SteadyImageTest, IsThatOfWhittedsRaysWithIndirectLightForAnyThreads) {
    RenderSettings rays = settings;
    rays.integrator = Integrator::Whitted;
    rays.antialiasing = 4;
    RenderControl control{.threads = 1};
    Frame expected;
    ASSERT_TRUE(RayImages().render({traced.scene, traced.tracer, camera, rays}, control, {}, expected));
    settings.path.seed = 5; // noise of films does not stand still, this does
    for (const int threads : {1, 2, 3})
        EXPECT_EQ(byPaths(threads).steady.pixels, expected.radiance.pixels) << threads;
}

TEST_F(SteadyImageTest, ChangesNoPathAndNeedsANet) {
    const Frame with = byPaths(2);
    EXPECT_EQ(with.halves.samples, 4U) << "by which it is mixed";
    settings.indirect.mode = IndirectMode::Off;
    const Frame without = byPaths(2);
    EXPECT_TRUE(without.steady.empty());
    EXPECT_TRUE(without.halves.empty());
    EXPECT_EQ(with.radiance.pixels, without.radiance.pixels);
    settings.indirect.mode = IndirectMode::Live;
    settings.denoise.mix = false;
    EXPECT_TRUE(byPaths(2).steady.empty());
    settings.denoise.mix = true;
    settings.denoise.net = DenoiseNet::Off;
    EXPECT_TRUE(byPaths(2).steady.empty());
}

/// What is shown first does not wait for it.
TEST_F(SteadyImageTest, ComesOnceThereAreSamplesThatTookAsLong) {
    settings.path.samples = 32;
    std::vector<std::uint32_t> without, with;
    ImageRequest request{.guides = true};
    request.show = [&](const ImagePass& pass) {
        (pass.frame.steady.empty() ? without : with).push_back(pass.samples);
    };
    const Frame frame = byPaths(2, request);
    EXPECT_EQ(without, (std::vector<std::uint32_t>{1, 1, 2, 4})) << "the first one is coarse";
    EXPECT_EQ(with, (std::vector<std::uint32_t>{8, 16}));
    const Frame alone = byPaths(1);
    EXPECT_EQ(frame.radiance.pixels, alone.radiance.pixels);
    EXPECT_EQ(frame.steady.pixels, alone.steady.pixels);
}

TEST_F(SteadyImageTest, StopsWhenItIsTold) {
    RenderControl control{.threads = 1};
    control.cancel = true;
    Frame frame;
    SteadyImage image;
    EXPECT_FALSE(image.render({traced.scene, traced.tracer, camera, settings}, control, frame));
}

} // namespace
} // namespace rtcore
