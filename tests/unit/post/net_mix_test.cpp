// A mixed image is the net's where that is right, the sampled one where that is exact, and its error is
// known.
#include "rtcore/post/net_mix.h"

#include "rtcore/neural/transfer.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

namespace rtcore {
namespace {

constexpr int kMixWidth = 96, kMixHeight = 64;

/// A truth with soft shades, and images of it with noise and with the faults of a made-up net.
struct MadeImages {
    HdrImage truth{kMixWidth, kMixHeight}, sampled{truth}, net{truth}, netFirst{truth}, netSecond{truth};
    SampleHalves halves;
    std::vector<PixelCoverage> coverage;

    /// `noise`: standard deviation of the sampled image, as a fraction of the truth; `fault`: of the net's
    /// images, a pattern that is in all three.
    MadeImages(float noise, float fault) : coverage(truth.pixels.size(), PixelCoverage::Full) {
        halves.first = halves.second = truth;
        halves.samples = 64;
        std::mt19937 random(3);
        std::normal_distribution<float> normal;
        for (int y = 0; y < kMixHeight; ++y) {
            for (int x = 0; x < kMixWidth; ++x) {
                const float light = 0.5F + 0.4F * std::sin(static_cast<float>(x + 2 * y) / 20);
                const float half = std::sqrt(2.0F) * noise * light;
                const Colour at = kWhite * light;
                truth.at(x, y) = at;
                halves.first.at(x, y) = at + kWhite * (half * normal(random));
                halves.second.at(x, y) = at + kWhite * (half * normal(random));
                sampled.at(x, y) = (halves.first.at(x, y) + halves.second.at(x, y)) * 0.5F;
                const Colour wrong = kWhite * (light * fault * ((x / 2 + y / 2) % 2 == 0 ? 1.0F : -1.0F));
                net.at(x, y) = netFirst.at(x, y) = netSecond.at(x, y) = at + wrong;
            }
        }
    }

