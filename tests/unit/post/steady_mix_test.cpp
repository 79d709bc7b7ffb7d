// A net's image that is mixed with a steady one flickers less, is as good as the better of both or better,
// and is the net's where the steady image is wrong.
#include "rtcore/post/steady_mix.h"

#include "rtcore/settings/render_settings.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <vector>

namespace rtcore {
namespace {

constexpr int kSteadyWidth = 96, kSteadyHeight = 64;

/// A smooth pattern of blots some 8 pixels wide, as nets leave them.
class Blots {
  public:
    Blots(float size, std::mt19937& random) {
        std::normal_distribution<float> normal;
        for (float& each : at_) each = size * normal(random);
    }
    float operator()(int x, int y) const {
        const float u = static_cast<float>(x) / kSide, v = static_cast<float>(y) / kSide;
        const int i = static_cast<int>(u), j = static_cast<int>(v);
        const float s = u - static_cast<float>(i), t = v - static_cast<float>(j);
        return (knot(i, j) * (1 - s) + knot(i + 1, j) * s) * (1 - t) +
               (knot(i, j + 1) * (1 - s) + knot(i + 1, j + 1) * s) * t;
    }

  private:
    static constexpr int kSide = 8, kColumns = kSteadyWidth / kSide + 2, kRows = kSteadyHeight / kSide + 2;
    float knot(int i, int j) const { return at_[static_cast<std::size_t>(j * kColumns + i)]; }
    std::vector<float> at_ = std::vector<float>(static_cast<std::size_t>(kColumns) * kRows);
};

/// A truth, samples of it with noise, images that a net made of them with blots of its own, and a steady one.
struct MadeSteady {
    HdrImage truth{kSteadyWidth, kSteadyHeight}, steady{truth}, sampled{truth}, all{truth}, first{truth},
        second{truth};
    SampleHalves halves;
    std::vector<PixelCoverage> coverage =
        std::vector<PixelCoverage>(truth.pixels.size(), PixelCoverage::Full);

    /// `noise` and `blots`: standard deviations of samples and of the net's image as fractions of the truth.
    MadeSteady(float noise, float blots, unsigned seed) {
        halves.first = halves.second = truth;
        halves.samples = 16;
        std::mt19937 random(seed);
        std::normal_distribution<float> normal;
        const float apart = std::sqrt(2.0F);
        const Blots a(blots * apart, random), b(blots * apart, random);
        for (int y = 0; y < kSteadyHeight; ++y) {
            for (int x = 0; x < kSteadyWidth; ++x) {
                const float light = 0.5F + 0.4F * std::sin(static_cast<float>(x + 2 * y) / 20);
                truth.at(x, y) = steady.at(x, y) = kWhite * light;
                halves.first.at(x, y) = kWhite * (light * (1 + apart * noise * normal(random)));
                halves.second.at(x, y) = kWhite * (light * (1 + apart * noise * normal(random)));
                sampled.at(x, y) = (halves.first.at(x, y) + halves.second.at(x, y)) * 0.5F;
                first.at(x, y) = kWhite * (light * (1 + a(x, y)));
                second.at(x, y) = kWhite * (light * (1 + b(x, y)));
                all.at(x, y) = (first.at(x, y) + second.at(x, y)) * 0.5F;
            }
        }
    }

