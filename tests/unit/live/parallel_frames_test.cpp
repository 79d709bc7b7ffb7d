/// Live frames of parallel cameras.
#include "rtcore/live/live_renderer.h"

#include "rtcore/simd/instruction_set.h"
#include "support/one_frame.h"
#include "unit/render/sample_view.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace rtcore {
namespace {

constexpr int kAcross = 150, kDown = 101;

/// The sample camera without perspective, on its way: aside, turning, and magnifying.
Camera parallelAt(int step) {
    const auto at = static_cast<float>(step);
    Camera camera = test::sampleCamera();
    camera.kind = CameraKind::Orthographic;
    camera.orthographicWidth = 7 - 0.03F * at;
    camera.eye += Vec3{0.02F, 0.01F, -0.03F} * at;
    camera.forward.x += 0.004F * at;
    return camera;
}

/// A sky that gets brighter from one side to the other.
Environment striped() {
    HdrImage image;
    image.width = 64;
    image.height = 32;
    for (int i = 0; i < image.width * image.height; ++i) {
        const auto column = static_cast<float>(i % image.width);
        image.pixels.push_back(Colour{0.5F, 0.7F, 1} * (1 + 0.1F * column));
    }
    return Environment::fromEquirectangular(image, "striped");
}

class ParallelFrames : public testing::Test {
  protected:
    View view(const Camera& camera) const { return {traced.scene, traced.tracer, camera, settings}; }
    bool draw(const Camera& camera, double newSamples) {
        return live.render(view(camera), newSamples, control, frame);
    }
    Frame whole(const Camera& camera) const {
        RenderControl unwatched{.threads = 1};
        FrameRenderer renderer;
        renderer.collectSeen(true);
        Frame result;
        renderer.render(view(camera), unwatched, result);
        return result;
    }
    /// Root mean square, of what a display would show of it.
    double error(const Camera& camera) const {
        const Frame truth = whole(camera);
        double sum = 0;
        for (std::size_t i = 0; i < truth.radiance.pixels.size(); ++i) {
            const auto shown = [](Colour c) {
                return static_cast<double>(luminance(c) / (luminance(c) + 1));
            };
            const double d = shown(truth.radiance.pixels[i]) - shown(frame.radiance.pixels[i]);
            sum += d * d;
        }
        return std::sqrt(sum / static_cast<double>(truth.radiance.pixels.size()));
    }

