// A net works on what the frame holds; the background, and frames without a net, stay.
#include "rtcore/post/effect_chain.h"
#include "rtcore/post/effects.h"
#include "rtcore/post/net_denoise.h"
#include "rtcore/settings/settings_table.h"

#include "sample_view.h"
#include "unit/neural/made_net.h"

#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <memory>
#include <random>
#include <vector>

namespace rtcore {
namespace {

class NetDenoiseTest : public testing::Test {
  protected:
    void SetUp() override {
        settings.integrator = Integrator::Path;
        settings.denoise.net = DenoiseNet::Base;
        test::SceneBuilder b;
        b.sphere({0, 0, 0}, 1, 24, b.material(test::matte(0.7F)));
        b.scene.lights = {test::pointLight({1, 4, 3}, 40)};
        b.scene.background = {0.2F, 0.3F, 0.5F};
        const test::TracedScene traced(b.finish());
        FrameRenderer renderer;
        ASSERT_TRUE(effectsNeedGuides(settings));
        RenderControl control{.threads = 1};
        RenderSettings whitted = settings;
        whitted.integrator = Integrator::Whitted;
        ASSERT_TRUE(
            renderer.render({traced.scene, traced.tracer, test::sampleCamera(), whitted}, control, frame));
        ASSERT_TRUE(renderer.renderGuides({traced.scene, traced.tracer, test::sampleCamera(), settings}, 1,
                                          GuideRays::All, control, frame.guides));
    }

