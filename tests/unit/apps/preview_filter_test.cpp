// Images by few paths, as viewers of a preview see them.
#include "renderer/preview_filter.h"

#include "rtcore/render/frame_renderer.h"

#include "unit/neural/made_net.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <cmath>
#include <memory>
#include <random>

namespace renderer {
namespace {

constexpr int kSide = 64, kSamples = 16;
constexpr float kGrey = 0.5F;

/// A grey wall that fills the image, and noise around the light `kGrey`.
class NoisyWall : public testing::Test {
  protected:
    void SetUp() override {
        settings_.integrator = rtcore::Integrator::Path;
        settings_.path.samples = kSamples;
        surfaces_.begin(rtcore::Camera{}, kSide, kSide);
        frame_.radiance = rtcore::HdrImage(kSide, kSide);
        frame_.covered.assign(std::size_t{kSide} * kSide, 255);
        std::mt19937 random(5);
        std::uniform_real_distribution<float> around(0, 2 * kGrey);
        std::vector<rtcore::PrimaryHit> hits;
        std::vector<rtcore::SampleId> samples;
        for (int y = 0; y < kSide; ++y) {
            for (int x = 0; x < kSide; ++x) {
                rtcore::PrimaryHit hit;
                hit.wave = 1;
                hit.position = {static_cast<float>(x - kSide / 2), static_cast<float>(kSide / 2 - y), -40};
                hit.normal = {0, 0, 1};
                hit.albedo = {kGrey, kGrey, kGrey};
                hits.push_back(hit);
                samples.push_back({static_cast<std::uint16_t>(x), static_cast<std::uint16_t>(y), 0});
                const float light = around(random);
                frame_.radiance.at(x, y) = {light, light, light};
            }
        }
        surfaces_.add(hits, samples);
        surfaces_.finish(1);
    }

    const rtcore::Frame& shownAfter(std::uint32_t samples) {
        const bool byNet = rtcore::denoisesByNet(settings_);
        return *filter_.apply({frame_, 1, samples, byNet ? nullptr : &surfaces_,
                               frame_.guides.empty() ? nullptr : &frame_.guides},
                              settings_, 1, stop_);
    }
    static double meanOf(const rtcore::HdrImage& image) {
        double sum = 0;
        for (const rtcore::Colour& pixel : image.pixels) sum += double{pixel.g};
        return sum / static_cast<double>(image.pixels.size());
    }
    static double noiseOf(const rtcore::HdrImage& image) {
        double sum = 0;
        for (const rtcore::Colour& pixel : image.pixels) sum += (pixel.g - kGrey) * (pixel.g - kGrey);
        return std::sqrt(sum / static_cast<double>(image.pixels.size()));
    }

    rtcore::RenderSettings settings_;
    rtcore::Aovs surfaces_;
    rtcore::Frame frame_;
    PreviewFilter filter_;
    std::atomic<bool> stop_{false};
};

TEST_F(NoisyWall, LosesMostOfItsNoiseAtFirst) {
    EXPECT_LT(noiseOf(shownAfter(1).radiance), 0.2 * noiseOf(frame_.radiance));
    EXPECT_EQ(shownAfter(1).covered, frame_.covered);
    EXPECT_NEAR(meanOf(shownAfter(1).radiance), meanOf(frame_.radiance), 0.02 * kGrey)
        << "and none of its light";
}

TEST_F(NoisyWall, GrowsIntoTheImageOfAllSamples) {
    double before = 0;
    for (const std::uint32_t samples : {1U, 4U, 8U, 12U, 16U}) {
        const double noise = noiseOf(shownAfter(samples).radiance);
        EXPECT_GT(noise, before) << samples;
        before = noise;
    }
    EXPECT_NEAR(before, noiseOf(frame_.radiance), 1e-5);
}

TEST_F(NoisyWall, EndsFilteredWhereTheStillIs) {
    settings_.denoise.passes = 4;
    EXPECT_LT(noiseOf(shownAfter(kSamples).radiance), 0.2 * noiseOf(frame_.radiance));
    EXPECT_EQ(std::vector(shownAfter(1).radiance.pixels), shownAfter(kSamples).radiance.pixels)
        << "from the first sample on";
}

TEST_F(NoisyWall, StaysAsItIsWithoutSurfaces) {
    surfaces_.clear();
    EXPECT_EQ(&shownAfter(1), &frame_);
}

TEST_F(NoisyWall, IsDenoisedByTheNetWhereThatIsAskedFor) {
    settings_.denoise.net = rtcore::DenoiseNet::Base;
    const auto net = std::make_shared<const rtcore::UNet>(test::madeNet(9, false), "made.tza");
    EXPECT_EQ(&shownAfter(1), &frame_) << "without guides";
    frame_.guides.albedo = rtcore::HdrImage(kSide, kSide);
    for (rtcore::Colour& albedo : frame_.guides.albedo.pixels) albedo = {kGrey, kGrey, kGrey};
    frame_.guides.normals.assign(frame_.covered.size(), {0, 0, 1});
    frame_.guides.covered = frame_.covered;
    rtcore::NetDenoise whole;
    const rtcore::HdrImage expected = whole.apply(
        frame_.radiance, {}, {.settings = settings_, .threads = 1, .net = net, .guides = &frame_.guides});
    filter_.useNet(net);
    EXPECT_EQ(shownAfter(1).radiance.pixels, expected.pixels);
    filter_.useNet(nullptr);
    EXPECT_EQ(&shownAfter(1), &frame_);
}

TEST(NetPace, GivesTheNetHalfOfTheTime) {
    using namespace std::chrono_literals;
    const NetPace::Clock::time_point start{1h};
    NetPace pace;
    EXPECT_TRUE(pace.due(start));
    pace.ran(start, start + 300ms);
    EXPECT_FALSE(pace.due(start + 599ms));
    EXPECT_TRUE(pace.due(start + 600ms));
}

} // namespace
} // namespace renderer
