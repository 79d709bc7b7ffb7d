#include "rtcore/post/exposure.h"

#include "rtcore/post/develop.h"
#include "support/one_frame.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace rtcore {
namespace {

constexpr float kInf = std::numeric_limits<float>::infinity();
constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr double kBin = 1.0 / 256; ///< relative width of the histogram's bins: what a result may be off by

Colour grey(float y) { return {y, y, y}; }

/// An image by luminances and weights.
struct Pixels {
    std::vector<Colour> colours;
    std::vector<std::uint8_t> weights;

    Pixels& add(int count, Colour colour, std::uint8_t weight = 255) {
        colours.insert(colours.end(), static_cast<std::size_t>(count), colour);
        weights.insert(weights.end(), static_cast<std::size_t>(count), weight);
        return *this;
    }
    std::optional<float> average() const {
        LuminanceHistogram histogram;
        histogram.count(colours, weights);
        return histogram.logAverage();
    }
};

TEST(LogAverage, DropsBlackPixelsAndATenthAtEachEnd) {
    const auto average = Pixels().add(60, {}).add(38, grey(1)).add(2, grey(1e6F)).average();
    ASSERT_TRUE(average.has_value());
    EXPECT_NEAR(*average, 1, kBin);
}

TEST(LogAverage, IsTheGeometricMean) {
    EXPECT_NEAR(*Pixels().add(50, grey(0.01F)).add(50, grey(100)).average(), 1, kBin);
    EXPECT_NEAR(*Pixels().add(1, grey(0.18F)).average(), 0.18, 0.18 * kBin);
    for (const float y : {1e-38F, 1e-6F, 3.0F, 1e30F}) {
        EXPECT_NEAR(*Pixels().add(10, grey(y)).average() / y, 1, kBin) << y;
    }
}

TEST(LogAverage, SplitsTheGroupAtTheLimit) {
    // One of 10 pixels is dropped at each end: half of the two dark ones stays.
    const double expected = std::exp((1 * std::log(0.01) + 7 * std::log(1.0)) / 8);
    EXPECT_NEAR(*Pixels().add(2, grey(0.01F)).add(8, grey(1)).average(), expected, expected * 2 * kBin);
}

TEST(LogAverage, LeavesOutWhatIsNotANumber) {
    const auto clean = Pixels().add(20, grey(2)).add(10, grey(3)).average();
    Pixels dirty;
    dirty.add(20, grey(2)).add(10, grey(3));
    for (const Colour bad :
         {grey(kNan), grey(kInf), Colour{1, kNan, 1}, Colour{0, 0, kInf}, grey(-1), Colour{}})
        dirty.add(3, bad);
    EXPECT_EQ(dirty.average(), clean);
}

TEST(LogAverage, BackgroundHasNoWeight) {
    EXPECT_NEAR(*Pixels().add(50, grey(1)).add(50, grey(1000), 0).average(), 1, kBin);
    // Half of its weight: 1/3 of all.
    const auto mixed = Pixels().add(300, grey(1)).add(300, grey(100), 127).average();
    EXPECT_GT(*mixed, 1.5F);
    EXPECT_LT(*mixed, 10);
}

TEST(LogAverage, NothingWhenUnderOnePercentIsLit) {
    EXPECT_FALSE(Pixels().add(100, {}).average().has_value());
    EXPECT_FALSE(Pixels().average().has_value());
    EXPECT_FALSE(Pixels().add(1000, {}).add(9, grey(1)).average().has_value());
    EXPECT_TRUE(Pixels().add(990, {}).add(10, grey(1)).average().has_value());
    EXPECT_FALSE(Pixels().add(100, grey(1), 0).average().has_value());
    EXPECT_FALSE(Pixels().add(10, grey(kNan)).add(10, grey(kInf)).average().has_value());
}

TEST(LogAverage, IsCorrectedByPixelsThatStandForOthers) {
    // The middle one of three parts is kept three times too bright, the last one is background that is kept
    // as a surface. Each tenth pixel is checked.
    LuminanceHistogram kept, truth;
    std::vector<CheckedPixel> checked;
    for (int i = 0; i < 3000; ++i) {
        const int part = i / 1000;
        const float is = 0.1F + 0.001F * static_cast<float>(i % 1000), was = part == 1 ? 3 * is : is;
        const std::uint8_t covered = part == 2 ? 0 : 255, all = 255;
        kept.count(std::span<const float>(&was, 1), {&all, 1});
        truth.count(std::span<const float>(&is, 1), {&covered, 1});
        if (i % 10 == 4) checked.push_back({was, is, all, covered});
    }
    const float right = *truth.logAverage();
    EXPECT_GT(*kept.logAverage(), 1.2F * right);
    kept.correct(checked, 10);
    EXPECT_NEAR(*kept.logAverage() / right, 1, 0.01);
}

TEST(LogAverage, ScalesWithTheLight) {
    Pixels once, thousandfold;
    for (int i = 1; i < 500; ++i) {
        once.add(1, grey(static_cast<float>(i * i)));
        thousandfold.add(1, grey(static_cast<float>(i * i) * 1024));
    }
    EXPECT_FLOAT_EQ(*thousandfold.average() / *once.average(), 1024);
}

Frame frameOf(const Pixels& pixels) {
    Frame frame;
    frame.radiance = HdrImage(static_cast<int>(pixels.colours.size()), 1);
    frame.radiance.pixels = pixels.colours;
    frame.covered = pixels.weights;
    return frame;
}

TEST(Exposure, FixedIsTheValue) {
    ExposureSettings settings;
    settings.mode = ExposureMode::Fixed;
    settings.value = 0.37F;
    EXPECT_EQ(test::exposureFor(frameOf(Pixels().add(5, grey(9))), settings), 0.37F);
}

TEST(Exposure, AutomaticPutsTheAverageAtTheKey) {
    const ExposureSettings settings;
    EXPECT_NEAR(test::exposureFor(frameOf(Pixels().add(50, grey(9)).add(50, grey(1e9F), 0)), settings),
                9 / 0.18, 50 * kBin);
}

TEST(Exposure, AdaptsToTheBackgroundWhenThereIsNothingElse) {
    const ExposureSettings settings;
    EXPECT_NEAR(test::exposureFor(frameOf(Pixels().add(50, grey(9), 0)), settings), 9 / 0.18, 50 * kBin);
}

TEST(Exposure, EveryCurveShowsTheMeanAlike) {
    const Frame frame = frameOf(Pixels().add(64, grey(9)));
    for (const float key : {0.05F, 0.18F, 0.9F}) {
        const auto shown = [&](ToneMapping curve, float contrast) {
            RenderSettings settings;
            settings.toneMapping = curve;
            settings.toneContrast = contrast;
            settings.dithering = false;
            settings.exposure.key = key;
            PictureDeveloper developer;
            LdrImage image;
            developer.develop(frame, settings, developer.exposure(frame, settings, {}, 1), 1, image);
            return int{image.pixels[20].g};
        };
        const int thesis = shown(ToneMapping::Luminance, 0);
        for (const float contrast : {0.0F, 1.0F, 2.0F})
            EXPECT_NEAR(shown(ToneMapping::AgX, contrast), thesis, 1) << key << " " << contrast;
        EXPECT_NEAR(shown(ToneMapping::Neutral, 0), thesis, 1) << key;
    }
}

TEST(Exposure, IsOfUseForAnyPicture) {
    const ExposureSettings settings;
    for (const Colour c : {Colour{}, grey(kNan), grey(kInf), grey(1e38F), grey(1e-45F)}) {
        const float exposure = test::exposureFor(frameOf(Pixels().add(50, c)), settings);
        EXPECT_GE(exposure, 1e-30F);
        EXPECT_LE(exposure, 1e30F);
    }
}

} // namespace
} // namespace rtcore
