#include "rtcore/live/live_renderer.h"

#include "support/one_frame.h"
#include "unit/render/sample_view.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <span>
#include <vector>

namespace rtcore {
namespace {

constexpr int kWidth = 150, kHeight = 101;

/// The sample camera on its way to the right and forward.
Camera cameraAt(int step) {
    Camera camera = test::sampleCamera();
    camera.eye += Vec3{0.02F, 0, -0.03F} * static_cast<float>(step);
    camera.forward.x += 0.004F * static_cast<float>(step);
    return camera;
}

/// But for the rounding of both layers.
bool sameLight(Colour a, Colour b) {
    const Colour off = a - b;
    const float max = std::max({std::fabs(off.r), std::fabs(off.g), std::fabs(off.b)});
    return max <= maxComponent(a) * (2.0F / 512);
}

class LiveFrames : public testing::Test {
  protected:
    bool draw(const Camera& camera, double newSamples) {
        return live.render({traced.scene, traced.tracer, camera, settings}, newSamples, control, frame);
    }
    Frame whole(const Camera& camera) const {
        RenderControl unwatched{.threads = 1};
        FrameRenderer renderer;
        renderer.collectSeen(true);
        Frame result;
        renderer.render({traced.scene, traced.tracer, camera, settings}, unwatched, result);
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
    RenderSettings settings = test::sampleSettings(kWidth, kHeight);
    RenderControl control{.threads = 1};
    LiveRenderer live;
    Frame frame;
};

TEST_F(LiveFrames, WithAllPointsNewAreWholeFrames) {
    for (int step = 0; step < 3; ++step) {
        ASSERT_TRUE(draw(cameraAt(step), 1));
        const Frame truth = whole(cameraAt(step));
        int different = 0;
        for (std::size_t i = 0; i < truth.radiance.pixels.size(); ++i)
            different += sameLight(truth.radiance.pixels[i], frame.radiance.pixels[i]) ? 0 : 1;
        // From the second frame on a point may be recalled that is from here, to a part of a pixel.
        EXPECT_LE(different, step == 0 ? 0 : kWidth * kHeight / 50) << step;
        EXPECT_EQ(frame.covered, truth.covered);
    }
}

TEST_F(LiveFrames, OfAStillCameraKeepTheirLight) {
    ASSERT_TRUE(draw(cameraAt(0), 1));
    const std::vector<Colour> first = frame.radiance.pixels;
    for (int i = 0; i < 3; ++i) {
        ASSERT_TRUE(draw(cameraAt(0), 0));
        EXPECT_TRUE(frame.radiance.pixels == first) << i;
        EXPECT_EQ(frame.statistics.rays[static_cast<std::size_t>(RayKind::Shadow)], 0U);
    }
}

TEST_F(LiveFrames, WhileMovingAreNearTheTruth) {
    ASSERT_TRUE(draw(cameraAt(0), 1));
    for (int step = 1; step <= 12; ++step) ASSERT_TRUE(draw(cameraAt(step), 0.15));
    const double fine = error(cameraAt(12));
    EXPECT_LT(fine, 0.02);
    EXPECT_LT(live.newSamples(), 0.18);
    live.forget();
    ASSERT_TRUE(draw(cameraAt(0), 1));
    for (int step = 1; step <= 12; ++step) ASSERT_TRUE(draw(cameraAt(step), 0.05));
    const double coarse = error(cameraAt(12));
    EXPECT_LT(coarse, 0.05);
    EXPECT_LT(fine, coarse);
}

TEST_F(LiveFrames, BeginWithTheLightOfAWholeFrame) {
    const View view{traced.scene, traced.tracer, cameraAt(0), settings};
    live.seed(LiveRenderer::planeOf(view), whole(cameraAt(0)), 1);
    ASSERT_TRUE(draw(cameraAt(0), 0));
    EXPECT_EQ(live.unknown(), 0);
    EXPECT_LT(error(cameraAt(0)), 0.002);
    ASSERT_TRUE(draw(cameraAt(1), 0.05));
    EXPECT_LT(error(cameraAt(1)), 0.03);
}

TEST_F(LiveFrames, BeginWithTheLightOfAFrameOfManySamplesWhereItsPixelsAre) {
    const RenderSettings one = settings;
    settings.antialiasing = 2;
    const View view{traced.scene, traced.tracer, cameraAt(0), settings};
    const Frame smooth = whole(cameraAt(0));
    live.seed(LiveRenderer::planeOf(view), smooth, 1);
    settings = one;
    ASSERT_TRUE(draw(cameraAt(0), 0));
    std::size_t moved = 0;
    for (std::size_t i = 0; i < smooth.radiance.pixels.size(); ++i)
        moved += sameLight(smooth.radiance.pixels[i], frame.radiance.pixels[i]) ? 0U : 1U;
    EXPECT_LT(moved, smooth.radiance.pixels.size() / 100);
}

TEST_F(LiveFrames, GoOnFromThePartsOfAWholeFrameThatWasLeft) {
    ASSERT_TRUE(draw(cameraAt(0), 0.05));
    const std::vector<PixelArea> parts = {{0, 0, kWidth, 40}, {0, 40, 70, 20}};
    Frame left = whole(cameraAt(0));
    const auto finished = [](int x, int y) { return y < 40 || (y < 60 && x < 70); };
    for (int y = 0; y < kHeight; ++y) { // never read
        for (int x = 0; x < kWidth; ++x) {
            if (!finished(x, y)) left.radiance.at(x, y) = {1e6F, 0, 0};
        }
    }
    const Frame truth = whole(cameraAt(0));
    const auto errorOf = [&](bool inside) {
        double sum = 0;
        for (int y = 0; y < kHeight; ++y) {
            for (int x = 0; x < kWidth; ++x) {
                const float d = luminance(truth.radiance.at(x, y) - frame.radiance.at(x, y));
                if (finished(x, y) == inside) sum += std::fabs(static_cast<double>(d));
            }
        }
        return sum;
    };
    const double inside = errorOf(true), outside = errorOf(false);
    for (const int threads : {1, 2}) {
        live.seedParts({traced.scene, traced.tracer, cameraAt(0), settings}, left, parts, threads);
        ASSERT_TRUE(draw(cameraAt(0), 0));
        EXPECT_LT(errorOf(true), 0.05 * inside) << "but for the seam";
        EXPECT_NEAR(errorOf(false), outside, 0.1 * outside);
    }
}

TEST_F(LiveFrames, BecomeTheTruthWhenTheCameraStands) {
    for (int step = 0; step <= 5; ++step) ASSERT_TRUE(draw(cameraAt(step), 0.05));
    const double moving = error(cameraAt(5));
    for (int i = 0; i < 12; ++i) ASSERT_TRUE(draw(cameraAt(5), 0.2));
    EXPECT_LT(error(cameraAt(5)), 0.3 * moving);
}

TEST_F(LiveFrames, TheFirstOneShowsAllOfThePictureFromFewPoints) {
    ASSERT_TRUE(draw(cameraAt(0), 0.05));
    EXPECT_NEAR(live.newSamples(), 0.05, 0.02);
    EXPECT_NEAR(live.unknown(), 1, 1e-9);
    EXPECT_LT(error(cameraAt(0)), 0.12);
}

/// Few samples leave pixels without one, and with stale ones.
TEST_F(LiveFrames, AreExposedAsWholeOnesAre) {
    const ExposureSettings automatic;
    ASSERT_TRUE(draw(cameraAt(0), 1));
    for (int step = 1; step <= 12; ++step) {
        ASSERT_TRUE(draw(cameraAt(step), 0.05));
        const Frame truth = whole(cameraAt(step));
        EXPECT_NEAR(test::exposureFor(frame, automatic) / test::exposureFor(truth, automatic), 1, 0.02)
            << step;
        const auto covered = [](const Frame& of) {
            return std::accumulate(of.covered.begin(), of.covered.end(), 0.0) / (255.0 * kWidth * kHeight);
        };
        EXPECT_LT(covered(truth), 0.95) << "some of it is background";
        EXPECT_NEAR(covered(frame), covered(truth), 0.01) << step;
    }
}

TEST_F(LiveFrames, OfAnEyeInTheOriginShowPixelsOfWhichNothingIsKnown) {
    Camera camera = cameraAt(0);
    camera.eye = {}; // where the positions of samples are that there are not
    ASSERT_TRUE(draw(camera, 0.2));
    ASSERT_TRUE(draw(camera, 0.2));
    EXPECT_GT(live.newSamples(), 0.1);
    EXPECT_LT(error(camera), 0.12);
    for (const Colour light : frame.radiance.pixels) ASSERT_GE(light.r, 0);
}

TEST_F(LiveFrames, AreTheSameForAnyNumberOfThreads) {
    const std::vector<double> newSamples = {0.3, 0.1, 0.02, 0.05, 0.2};
    const auto walk = [&](int threads) {
        LiveRenderer renderer;
        RenderControl single{.threads = threads};
        std::vector<std::uint64_t> frames;
        Frame result;
        for (std::size_t i = 0; i < newSamples.size(); ++i) {
            const Camera camera = cameraAt(static_cast<int>(i));
            EXPECT_TRUE(renderer.render({traced.scene, traced.tracer, camera, settings}, newSamples[i],
                                        single, result));
            frames.push_back(test::hashOf(std::as_bytes(std::span(result.radiance.pixels))));
        }
        return frames;
    };
    const auto one = walk(1);
    for (const int threads : {2, 7}) EXPECT_EQ(walk(threads), one) << threads;
}

TEST_F(LiveFrames, ACancelledOneLeavesThePastAsItWas) {
    ASSERT_TRUE(draw(cameraAt(0), 1));
    control.cancel = true;
    EXPECT_FALSE(draw(cameraAt(7), 0.1));
    control.cancel = false;
    ASSERT_TRUE(draw(cameraAt(1), 0.1));
    const std::vector<Colour> after = frame.radiance.pixels;
    live.forget();
    LiveRenderer other;
    RenderControl single{.threads = 1};
    Frame result;
    ASSERT_TRUE(other.render({traced.scene, traced.tracer, cameraAt(0), settings}, 1, single, result));
    ASSERT_TRUE(other.render({traced.scene, traced.tracer, cameraAt(1), settings}, 0.1, single, result));
    EXPECT_TRUE(result.radiance.pixels == after);
}

TEST_F(LiveFrames, FollowACameraButNoCut) {
    const auto canReuse = [&](Vec3 from) {
        Camera camera = cameraAt(0);
        camera.eye = from;
        return live.canReuse({traced.scene, traced.tracer, camera, settings});
    };
    EXPECT_TRUE(canReuse({100, 100, 100})) << "nothing is kept that could be wrong";
    ASSERT_TRUE(draw(cameraAt(0), 1));
    const Vec3 eye = cameraAt(0).eye;
    EXPECT_TRUE(canReuse(eye));
    EXPECT_TRUE(canReuse(eye + Vec3{0.1F, 0, 0.1F}));
    EXPECT_FALSE(canReuse(eye + Vec3{0, 4, 0}));
    EXPECT_FALSE(canReuse(eye - Vec3{0, 0, 20}));
}

TEST_F(LiveFrames, OfAnotherSizeTakeTheLightAlong) {
    ASSERT_TRUE(draw(cameraAt(0), 1));
    settings.width = 120;
    settings.height = 81;
    ASSERT_TRUE(draw(cameraAt(0), 0));
    EXPECT_LT(live.unknown(), 0.03);
    EXPECT_LT(error(cameraAt(0)), 0.05);
}

TEST_F(LiveFrames, HaveOneSamplePerPixel) {
    const auto supports = [&] {
        return LiveRenderer::supports({traced.scene, traced.tracer, cameraAt(0), settings});
    };
    EXPECT_TRUE(supports());
    settings.antialiasing = 2;
    EXPECT_FALSE(supports());
    settings.antialiasing = 1;
    settings.sampling = SamplingPattern::Random;
    EXPECT_FALSE(supports());
    settings.sampling = SamplingPattern::Grid;
    settings.depthOfField.on = true;
    EXPECT_FALSE(supports());
}

/// Behind a wall that a camera passes, forwards or backwards, nothing that it saw before is seen.
TEST(LiveRenderer, DoesNotFollowThroughSurfaces) {
    test::SceneBuilder wall;
    wall.square({0, 0, 6.2F}, {0, 0, 1}, 8, wall.material(test::matte(0.5F)));
    const test::TracedScene walled(wall.finish());
    const RenderSettings settings = test::sampleSettings(kWidth, kHeight);
    LiveRenderer live;
    RenderControl control{.threads = 1};
    Frame frame;
    Camera camera = test::sampleCamera();
    const auto canReuse = [&](Vec3 eye) {
        Camera next = camera;
        next.eye = eye;
        return live.canReuse({walled.scene, walled.tracer, next, settings});
    };
    camera.eye = {0, 0, 6};
    ASSERT_TRUE(live.render({walled.scene, walled.tracer, camera, settings}, 0.1, control, frame));
    EXPECT_TRUE(canReuse(camera.eye));
    EXPECT_TRUE(canReuse(camera.eye + Vec3{0.5F, 0.1F, 0.15F}));
    EXPECT_FALSE(canReuse(camera.eye + Vec3{0, 0, 0.25F}));
    camera.eye.z = 6.4F;
    EXPECT_FALSE(canReuse(camera.eye));
    live.forget();
    EXPECT_TRUE(canReuse(camera.eye)) << "nothing is kept that could be wrong";
    ASSERT_TRUE(live.render({walled.scene, walled.tracer, camera, settings}, 0.1, control, frame));
    EXPECT_TRUE(canReuse(camera.eye + Vec3{0, 0, 0.04F}));
    EXPECT_FALSE(canReuse(camera.eye - Vec3{0, 0, 0.3F}));
}

} // namespace
} // namespace rtcore
