#include "rtcore/render/path_renderer.h"

#include "sample_view.h"
#include "sums_support.h"

#include <gtest/gtest.h>

#include <limits>

namespace rtcore {
namespace {

ImageSums sumsOf(const test::TracedScene& traced, const std::vector<SampleRange>& ranges, int threads = 1) {
    const RenderSettings settings = test::sampleSettings(70, 41);
    const Camera camera = test::sampleCamera();
    PathRenderer renderer;
    renderer.begin({traced.scene, traced.tracer, camera, settings}, threads);
    RenderControl control{.threads = threads};
    for (const SampleRange& range : ranges) EXPECT_TRUE(renderer.add(range, control));
    return renderer.sums();
}

TEST(PathRenderer, HasTheSameBitsForAnyThreadsAndRanges) {
    const test::TracedScene traced(test::softlyLitScene());
    const ImageSums whole = sumsOf(traced, {{0, 24}});
    EXPECT_EQ(test::samplesOf(whole), 70U * 41 * 24);
    EXPECT_EQ(whole.dropped(), 0U);
    for (const int threads : {2, 7}) EXPECT_TRUE(sumsOf(traced, {{0, 24}}, threads) == whole) << threads;
    EXPECT_TRUE(sumsOf(traced, {{20, 24}, {0, 3}, {3, 20}}, 2) == whole);
    ImageSums merged = sumsOf(traced, {{11, 24}});
    merged.merge(sumsOf(traced, {{0, 11}}));
    EXPECT_TRUE(merged == whole);
    EXPECT_FALSE(sumsOf(traced, {{0, 23}}) == whole);
}

TEST(PathRenderer, DevelopsMeansAndCoverage) {
    const test::TracedScene traced(test::sampleScene());
    const RenderSettings settings = test::sampleSettings(70, 41);
    const Camera camera = test::sampleCamera();
    PathRenderer renderer;
    renderer.begin({traced.scene, traced.tracer, camera, settings}, 1);
    RenderControl control{.threads = 1};
    ASSERT_TRUE(renderer.add({0, 16}, control));
    Frame paths, whitted;
    renderer.develop(paths);
    whitted = test::render(traced, test::sampleSettings(70, 41, 4));
    ASSERT_EQ(paths.covered.size(), whitted.covered.size());
    std::size_t alike = 0;
    for (std::size_t i = 0; i < paths.covered.size(); ++i)
        alike += std::abs(int{paths.covered[i]} - int{whitted.covered[i]}) < 90 ? 1 : 0;
    EXPECT_GT(alike, paths.covered.size() * 95 / 100);
    EXPECT_GT(paths.statistics.total(), 70U * 41 * 16 * 2);
    // The corner shows the background to both.
    EXPECT_NEAR(paths.radiance.pixels.front().r, whitted.radiance.pixels.front().r, 1e-6);
}

TEST(PathRenderer, KeepsHalvesWhereTheErrorOfANetIsEstimated) {
    const test::TracedScene traced(test::softlyLitScene());
    RenderSettings settings = test::sampleSettings(35, 21);
    settings.integrator = Integrator::Path;
    settings.denoise.net = DenoiseNet::Base;
    settings.path.samples = kEstimatedSamples;
    const Camera camera = test::sampleCamera();
    const auto developed = [&](const std::vector<SampleRange>& ranges, int threads) {
        PathRenderer renderer;
        renderer.begin({traced.scene, traced.tracer, camera, settings}, threads);
        RenderControl control{.threads = threads};
        for (const SampleRange& range : ranges) EXPECT_TRUE(renderer.add(range, control));
        Frame frame;
        renderer.develop(frame);
        return frame;
    };
    const Frame whole = developed({{0, 8}}, 1), other = developed({{5, 8}, {0, 5}}, 3);
    ASSERT_FALSE(whole.halves.empty());
    EXPECT_EQ(whole.halves.samples, 8U);
    EXPECT_EQ(whole.halves.firstFraction, 0.5F);
    EXPECT_EQ(whole.halves.first.pixels, other.halves.first.pixels);
    EXPECT_EQ(whole.halves.second.pixels, other.halves.second.pixels);
    EXPECT_NE(whole.halves.first.pixels, whole.halves.second.pixels);
    for (std::size_t i = 0; i < whole.radiance.pixels.size(); ++i) {
        const Colour mean = (whole.halves.first.pixels[i] + whole.halves.second.pixels[i]) * 0.5F;
        EXPECT_NEAR(mean.g, whole.radiance.pixels[i].g, 1e-5F * (1 + mean.g));
    }
    settings.path.samples = kEstimatedSamples - 1;
    EXPECT_TRUE(developed({{0, 8}}, 1).halves.empty()) << "too few";
    settings.path.samples = kEstimatedSamples;
    settings.denoise.mix = false;
    EXPECT_TRUE(developed({{0, 8}}, 1).halves.empty()) << "not wanted";
}

TEST(PathRenderer, StopsWhenItIsTold) {
    const test::TracedScene traced(test::sampleScene());
    const RenderSettings settings = test::sampleSettings(70, 41);
    const Camera camera = test::sampleCamera();
    PathRenderer renderer;
    renderer.begin({traced.scene, traced.tracer, camera, settings}, 1);
    RenderControl control{.threads = 1};
    control.cancel = true;
    EXPECT_FALSE(renderer.add({0, 1000000}, control));
}

TEST(PathRenderer, CountsWhatIsNotFiniteAndAddsNothingOfIt) {
    Scene scene = test::sampleScene();
    scene.lights[0].light.intensity = {std::numeric_limits<float>::max(), 1e30F, 1e38F};
    scene.materials[0].emission = {std::numeric_limits<float>::max(), 0, 0};
    const ImageSums sums = sumsOf(test::TracedScene(std::move(scene)), {{0, 4}});
    EXPECT_EQ(test::samplesOf(sums) + sums.dropped(), 70U * 41 * 4);
    for (const Colour c : test::meanOf(sums).pixels) EXPECT_TRUE(std::isfinite(c.r + c.g + c.b));
}

} // namespace
} // namespace rtcore
