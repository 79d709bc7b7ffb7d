// The errors by two references: closed values, and what becomes of the references' noise.
#include "bench/walk/light_errors.h"
#include "bench/walk/uncovered.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <random>
#include <vector>

namespace {

using bench::LightErrors;
using bench::lightErrors;
using bench::lightErrorsOf;
using rtcore::Colour;
using rtcore::HdrImage;

constexpr int kSide = 200;

HdrImage uniform(float value) { return HdrImage(kSide, kSide, {value, value, value}); }

HdrImage noisy(float value, float deviation, unsigned seed) {
    std::mt19937 random(seed);
    std::normal_distribution<float> noise(0, deviation);
    HdrImage image(kSide, kSide);
    for (Colour& pixel : image.pixels)
        pixel = {value + noise(random), value + noise(random), value + noise(random)};
    return image;
}

TEST(LightErrors, AreNoneOfTheReferenceItself) {
    const LightErrors errors = lightErrors(uniform(2), uniform(2), uniform(2));
    EXPECT_EQ(errors.relMse, 0);
    EXPECT_EQ(errors.bias, 0);
}

TEST(LightErrors, AreThoseOfTheFormula) {
    const LightErrors errors = lightErrors(uniform(3), uniform(2), uniform(2));
    EXPECT_NEAR(errors.relMse, 1 / (4 + 0.01 * 4), 1e-9);
    EXPECT_NEAR(errors.bias, 0.5, 1e-9);
}

// Noise of single pixels evens out over a square, an error of all of it does not.
TEST(LightErrors, TellBlotchesFromNoise) {
    const HdrImage noise = noisy(1, 0.08F, 4), wanted = uniform(1);
    EXPECT_NEAR(lightErrors(uniform(1.2F), wanted, wanted).blocks, 0.2 / 1.1, 1e-5);
    EXPECT_LT(lightErrors(noise, wanted, wanted).blocks, 0.01);
    HdrImage blotch = wanted;
    for (int y = 8; y < 16; ++y)
        for (int x = 8; x < 16; ++x) blotch.at(x, y) = {0, 0, 0};
    EXPECT_NEAR(lightErrors(blotch, wanted, wanted).blocks, 1 / 1.1 / (25 * 25), 1e-6);
    EXPECT_EQ(lightErrors(wanted, uniform(0), uniform(0)).blocks, 0);
}

TEST(LightErrors, OfSomePixelsAreNotThoseOfOthers) {
    HdrImage image = uniform(1);
    std::vector<bool> left(image.pixels.size());
    for (int y = 0; y < kSide; ++y) {
        for (int x = 0; x < kSide; ++x) {
            left[static_cast<std::size_t>(y * kSide + x)] = x < 20;
            const float value = x < 20 ? 1.5F : 4.0F;
            image.at(x, y) = {value, value, value};
        }
    }
    const LightErrors errors = lightErrorsOf(left, image, uniform(1), uniform(1));
    EXPECT_NEAR(errors.bias, 0.5, 1e-6);
    EXPECT_NEAR(errors.blocks, 0.5 / 1.1, 1e-5);
    EXPECT_EQ(lightErrorsOf(std::vector<bool>(left.size()), image, uniform(1), uniform(1)).bias, 0);
}

TEST(LightErrors, ChangeIsOfBothSigns) {
    HdrImage now = uniform(2);
    for (std::size_t i = 0; i < now.pixels.size(); ++i)
        now.pixels[i] = (i % 2 != 0 ? 0.9F : 1.1F) * now.pixels[i];
    EXPECT_NEAR(bench::changeOfLight(uniform(2), now), 0.1, 1e-6);
    EXPECT_EQ(bench::changeOfLight(uniform(0), now), 0);
}

// By 45 of 90 degrees to the right: half of the columns are new.
TEST(UncoveredByTurn, IsWhatTheCameraBeforeDidNotSee) {
    rtcore::Camera before, now;
    before.horizontalFov = now.horizontalFov = 90;
    now.forward = {1, 0, -1};
    const std::vector<bool> uncovered = bench::uncoveredByTurn(before, now, kSide, 2);
    for (int x = 0; x < kSide; ++x) EXPECT_EQ(uncovered[static_cast<std::size_t>(x)], x >= kSide / 2) << x;
    now.forward = {0, 0, 1};
    for (const bool pixel : bench::uncoveredByTurn(before, now, kSide, 2)) EXPECT_TRUE(pixel);
    for (const bool pixel : bench::uncoveredByTurn(before, before, kSide, kSide)) EXPECT_FALSE(pixel);
}

// The square of what it differs from the mean of both would have half of their variance, 0.00125, as well.
TEST(LightErrors, LoseTheNoiseOfIndependentReferences) {
    const HdrImage one = noisy(1, 0.05F, 1), other = noisy(1, 0.05F, 2);
    EXPECT_NEAR(lightErrors(uniform(1), one, other).relMse, 0, 0.0002);
    EXPECT_NEAR(lightErrors(noisy(1, 0.1F, 3), one, other).relMse, 0.01, 0.0005);
}

TEST(LightErrors, LeaveOutWhereTheReferencesDifferMost) {
    const std::size_t leftOut = uniform(1).pixels.size() / 1000;
    HdrImage one = uniform(1);
    const HdrImage other = uniform(1);
    for (std::size_t i = 0; i < leftOut; ++i) one.pixels[i * 7] = {1000, 1000, 1000};
    EXPECT_EQ(lightErrors(uniform(1), one, other).relMse, 0);
    const double error = lightErrors(uniform(2), one, other).relMse;
    one.pixels[1] = {3, 3, 3}; // it counts: -1 / 4 in place of 1
    const double changed = (1 + 0.25) / static_cast<double>(one.pixels.size());
    EXPECT_NEAR(error - lightErrors(uniform(2), one, other).relMse, changed, 0.1 * changed);
}

TEST(LightErrors, KnowNoPartOfNoLight) { EXPECT_EQ(lightErrors(uniform(1), uniform(0), uniform(0)).bias, 0); }

} // namespace