    test::TracedScene traced{test::sampleScene()};
    RenderSettings settings = test::sampleSettings(kAcross, kDown);
    RenderControl control{.threads = 1};
    LiveRenderer live;
    Frame frame;
};

TEST_F(ParallelFrames, AreSupported) { EXPECT_TRUE(LiveRenderer::supports(view(parallelAt(0)))); }

TEST_F(ParallelFrames, OfAStillCameraKeepTheirLight) {
    ASSERT_TRUE(draw(parallelAt(0), 1));
    EXPECT_LT(error(parallelAt(0)), 1e-3);
    const std::vector<Colour> first = frame.radiance.pixels;
    for (int i = 0; i < 3; ++i) {
        ASSERT_TRUE(draw(parallelAt(0), 0));
        EXPECT_TRUE(frame.radiance.pixels == first) << i;
    }
}

TEST_F(ParallelFrames, MovedByWholePixelsShowTheSameLight) {
    Camera camera = parallelAt(0);
    ASSERT_TRUE(draw(camera, 1));
    const HdrImage before = frame.radiance;
    const CameraRays rays(camera, kAcross, kDown);
    camera.eye += rays.plane().right * 5 + rays.plane().down * 3;
    ASSERT_TRUE(draw(camera, 0));
    int same = 0;
    constexpr int kCompared = (kAcross - 7) * (kDown - 5);
    for (int y = 1; y < kDown - 4; ++y) {
        for (int x = 1; x < kAcross - 6; ++x) {
            const Colour off = frame.radiance.at(x, y) - before.at(x + 5, y + 3);
            same += std::fabs(luminance(off)) <= 0.02F * luminance(before.at(x + 5, y + 3)) + 1e-4F ? 1 : 0;
        }
    }
    EXPECT_GT(same, 0.99 * kCompared);
}

TEST_F(ParallelFrames, WhileMovingAreNearTheTruth) {
    ASSERT_TRUE(draw(parallelAt(0), 1));
    for (int step = 1; step <= 12; ++step) ASSERT_TRUE(draw(parallelAt(step), 0.15));
    EXPECT_LT(error(parallelAt(12)), 0.02);
    EXPECT_LT(live.newSamples(), 0.18);
}

TEST_F(ParallelFrames, BeginWithTheLightOfAWholeFrame) {
    settings.antialiasing = 2;
    const Frame smooth = whole(parallelAt(0));
    live.seed(LiveRenderer::planeOf(view(parallelAt(0))), smooth, 1);
    settings.antialiasing = 1;
    ASSERT_TRUE(draw(parallelAt(0), 0));
    EXPECT_EQ(live.unknown(), 0);
    EXPECT_LT(error(parallelAt(0)), 0.03) << "but for edges, which one sample does not smooth";
    const std::vector<PixelArea> parts = {{0, 0, kAcross, kDown}};
    live.seedParts(view(parallelAt(0)), whole(parallelAt(0)), parts, 1);
    ASSERT_TRUE(draw(parallelAt(0), 0));
    EXPECT_LT(error(parallelAt(0)), 1e-3);
}

TEST_F(ParallelFrames, HaveTheSkyOfTheirDirection) {
    traced.scene.environments = {std::make_shared<Environment>(striped())};
    Camera camera = parallelAt(0);
    camera.forward = {0, 0.2F, -1};
    ASSERT_TRUE(draw(camera, 1));
    for (int step = 1; step <= 5; ++step) {
        camera.forward = {0.1F * static_cast<float>(step), 0.2F, -1};
        ASSERT_TRUE(draw(camera, 0.1));
        const Frame truth = whole(camera);
        ASSERT_EQ(truth.covered.front(), 0);
        std::size_t off = 0, all = 0;
        for (std::size_t i = 0; i < truth.covered.size(); ++i) {
            if (truth.covered[i] != 0) continue;
            ++all;
            const Colour change = frame.radiance.pixels[i] - truth.radiance.pixels[i];
            off += std::fabs(luminance(change)) > 0.02F * luminance(truth.radiance.pixels[i]) ? 1U : 0U;
        }
        EXPECT_LT(off, all / 20) << step << ": but at edges";
    }
}

TEST_F(ParallelFrames, ForgetThoseOfTheOtherProjection) {
    Camera perspective = test::sampleCamera();
    for (const bool parallelFirst : {false, true}) {
        const Camera first = parallelFirst ? parallelAt(0) : perspective,
                     second = parallelFirst ? perspective : parallelAt(0);
        live.forget();
        ASSERT_TRUE(draw(first, 1));
        EXPECT_TRUE(live.canReuse(view(first)));
        EXPECT_FALSE(live.canReuse(view(second)));
        ASSERT_TRUE(draw(second, 0.1));
        EXPECT_EQ(live.unknown(), 1);
        LiveRenderer other;
        Frame wanted;
        ASSERT_TRUE(other.render(view(second), 0.1, control, wanted));
        EXPECT_TRUE(frame.radiance.pixels == wanted.radiance.pixels);
    }
}

TEST_F(ParallelFrames, AreReusedWhereTheyShowAboutTheSame) {
    const Camera camera = parallelAt(0);
    ASSERT_TRUE(draw(camera, 1));
    const auto reuses = [&](auto&& change) {
        Camera next = camera;
        change(next);
        return live.canReuse(view(next));
    };
    EXPECT_TRUE(reuses([](Camera& next) { next.eye.x += 1; }));
    EXPECT_TRUE(reuses([](Camera& next) { next.eye += next.forward * -100; })) << "it shows the same";
    EXPECT_TRUE(reuses([](Camera& next) { next.orthographicWidth *= 0.9F; }));
    EXPECT_TRUE(reuses([](Camera& next) { next.forward.x += 0.1F; }));
    EXPECT_FALSE(reuses([](Camera& next) { next.eye.x += 6; }));
    EXPECT_FALSE(reuses([](Camera& next) { next.eye += normalize(next.forward) * 100; }));
    EXPECT_FALSE(reuses([](Camera& next) { next.orthographicWidth *= 0.5F; }));
    EXPECT_FALSE(reuses([](Camera& next) { next.orthographicWidth *= 2; }));
    EXPECT_FALSE(reuses([](Camera& next) { next.forward = {1, 0, 0}; }));
}

/// Behind a wall that the plane of rays passes, backwards, nothing that it saw before is seen.
TEST(ParallelWall, HidesWhatIsBehindItAtOnce) {
    test::SceneBuilder b;
    Material wall = test::matte(0);
    wall.emission = {1, 1, 1};
    b.square({-20.8F, 0, 5}, {0, 0, 1}, 20, b.material(wall)); // at the left of the view
    b.square({0, 0, -5}, {0, 0, 1}, 40, b.material(test::matte(0)));
    const test::TracedScene walled(b.finish());
    const RenderSettings settings = test::sampleSettings(kAcross, kDown);
    Camera camera;
    camera.kind = CameraKind::Orthographic;
    camera.orthographicWidth = 8;
    camera.eye = {0, 0, 4};
    LiveRenderer live;
    RenderControl control{.threads = 1};
    Frame frame;
    const auto draw = [&](double newSamples) {
        return live.render({walled.scene, walled.tracer, camera, settings}, newSamples, control, frame);
    };
    ASSERT_TRUE(draw(1));
    EXPECT_LT(luminance(frame.radiance.at(kAcross / 4, kDown / 2)), 0.01F);
    for (const float yaw : {0.0F, 0.05F}) { // it turns, too
        camera.eye = {0, 0, 6};
        camera.forward = {yaw, 0, -1};
        EXPECT_TRUE(live.canReuse({walled.scene, walled.tracer, camera, settings})) << "of the other part";
    }
    ASSERT_TRUE(draw(0.3));
    EXPECT_GT(live.unknown(), 0.3);
    EXPECT_GT(luminance(frame.radiance.at(kAcross / 4, kDown / 2)), 0.9F);
    EXPECT_LT(luminance(frame.radiance.at(3 * kAcross / 4, kDown / 2)), 0.01F);
}

TEST_F(ParallelFrames, AreTheSameForEveryInstructionSetAndNumberOfThreads) {
    const std::vector<double> newSamples = {0.3, 0.1, 0.02, 0.05, 0.2};
    const auto walk = [&](int threads) {
        LiveRenderer renderer;
        RenderControl threaded{.threads = threads};
        std::vector<std::uint64_t> frames;
        Frame result;
        for (std::size_t i = 0; i < newSamples.size(); ++i) {
            const Camera camera = parallelAt(3 * static_cast<int>(i));
            EXPECT_TRUE(renderer.render(view(camera), newSamples[i], threaded, result));
            frames.push_back(test::hashOf(std::as_bytes(std::span(result.radiance.pixels))));
        }
        return frames;
    };
    const auto wanted = walk(1);
    for (const int threads : {2, 7}) EXPECT_EQ(walk(threads), wanted) << threads;
    for (const std::string& set : instructionSets()) {
        ASSERT_TRUE(useInstructionSet(set));
        EXPECT_EQ(walk(1), wanted) << set;
    }
    useInstructionSet("auto");
}

} // namespace
} // namespace rtcore