    RenderSettings settings = test::sampleSettings(48, 36);
    Frame frame;
    const std::shared_ptr<const UNet> net = std::make_shared<const UNet>(test::madeNet(9, false), "made.tza");
};

TEST_F(NetDenoiseTest, GivesSurfacesWhatTheNetGivesAndLeavesTheBackground) {
    NetDenoise effect;
    const HdrImage& result = effect.apply(
        frame.radiance, {}, {.settings = settings, .threads = 1, .net = net, .guides = &frame.guides});
    ASSERT_NE(&result, &frame.radiance);
    std::vector<float> radiance, albedo, normal, expected(frame.radiance.pixels.size() * 3);
    for (std::size_t i = 0; i < frame.radiance.pixels.size(); ++i) {
        const Colour c = frame.radiance.pixels[i], a = frame.guides.albedo.pixels[i];
        const Vec3 n = frame.guides.normals[i];
        radiance.insert(radiance.end(), {c.r, c.g, c.b});
        albedo.insert(albedo.end(), {a.r, a.g, a.b});
        normal.insert(normal.end(), {n.x, n.y, n.z});
    }
    NetDenoiser denoiser(net);
    ASSERT_TRUE(
        denoiser.run({48, 36, {radiance.data()}, {albedo.data()}, {normal.data()}}, expected.data(), 1));
    int surfaces = 0, background = 0;
    for (std::size_t i = 0; i < result.pixels.size(); ++i) {
        if (frame.guides.covered[i] == 0) {
            EXPECT_EQ(result.pixels[i], frame.radiance.pixels[i]);
            ++background;
        } else {
            EXPECT_EQ(result.pixels[i], (Colour{expected[3 * i], expected[3 * i + 1], expected[3 * i + 2]}));
            ++surfaces;
        }
    }
    EXPECT_GT(surfaces, 100);
    EXPECT_GT(background, 100);
}

TEST_F(NetDenoiseTest, DenoisesOutlinesThatSamplesHitAndTheRaysOfGuidesDoNot) {
    ASSERT_EQ(frame.guides.covered[0], 0);
    const auto first = [&] {
        return EffectChain().apply(frame, {.settings = settings, .threads = 1, .net = net}).pixels[0];
    };
    frame.covered[0] = 0;
    EXPECT_EQ(first(), frame.radiance.pixels[0]) << "background";
    frame.covered[0] = 64;
    EXPECT_NE(first(), frame.radiance.pixels[0]);
}

TEST_F(NetDenoiseTest, LeavesTheImageWithoutANetGuidesOrTime) {
    NetDenoise effect;
    const Guides& guides = frame.guides;
    EXPECT_EQ(&effect.apply(frame.radiance, {}, {.settings = settings, .guides = &guides}), &frame.radiance);
    EXPECT_EQ(&effect.apply(frame.radiance, {}, {.settings = settings, .net = net}), &frame.radiance);
    const HdrImage other(47, 36);
    EXPECT_EQ(&effect.apply(other, {}, {.settings = settings, .net = net, .guides = &guides}), &other);
    const std::atomic<bool> stop = true;
    EXPECT_EQ(&effect.apply(frame.radiance, {},
                            {.settings = settings, .net = net, .guides = &guides, .stop = &stop}),
              &frame.radiance);
}

/// Halves that are the frame's radiance with noise.
SampleHalves noisyHalves(const HdrImage& radiance) {
    SampleHalves halves{.first = radiance, .second = radiance, .samples = kMixedSamples};
    std::mt19937 random(4);
    for (std::size_t i = 0; i < radiance.pixels.size(); ++i) {
        const float noise = 0.2F * static_cast<float>(random() % 1000) / 1000;
        halves.first.pixels[i] = radiance.pixels[i] * (1 + noise);
        halves.second.pixels[i] = radiance.pixels[i] * (1 - noise);
    }
    return halves;
}

TEST_F(NetDenoiseTest, MixesWhereTheFrameHasHalves) {
    frame.halves = noisyHalves(frame.radiance);
    frame.halves.first.at(24, 18) = kWhite * 1000.0F;
    const HdrImage before = frame.radiance;
    HdrImage one;
    for (const int threads : {1, 2, 3}) {
        NetReport report;
        std::vector<float> errors;
        std::atomic<float> fraction = 0;
        EffectChain chain;
        const HdrImage& result = chain.apply(frame, {.settings = settings,
                                                     .threads = threads,
                                                     .net = net,
                                                     .netReport = &report,
                                                     .netErrors = &errors,
                                                     .netFraction = &fraction});
        if (threads == 1) one = result;
        EXPECT_EQ(result.pixels, one.pixels) << threads;
        EXPECT_TRUE(report.ran && report.estimated && report.mixed);
        ASSERT_EQ(errors.size(), frame.radiance.pixels.size());
        EXPECT_EQ(errors.front(), 0) << "background";
        EXPECT_LE(*std::ranges::max_element(errors), 8 * report.largestError);
        EXPECT_EQ(fraction, 1);
        EXPECT_GT(report.error, 0);
        EXPECT_GE(report.largestError, report.error);
        EXPECT_EQ(report.dots, 1U);
        EXPECT_GT(report.lightOfDots, 0.1F);
    }
    EXPECT_EQ(frame.radiance.pixels, before.pixels);
    EXPECT_EQ(one.at(0, 0), frame.radiance.at(0, 0)) << "background";
}

TEST_F(NetDenoiseTest, MixesNoFewSamplesAndEstimatesNothingOfFewerOrWhereItIsNotToldTo) {
    NetDenoise effect;
    const HdrImage alone = effect.apply(
        frame.radiance, {}, {.settings = settings, .threads = 1, .net = net, .guides = &frame.guides});
    SampleHalves halves = noisyHalves(frame.radiance);
    NetReport report;
    const auto apply = [&] {
        return effect.apply(frame.radiance, {},
                            {.settings = settings,
                             .threads = 1,
                             .net = net,
                             .guides = &frame.guides,
                             .halves = &halves,
                             .netReport = &report});
    };
    EXPECT_NE(apply().pixels, alone.pixels);
    EXPECT_TRUE(report.mixed);
    halves.samples = kMixedSamples - 1;
    EXPECT_EQ(apply().pixels, alone.pixels);
    EXPECT_TRUE(report.ran && report.estimated);
    EXPECT_FALSE(report.mixed);
    EXPECT_GT(report.error, 0);
    halves.samples = kEstimatedSamples - 1;
    EXPECT_EQ(apply().pixels, alone.pixels);
    EXPECT_TRUE(report.ran);
    EXPECT_FALSE(report.estimated || report.mixed);
    halves.samples = kMixedSamples;
    settings.denoise.mix = false;
    EXPECT_EQ(apply().pixels, alone.pixels);
}

TEST_F(NetDenoiseTest, MixesASteadyImageWhereTheSettingsWantIt) {
    const HdrImage alone = EffectChain().apply(frame, {.settings = settings, .threads = 1, .net = net});
    frame.steady = frame.radiance;
    const auto apply = [&] {
        return EffectChain().apply(frame, {.settings = settings, .threads = 2, .net = net});
    };
    EXPECT_EQ(apply().pixels, alone.pixels) << "indirect light is off";
    settings.indirect.mode = IndirectMode::Live;
    const Colour byNet = alone.at(24, 18), steady = frame.steady.at(24, 18);
    EXPECT_FLOAT_EQ(apply().at(24, 18).g, (byNet.g + steady.g) / 2) << "evenly without halves";
    frame.halves = noisyHalves(frame.radiance);
    frame.halves.samples = kSteadySamples;
    const HdrImage mixed = apply();
    EXPECT_LT(std::abs(mixed.at(24, 18).g - steady.g), std::abs(byNet.g - steady.g)) << "by the halves";
    EXPECT_EQ(mixed.at(0, 0), frame.radiance.at(0, 0)) << "background";
    settings.denoise.mix = false;
    EXPECT_EQ(apply().pixels, alone.pixels);
    settings.denoise.mix = true;
    frame.steady = HdrImage(47, 36);
    frame.halves = {};
    EXPECT_EQ(apply().pixels, alone.pixels) << "of another size";
}

TEST_F(NetDenoiseTest, StandsInPlaceOfTheFilterForPathsOnly) {
    settings.denoise.passes = 3;
    EXPECT_EQ(netOf(settings), Net::Base);
    EXPECT_EQ(filterPasses(settings), 0);
    settings.denoise.net = DenoiseNet::Small;
    EXPECT_EQ(netOf(settings), Net::Small);
    settings.denoise.net = DenoiseNet::Large;
    EXPECT_EQ(netOf(settings), Net::Large);
    settings.integrator = Integrator::Whitted;
    EXPECT_EQ(netOf(settings), std::nullopt);
    EXPECT_EQ(filterPasses(settings), 3);
    settings.integrator = Integrator::Path;
    settings.denoise.net = DenoiseNet::Off;
    EXPECT_EQ(netOf(settings), std::nullopt);
    EXPECT_EQ(filterPasses(settings), 3);
}

TEST(NetSetting, IsForStills) {
    RenderSettings settings;
    EXPECT_NO_THROW(checkLive(settings));
    setSettingFromText(settings, "denoise.net", "small");
    EXPECT_THROW(checkLive(settings), BadValue);
}

} // namespace
} // namespace rtcore