    EstimatedError mix(HdrImage& shown, int threads = 1) const {
        return mixWithNet({sampled, net, halves, netFirst, netSecond, coverage}, shown, threads);
    }
};

/// Root mean square of the difference, in proportion to the truth.
double errorBeside(const HdrImage& truth, const HdrImage& image) {
    double sum = 0;
    for (std::size_t i = 0; i < truth.pixels.size(); ++i)
        sum += std::pow((image.pixels[i].g - truth.pixels[i].g) / truth.pixels[i].g, 2);
    return std::sqrt(sum / static_cast<double>(truth.pixels.size()));
}

/// The same in codes of 255, as the exposure of `exposed` shows them.
double codesBeside(const HdrImage& truth, const HdrImage& image, const HdrImage& exposed) {
    const float scale = exposureForNet({&exposed.pixels[0].r}, kMixWidth, kMixHeight, 1);
    const auto code = [&](float light) {
        const float x = std::max(light, 0.0F) * scale;
        return 255 * static_cast<double>(srgbEncode(x / (1 + x)));
    };
    double sum = 0;
    for (std::size_t i = 0; i < truth.pixels.size(); ++i)
        sum += std::pow(code(image.pixels[i].g) - code(truth.pixels[i].g), 2);
    return std::sqrt(sum / static_cast<double>(truth.pixels.size()));
}

TEST(NetMix, IsTheNetsImageWhereThatIsRight) {
    const MadeImages made(0.2F, 0);
    HdrImage shown;
    made.mix(shown);
    EXPECT_LT(errorBeside(made.truth, shown), 0.02);
    EXPECT_GT(errorBeside(made.truth, made.sampled), 0.19);
}

TEST(NetMix, IsTheSampledImageWhereTheNetIsWrong) {
    const MadeImages made(0.02F, 0.5F);
    HdrImage shown;
    made.mix(shown);
    EXPECT_LT(errorBeside(made.truth, shown), 0.025);
}

TEST(NetMix, IsNoWorseThanEitherInBetween) {
    const MadeImages made(0.1F, 0.1F);
    HdrImage shown;
    made.mix(shown);
    EXPECT_LT(errorBeside(made.truth, shown), 0.085) << "0.0707 is the best that can be done";
}

TEST(NetMix, NearsTheSampledImageAsItsNoiseFallsAndIsItInTheEnd) {
    double before = 1;
    for (const float noise : {0.1F, 0.03F, 0.01F, 0.003F}) {
        const MadeImages made(noise, 0.1F);
        HdrImage shown;
        made.mix(shown);
        const double apart = errorBeside(made.sampled, shown);
        EXPECT_LT(apart, before) << noise;
        before = apart;
    }
    const MadeImages exact(0.0003F, 0.1F);
    HdrImage shown;
    exact.mix(shown);
    EXPECT_EQ(shown.pixels, exact.sampled.pixels) << "to the bit";
}

// Where no sample of nine pixels has found the rare light that those around have found, they have no noise.
TEST(NetMix, TakesNoPixelsForExactThatMissedRareLight) {
    MadeImages made(0.3F, 0);
    for (int y = 30; y < 33; ++y) {
        for (int x = 40; x < 43; ++x)
            made.sampled.at(x, y) = made.halves.first.at(x, y) = made.halves.second.at(x, y) =
                made.truth.at(x, y) * 0.3F;
    }
    HdrImage shown;
    made.mix(shown);
    EXPECT_GT(shown.at(41, 31).g, 0.9F * made.truth.at(41, 31).g);
}

TEST(NetMix, EstimatesItsError) {
    struct Case {
        float noise, fault;
    };
    for (const auto& [noise, fault] :
         {Case{0.2F, 0.1F}, Case{0.1F, 0.1F}, Case{0.1F, 0.3F}, Case{0.02F, 0.3F}}) {
        const MadeImages made(noise, fault);
        HdrImage shown;
        const EstimatedError error = made.mix(shown);
        const double ratio = codesBeside(made.truth, shown, made.sampled) / static_cast<double>(error.all);
        EXPECT_GT(ratio * ratio, 0.5) << noise << ' ' << fault;
        EXPECT_LT(ratio * ratio, 2) << noise << ' ' << fault;
        EXPECT_GE(error.largestBlock, error.all);
    }
}

TEST(NetMix, TakesBackgroundAsItIs) {
    MadeImages made(0.2F, 0.1F);
    made.coverage[100] = PixelCoverage::None;
    HdrImage shown;
    made.mix(shown);
    EXPECT_EQ(shown.pixels[100], made.sampled.pixels[100]);
    EXPECT_NE(shown.pixels[101], made.sampled.pixels[101]);
}

// Where a net is wrong at an outline alone, it is as good beside it as it was.
TEST(NetMix, PoolsPixelsThatAreCoveredAlike) {
    MadeImages made(0.1F, 0);
    MadeImages right(0.1F, 0);
    for (int y = 0; y < kMixHeight; ++y) {
        const auto i = static_cast<std::size_t>(y * kMixWidth + 40);
        made.coverage[i] = right.coverage[i] = PixelCoverage::Part;
        made.net.pixels[i] = made.netFirst.pixels[i] = made.netSecond.pixels[i] = kWhite * 9.0F;
    }
    HdrImage shown, expected;
    made.mix(shown);
    right.mix(expected);
    for (int y = 0; y < kMixHeight; ++y) {
        EXPECT_EQ(shown.at(41, y), expected.at(41, y));
        EXPECT_LT(shown.at(40, y).g, 1.5F) << "mixed nearly away";
    }
}

TEST(NetMix, HasTheSameBitsForAnyThreadsAndInPlace) {
    const MadeImages made(0.1F, 0.1F);
    HdrImage one;
    const EstimatedError error = made.mix(one);
    for (const int threads : {2, 3}) {
        HdrImage shown = made.net;
        const EstimatedError other = mixWithNet(
            {made.sampled, shown, made.halves, made.netFirst, made.netSecond, made.coverage}, shown, threads);
        EXPECT_EQ(shown.pixels, one.pixels) << threads;
        EXPECT_EQ(other.all, error.all);
        EXPECT_EQ(other.largestBlock, error.largestBlock);
    }
}

} // namespace
} // namespace rtcore
