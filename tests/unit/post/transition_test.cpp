#include "rtcore/post/transition.h"

#include "rtcore/upsample/upsample.h"
#include "support/one_frame.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace rtcore {
namespace {

constexpr int kWidth = 96, kHeight = 40;
constexpr float kExposure = 0.7F;

RenderSettings imageSettings() {
    RenderSettings settings;
    settings.width = kWidth;
    settings.height = kHeight;
    return settings;
}

HdrImage noise(unsigned seed, int width = kWidth, int height = kHeight) {
    HdrImage image(width, height);
    std::mt19937 random(seed);
    for (Colour& c : image.pixels) {
        const auto number = [&] { return static_cast<float>(random() >> 8U) / 16777216.0F * 4; };
        c = {number(), number(), number()};
    }
    return image;
}

Frame frameOf(const HdrImage& radiance) {
    Frame frame;
    frame.radiance = radiance;
    frame.covered.assign(radiance.pixels.size(), 255);
    return frame;
}

LdrImage developed(const HdrImage& radiance, const RenderSettings& settings, float exposure = kExposure) {
    return test::develop(frameOf(radiance), settings, exposure);
}

TEST(Transition, BeginsWithWhatIsSeenAndEndsWithWhatFollows) {
    const HdrImage before = noise(1), after = noise(2);
    Transition transition;
    transition.begin(frameOf(before), imageSettings(), 1);
    transition.expose(kExposure);
    EXPECT_EQ(transition.image().pixels, developed(before, imageSettings()).pixels);
    transition.step({{0, 0, kWidth, 16}}, after);
    transition.step({{0, 16, kWidth, kHeight - 16}}, after);
    transition.step({}, after);
    EXPECT_EQ(transition.image().pixels, developed(after, imageSettings()).pixels);
}

TEST(Transition, ShowsHalfOfAnAreaFirstAndReadsNoOther) {
    const HdrImage before = noise(1);
    HdrImage after = noise(2);
    const PixelArea area{7, 3, 20, 11};
    Transition transition;
    transition.begin(frameOf(before), imageSettings(), 1);
    transition.expose(kExposure);
    for (int y = 0; y < kHeight; ++y) {
        for (int x = 0; x < kWidth; ++x) {
            const bool inside = x >= 7 && x < 27 && y >= 3 && y < 14;
            if (!inside) after.at(x, y) = {NAN, NAN, NAN};
        }
    }
    transition.step({area}, after);
    HdrImage wanted = before;
    for (int y = 3; y < 14; ++y) {
        for (int x = 7; x < 27; ++x)
            wanted.at(x, y) = before.at(x, y) + (after.at(x, y) - before.at(x, y)) * 0.5F;
    }
    EXPECT_EQ(transition.image().pixels, developed(wanted, imageSettings()).pixels);
}

TEST(Transition, UpsamplesASmallerImage) {
    const RenderSettings settings = imageSettings();
    HdrImage slope(kWidth / 2, kHeight / 4), wanted(kWidth, kHeight);
    for (int y = 0; y < slope.height; ++y) {
        for (int x = 0; x < slope.width; ++x)
            slope.at(x, y) = Colour{1, 1, 1} * ((static_cast<float>(x) + 0.5F) * 2);
    }
    upsample(slope, 1, wanted);
    Transition transition;
    transition.begin(frameOf(slope), settings, 2);
    transition.expose(kExposure);
    EXPECT_EQ(transition.image().pixels, developed(wanted, settings).pixels);
}

TEST(Transition, FollowsTheExposureAndShowsEffectsOfParts) {
    const HdrImage before = noise(1), after = noise(2);
    RenderSettings settings = imageSettings();
    settings.bloom.radius = 3;
    Transition transition;
    transition.begin(frameOf(before), settings, 1);
    transition.expose(kExposure);
    const LdrImage bright = transition.image();
    EXPECT_NE(bright.pixels, developed(before, imageSettings()).pixels) << "with its bloom";
    transition.expose(2);
    EXPECT_NE(transition.image().pixels, bright.pixels);
    transition.expose(kExposure);
    EXPECT_EQ(transition.image().pixels, bright.pixels);
}

} // namespace
} // namespace rtcore