    void mix(int threads = 1) {
        mixWithSteady({sampled, steady, halves, coverage}, {all, first, second}, threads);
    }
};

/// Root mean square of the difference within columns, in proportion to the truth.
double apartWithin(const HdrImage& truth, const HdrImage& image, int left, int right) {
    double sum = 0;
    for (int y = 0; y < kSteadyHeight; ++y) {
        for (int x = left; x < right; ++x)
            sum += std::pow((image.at(x, y).g - truth.at(x, y).g) / truth.at(x, y).g, 2);
    }
    return std::sqrt(sum / (kSteadyHeight * static_cast<double>(right - left)));
}
double apart(const HdrImage& truth, const HdrImage& image) {
    return apartWithin(truth, image, 0, kSteadyWidth);
}

TEST(SteadyMix, TakesTheBlotsAndTheirFlickerAwayWhereTheSteadyImageIsRight) {
    MadeSteady one(0.3F, 0.05F, 1), other(0.3F, 0.05F, 2);
    const double error = apart(one.truth, one.all), flicker = apart(one.all, other.all);
    one.mix();
    other.mix();
    EXPECT_LT(apart(one.truth, one.all), 0.4 * error);
    EXPECT_LT(apart(one.all, other.all), 0.4 * flicker);
}

// As the light of a lens that falls on a wall, or what a mirror shows.
TEST(SteadyMix, IsTheNetsImageWhereTheSteadyOneLacksLight) {
    MadeSteady made(0.3F, 0.02F, 3);
    for (int y = 0; y < kSteadyHeight; ++y) {
        for (int x = 40; x < 72; ++x) made.steady.at(x, y) = made.truth.at(x, y) * 0.3F;
    }
    const HdrImage net = made.all;
    made.mix();
    EXPECT_LT(apartWithin(made.truth, made.all, 44, 68), 1.1 * apartWithin(made.truth, net, 44, 68));
    EXPECT_LT(apartWithin(net, made.all, 44, 68), 0.01) << "of 0.7";
    EXPECT_LT(apart(made.truth, made.all), 1.1 * apart(made.truth, net));
}

TEST(SteadyMix, IsNoWorseThanTheBetterOfBothInBetween) {
    MadeSteady made(0.1F, 0.05F, 4);
    std::mt19937 random(5);
    const Blots wrong(0.05F, random);
    for (int y = 0; y < kSteadyHeight; ++y) {
        for (int x = 0; x < kSteadyWidth; ++x) made.steady.at(x, y) = made.truth.at(x, y) * (1 + wrong(x, y));
    }
    const double net = apart(made.truth, made.all), steady = apart(made.truth, made.steady);
    made.mix();
    EXPECT_LT(apart(made.truth, made.all), 0.9 * std::min(net, steady));
}

TEST(SteadyMix, IsTheSampledImageToTheBitOnceThatIsExactToADisplay) {
    MadeSteady made(0.0003F, 0.05F, 6);
    for (Colour& pixel : made.steady.pixels) pixel = pixel * 1.1F;
    made.halves.samples = kMixedSamples;
    made.mix();
    HdrImage shown;
    mixWithNet({made.sampled, made.all, made.halves, made.first, made.second, made.coverage}, shown, 1);
    EXPECT_EQ(shown.pixels, made.sampled.pixels);
}

TEST(SteadyMix, LeavesBackgroundAndWhatIsNotFinite) {
    MadeSteady made(0.3F, 0.05F, 7);
    made.coverage[100] = PixelCoverage::None;
    made.steady.pixels[101].g = std::numeric_limits<float>::quiet_NaN();
    made.steady.pixels[102].r = std::numeric_limits<float>::infinity();
    const HdrImage net = made.all;
    made.mix();
    for (const std::size_t i : {100U, 101U, 102U}) EXPECT_EQ(made.all.pixels[i], net.pixels[i]);
    for (std::size_t i = 0; i < net.pixels.size(); ++i) {
        EXPECT_TRUE(isFinite(made.all.pixels[i]));
        EXPECT_TRUE(i < 103 || made.all.pixels[i] != net.pixels[i]);
    }
}

TEST(SteadyMix, HasTheSameBitsForAnyThreads) {
    MadeSteady one(0.3F, 0.05F, 8);
    one.mix();
    for (const int threads : {2, 3}) {
        MadeSteady made(0.3F, 0.05F, 8);
        made.mix(threads);
        EXPECT_EQ(made.all.pixels, one.all.pixels) << threads;
        EXPECT_EQ(made.first.pixels, one.first.pixels) << threads;
        EXPECT_EQ(made.second.pixels, one.second.pixels) << threads;
    }
}

TEST(SteadyMix, LeavesAnImageWithoutSurfacesOrDifferences) {
    MadeSteady made(0.3F, 0.05F, 9);
    made.all = made.first = made.second = made.steady;
    made.mix();
    EXPECT_EQ(made.all.pixels, made.steady.pixels);
    MadeSteady empty(0.3F, 0.05F, 9);
    empty.coverage.assign(empty.coverage.size(), PixelCoverage::None);
    const HdrImage net = empty.all;
    empty.mix();
    EXPECT_EQ(empty.all.pixels, net.pixels);
}

TEST(SteadyMix, IsTheMeanOfBothByTooFewSamples) {
    MadeSteady made(0.3F, 0.05F, 10);
    made.coverage[7] = PixelCoverage::None;
    const HdrImage net = made.all;
    mixEvenly(made.steady, made.coverage, made.all, 2);
    EXPECT_EQ(made.all.pixels[7], net.pixels[7]);
    EXPECT_FLOAT_EQ(made.all.pixels[8].g, (net.pixels[8].g + made.steady.pixels[8].g) / 2);
}

} // namespace
} // namespace rtcore
