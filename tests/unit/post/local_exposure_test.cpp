#include "rtcore/post/local_exposure.h"

#include "rtcore/post/develop.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>

namespace rtcore {
namespace {

/// Left half of luminance `left`, the right one of `right`, both with some texture.
HdrImage twoHalves(int width, int height, float left, float right) {
    HdrImage image(width, height);
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            const float texture = (x / 3 + y / 3) % 2 == 0 ? 1.1F : 0.9F;
            image.at(x, y) = kWhite * (x < width / 2 ? left : right) * texture;
        }
    }
    return image;
}

HdrImage adjusted(const HdrImage& image, float average, float strength, int threads = 1) {
    RenderSettings settings;
    settings.exposure.key = 1;
    settings.exposure.local = strength;
    LocalExposure local;
    EXPECT_TRUE(local.beginRows(image, 1, {.settings = settings, .threads = threads, .exposure = average}));
    HdrImage result(image.width, image.height);
    for (int y = 0; y < image.height; ++y) {
        local.changeRow({y, 0, image.width, image.width, image.height}, &image.at(0, y), &result.at(0, y));
    }
    return result;
}

double log2Of(Colour c) { return std::log2(static_cast<double>(c.g)); }

TEST(LocalExposure, BringsTheHalvesTogether) {
    const HdrImage image = twoHalves(400, 200, 20, 0.2F);
    const auto difference = [](const HdrImage& picture) {
        return log2Of(picture.at(60, 100)) - log2Of(picture.at(339, 101));
    };
    const double before = difference(image);
    EXPECT_NEAR(difference(adjusted(image, 2, 0)), before, 1e-4);
    EXPECT_NEAR(difference(adjusted(image, 2, 0.5F)), before / 2, 0.1 * before);
    EXPECT_NEAR(difference(adjusted(image, 2, 1)), 0, 0.1 * before);
}

TEST(LocalExposure, KeepsTexture) {
    const HdrImage image = twoHalves(400, 200, 20, 0.2F);
    const HdrImage seen = adjusted(image, 2, 1);
    const auto contrast = [](const HdrImage& picture) {
        return std::fabs(log2Of(picture.at(60, 100)) - log2Of(picture.at(63, 100)));
    };
    EXPECT_GT(contrast(seen), 0.8 * contrast(image));
}

// A blur without regard to edges would leave the full step of 6.6 powers of two along both sides of it.
TEST(LocalExposure, LeavesNoHaloAlongAnEdge) {
    const HdrImage image = twoHalves(400, 200, 20, 0.2F);
    const HdrImage seen = adjusted(image, 2, 1);
    for (const auto& [from, to] : {std::pair{100, 200}, {200, 300}}) {
        double min = 1e9, max = -1e9;
        for (int x = from; x < to; ++x) {
            const double factor = log2Of(seen.at(x, 100)) - log2Of(image.at(x, 100));
            min = std::min(min, factor);
            max = std::max(max, factor);
        }
        EXPECT_LT(max - min, 0.75) << from;
    }
}

TEST(LocalExposure, OfAnEvenPictureIsThatOfTheWhole) {
    const HdrImage image(90, 50, kWhite * 3);
    for (const Colour c : adjusted(image, 3, 1).pixels) ASSERT_NEAR(c.r, 3, 1e-3F);
    for (const Colour c : adjusted(image, 1.5F, 1).pixels) ASSERT_NEAR(c.r, 1.5F, 1e-3F);
}

TEST(LocalExposure, StandsWhatIsNoNumber) {
    HdrImage image(31, 17, kWhite);
    image.at(3, 3) = {std::numeric_limits<float>::infinity(), 1, 1};
    image.at(9, 9) = {std::numeric_limits<float>::quiet_NaN(), 1, 1};
    image.at(15, 9) = {};
    const HdrImage seen = adjusted(image, 1, 1);
    EXPECT_EQ(seen.at(15, 9), Colour{});
    EXPECT_TRUE(std::isfinite(seen.at(25, 14).r));
    for (const int size : {1, 2, 3}) {
        for (const Colour c : adjusted(HdrImage(size, 1, kWhite), 1, 1).pixels) EXPECT_NEAR(c.r, 1, 1e-3F);
    }
}

TEST(LocalExposure, HasTheSameBitsForAnyThreads) {
    Frame frame;
    frame.radiance = twoHalves(333, 111, 8, 0.1F);
    frame.covered.assign(frame.radiance.pixels.size(), 255);
    RenderSettings settings;
    settings.width = 333;
    settings.bloom.radius = 4;
    settings.exposure.local = 0.7F;
    PictureDeveloper developer;
    LdrImage one, many;
    developer.develop(frame, settings, 2, 1, one);
    for (const int threads : {2, 3}) {
        developer.develop(frame, settings, 2, threads, many);
        EXPECT_EQ(many.pixels, one.pixels);
    }
    // Parts of it, with what a pass of the same image tells.
    EffectChain effects;
    effects.beginRows(EffectStage::Radiance, frame.radiance, 1,
                      {.settings = settings, .threads = 1, .exposure = 2});
    LdrImage parts(333, 111);
    for (int x = 0; x < 333; x += 100) {
        developPart(frame.radiance, developmentOf(settings, 2), effects, {x, 0, std::min(100, 333 - x), 111},
                    parts);
    }
    // The pass's brightness is that before bloom: a little off.
    for (std::size_t i = 0; i < one.pixels.size(); ++i)
        ASSERT_NEAR(parts.pixels[i].g, one.pixels[i].g, 12) << i;
}

} // namespace
} // namespace rtcore
