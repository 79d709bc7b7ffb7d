// With all patterns, with lenses and by adaptive sampling, the image is the same in any order of work.
#include "rtcore/render/adaptive_sampler.h"
#include "rtcore/render/refinement.h"
#include "rtcore/simd/instruction_set.h"

#include "sample_view.h"
#include "support/one_frame.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

namespace rtcore {
namespace {

constexpr SamplingPattern kPatterns[] = {SamplingPattern::Grid, SamplingPattern::Random,
                                         SamplingPattern::Jittered, SamplingPattern::Rotated,
                                         SamplingPattern::Poisson};

/// All kinds, one after another.
std::vector<RenderSettings> manySettings(int width, int height) {
    std::vector<RenderSettings> all;
    for (const SamplingPattern pattern : kPatterns) {
        for (const int antialiasing : {1, 3}) {
            RenderSettings settings = test::sampleSettings(width, height, antialiasing);
            settings.sampling = pattern;
            all.push_back(settings);
            settings.depthOfField = {
                .on = true, .fNumber = .2F, .focus = 6, .blades = antialiasing == 1 ? 0 : 5};
            if (pattern != SamplingPattern::Random) settings.adaptive = .05F;
            all.push_back(settings);
        }
    }
    return all;
}

TEST(Sampling, TheSameBitsForAnyNumberOfThreads) {
    const test::TracedScene s(test::sampleScene());
    FrameRenderer renderer; // keeps what it knows from frame to frame
    RenderControl control{.threads = 3};
    Frame frame;
    for (const RenderSettings& settings : manySettings(73, 67)) {
        const Frame expected = test::render(s, settings, 1);
        ASSERT_TRUE(renderer.render({s.scene, s.tracer, test::sampleCamera(), settings}, control, frame));
        EXPECT_EQ(frame.radiance.pixels, expected.radiance.pixels);
        EXPECT_EQ(frame.covered, expected.covered);
        EXPECT_EQ(frame.statistics.rays, expected.statistics.rays);
    }
}

TEST(Sampling, TheSameBitsOnEachInstructionSet) {
    const test::TracedScene s(test::sampleScene());
    for (const RenderSettings& settings : manySettings(33, 18)) {
        ASSERT_TRUE(useInstructionSet("scalar"));
        const Frame expected = test::render(s, settings);
        for (const std::string& name : instructionSets()) {
            ASSERT_TRUE(useInstructionSet(name));
            EXPECT_EQ(test::render(s, settings).radiance.pixels, expected.radiance.pixels) << name;
        }
        useInstructionSet("auto");
    }
}

TEST(Sampling, RefinementEndsWithTheSamePicture) {
    const test::TracedScene s(test::sampleScene());
    FrameRenderer renderer;
    Refinement refinement;
    for (const RenderSettings& settings : manySettings(33, 18)) {
        RenderControl control{.threads = 2};
        Frame frame;
        int pixels = 0;
        ASSERT_TRUE(refinement.render(renderer, {s.scene, s.tracer, test::sampleCamera(), settings}, control,
                                      frame, [](const RefinementPass&, const Frame&) {}));
        EXPECT_EQ(frame.radiance.pixels, test::render(s, settings).radiance.pixels);
        for (const PixelArea& area : refinement.finishedTiles().take()) pixels += area.columns * area.rows;
        EXPECT_EQ(pixels, 33 * 18);
        EXPECT_NEAR(refinement.fraction(control), 1, 1e-6);
    }
}

/// The general way from names to pixels gives what the short one for grids does.
TEST(Sampling, AClosedLensChangesNothing) {
    const test::TracedScene s(test::sampleScene());
    for (const int antialiasing : {1, 4}) {
        RenderSettings settings = test::sampleSettings(101, 67, antialiasing);
        const Frame plain = test::render(s, settings);
        settings.depthOfField = {.on = true, .fNumber = 1000, .focus = 6};
        const Frame small = test::render(s, settings);
        int different = 0;
        for (std::size_t i = 0; i < plain.radiance.pixels.size(); ++i) {
            const Colour a = plain.radiance.pixels[i], b = small.radiance.pixels[i];
            if (std::fabs(a.g - b.g) > 2e-3F * (1 + a.g)) ++different;
        }
        EXPECT_LE(different, 101 * 67 / 100);
        EXPECT_EQ(plain.statistics.rays[0], small.statistics.rays[0]);
    }
}

double errorOf(const Frame& frame, const Frame& reference) {
    double sum = 0;
    for (std::size_t i = 0; i < frame.radiance.pixels.size(); ++i) {
        const auto shown = [](Colour c) { return std::sqrt(static_cast<double>(c.g / (c.g + .3F))); };
        const double error = shown(frame.radiance.pixels[i]) - shown(reference.radiance.pixels[i]);
        sum += error * error;
    }
    return std::sqrt(sum / static_cast<double>(frame.radiance.pixels.size()));
}

TEST(Sampling, AllPatternsComeToTheSamePicture) {
    const test::TracedScene s(test::sampleScene());
    const Frame reference = test::render(s, test::sampleSettings(60, 45, 16), 2);
    const double coarse = errorOf(test::render(s, test::sampleSettings(60, 45, 1)), reference);
    for (const SamplingPattern pattern : kPatterns) {
        RenderSettings settings = test::sampleSettings(60, 45, 6);
        settings.sampling = pattern;
        const double error = errorOf(test::render(s, settings, 2), reference);
        EXPECT_LT(error, coarse / (pattern == SamplingPattern::Random ? 4 : 7)) << static_cast<int>(pattern);
        settings.antialiasing = 1;
        EXPECT_LT(errorOf(test::render(s, settings), reference), 2 * coarse);
    }
}

TEST(AdaptiveSampler, TheFirstSamplesAreSpreadEvenly) {
    for (int n = 1; n <= 16; ++n) {
        int count = 0;
        std::set<std::uint32_t> squares;
        for (int sub = 0; sub < n * n; ++sub) {
            if (!isFirstSample(static_cast<std::uint32_t>(sub), n)) continue;
            ++count;
            squares.insert(static_cast<std::uint32_t>(sub / n / 2 * 100 + sub % n / 2));
        }
        EXPECT_EQ(count, firstSamples(n)) << n;
        EXPECT_EQ(squares.size(), static_cast<std::size_t>(count)) << n;
    }
    std::set<int> columns, rows;
    for (int sub = 0; sub < 16; ++sub) {
        if (!isFirstSample(static_cast<std::uint32_t>(sub), 4)) continue;
        columns.insert(sub % 4);
        rows.insert(sub / 4);
    }
    EXPECT_EQ(columns.size(), 4U);
    EXPECT_EQ(rows.size(), 4U);
}

TEST(Adaptive, SavesSamplesAndKeepsTheEdges) {
    const test::TracedScene s(test::sampleScene());
    const Frame reference = test::render(s, test::sampleSettings(120, 90, 10), 2);
    RenderSettings settings = test::sampleSettings(120, 90, 4);
    settings.sampling = SamplingPattern::Rotated;
    const Frame all = test::render(s, settings, 2);
    settings.antialiasing = 2;
    const Frame quarter = test::render(s, settings, 2);
    settings.antialiasing = 4;
    settings.adaptive = .05F;
    const Frame refined = test::render(s, settings, 2);
    const double samples = static_cast<double>(refined.statistics.rays[0]) / (120 * 90 * 16);
    EXPECT_LT(samples, .6);
    EXPECT_GT(samples, .25);
    EXPECT_LT(errorOf(refined, reference), 1.2 * errorOf(all, reference));
    EXPECT_LT(errorOf(refined, reference), .6 * errorOf(quarter, reference));
}

TEST(Adaptive, ASmallEnoughErrorTakesAllSamples) {
    test::SceneBuilder b;
    b.scene.background = {1, 2, 3};
    const test::TracedScene empty(b.finish());
    RenderSettings settings = test::sampleSettings(40, 30, 4);
    settings.adaptive = 1;
    Frame frame = test::render(empty, settings);
    EXPECT_EQ(frame.statistics.rays[0], 40U * 30 * 4) << "nothing differs";
    for (const Colour c : frame.radiance.pixels) EXPECT_EQ(c, (Colour{1, 2, 3}));

    const test::TracedScene s(test::sampleScene());
    settings.adaptive = 1e-30F;
    frame = test::render(s, settings);
    RenderSettings full = settings;
    full.adaptive = 0;
    const Frame expected = test::render(s, full);
    int different = 0;
    for (std::size_t i = 0; i < frame.radiance.pixels.size(); ++i) {
        // Sums in another order; and the plain background is alike everywhere.
        if (std::fabs(frame.radiance.pixels[i].g - expected.radiance.pixels[i].g) > 1e-4F) ++different;
    }
    EXPECT_EQ(different, 0);
    EXPECT_EQ(frame.covered, expected.covered);
}

TEST(Adaptive, ChoosesTheSameWhateverTheExposure) {
    // A .cam fixes the exposure that the live view had reached.
    test::SceneBuilder b;
    b.quad({-100, -100, -1}, {0.01F, -100, -1}, {0.01F, 100, -1}, {-100, 100, -1},
           b.material(test::emitter({1e-4F, 1e-4F, 1e-4F})));
    const test::TracedScene s(b.finish());
    RenderSettings settings = test::sampleSettings(40, 30, 4);
    settings.adaptive = .05F;
    const Frame automatic = test::render(s, settings);
    EXPECT_GT(automatic.statistics.rays[0], 40U * 30 * 4);
    settings.exposure.mode = ExposureMode::Fixed;
    for (const float value : {1e-6F, 1e-4F, 1.0F}) {
        settings.exposure.value = value;
        const Frame fixed = test::render(s, settings);
        EXPECT_EQ(fixed.statistics.rays[0], automatic.statistics.rays[0]);
        EXPECT_EQ(fixed.radiance.pixels, automatic.radiance.pixels);
    }
}

TEST(Adaptive, StopsWhenItIsTold) {
    const test::TracedScene s(test::sampleScene());
    RenderSettings settings = test::sampleSettings(64, 64, 4);
    settings.adaptive = .1F;
    Frame frame;
    RenderControl control{.threads = 2};
    control.cancel = true;
    EXPECT_FALSE(test::renderFrame({s.scene, s.tracer, test::sampleCamera(), settings}, control, frame));
}

} // namespace
} // namespace rtcore
