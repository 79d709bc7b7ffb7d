#include "rtcore/neural/net_denoiser.h"

#include "made_net.h"

#include "rtcore/simd/instruction_set.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <limits>
#include <memory>
#include <random>
#include <vector>

namespace {

using rtcore::NetDenoiser;
using rtcore::NoisyImage;
using rtcore::UNet;

constexpr double kRoundTrip = 3e-6; ///< relative

struct TestImage {
    int width, height;
    std::vector<float> radiance, albedo, normal;

    TestImage(int w, int h) : width(w), height(h) {
        std::mt19937 random(5);
        std::uniform_real_distribution<float> number(0, 1);
        for (int i = 0; i < 3 * w * h; ++i) {
            radiance.push_back(4 * number(random));
            albedo.push_back(number(random));
            normal.push_back(2 * number(random) - 1);
        }
    }
    NoisyImage view() const { return {width, height, {radiance.data()}, {albedo.data()}, {normal.data()}}; }
};

std::shared_ptr<const UNet> made(int inputs, bool large) {
    return std::make_shared<const UNet>(test::madeNet(inputs, large), "made.tza");
}

/// By one thread unless told: others wait long for each other where all cores are busy.
std::vector<float> denoised(NetDenoiser& denoiser, const TestImage& image, int threads = 1) {
    std::vector<float> result(image.radiance.size(), -1);
    EXPECT_TRUE(denoiser.run(image.view(), result.data(), threads));
    return result;
}

TEST(NetDenoiser, GivesTilesTheBitsOfTheWhole) {
    for (const bool large : {false, true}) {
        const std::shared_ptr<const UNet> net = made(9, large);
        const TestImage image = large ? TestImage(1900, 60) : TestImage(60, 1400); // two tiles
        NetDenoiser whole(net), tiled(net, 1);
        const std::vector<float> expected = denoised(whole, image);
        EXPECT_EQ(denoised(tiled, image, large ? 2 : 1), expected);
        EXPECT_LT(tiled.bytes(), whole.bytes());
    }
    // In both directions at once, which takes many tiles: they overlap by more than they have themselves.
    const auto narrow = std::make_shared<const UNet>(test::madeNet(3, false, 9), "made.tza");
    const TestImage image(600, 600);
    NetDenoiser whole(narrow), tiled(narrow, 480 * 480);
    EXPECT_EQ(denoised(tiled, image), denoised(whole, image));
    EXPECT_LT(tiled.bytes(), whole.bytes());
}

TEST(NetDenoiser, TakesImagesOfAnySize) {
    const std::shared_ptr<const UNet> net = made(9, false);
    NetDenoiser denoiser(net);
    for (const auto& [width, height] : {std::pair{1, 1}, {1, 40}, {33, 2}, {16, 16}, {97, 101}}) {
        for (const float value : denoised(denoiser, TestImage(width, height))) {
            EXPECT_TRUE(std::isfinite(value));
            EXPECT_GE(value, 0);
        }
    }
}

TEST(NetDenoiser, TakesNoHarmFromWhatIsNoNumber) {
    const std::shared_ptr<const UNet> net = made(9, false);
    NetDenoiser denoiser(net);
    TestImage image(400, 40);
    for (const float value : {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity(),
                              -std::numeric_limits<float>::infinity(), 1e38F, -1.0F}) {
        TestImage broken = image;
        for (auto* const plane : {&broken.radiance, &broken.albedo, &broken.normal})
            (*plane)[3 * 400 * 20] = value;
        for (const float shown : denoised(denoiser, broken)) EXPECT_TRUE(std::isfinite(shown) && shown >= 0);
    }
}

TEST(NetDenoiser, LooksAtAlbedoAndNormalsWhereTheNetDoes) {
    const TestImage image(40, 40);
    TestImage other = image;
    for (float& value : other.albedo) value = 1 - value;
    for (float& value : other.normal) value = -value;
    for (const int inputs : {3, 6, 9}) {
        NetDenoiser denoiser(made(inputs, false));
        EXPECT_EQ(denoised(denoiser, image) == denoised(denoiser, other), inputs == 3) << inputs;
    }
}

/// An image that is brighter looks the same to a net.
TEST(NetDenoiser, FollowsTheBrightness) {
    NetDenoiser denoiser(made(3, false));
    TestImage image(64, 48);
    const std::vector<float> expected = denoised(denoiser, image);
    for (const float factor : {1.0F / 4096, 3.0F, 1024.0F}) {
        TestImage brighter = image;
        for (float& value : brighter.radiance) value *= factor;
        const std::vector<float> result = denoised(denoiser, brighter);
        double largest = 0;
        for (std::size_t i = 0; i < result.size(); ++i)
            largest = std::max(largest, static_cast<double>(std::fabs(result[i] / factor - expected[i])));
        EXPECT_LT(largest, 1e-3) << factor;
    }
}

TEST(Transfer, IsTheCurveAndItsInverse) {
    const auto exact = [](double y) {
        constexpr double a = 1.41283765e3, b = 1.64593172, c = 0.431384981, d = -2.94139609e-3,
                         e = 0.192653254, f = 6.26026094e-3, g = 0.998620152;
        return y <= 1.57945760e-6   ? a * y
               : y <= 3.22087631e-2 ? b * std::pow(y, c) + d
                                    : e * std::log(y + f) + g;
    };
    std::vector<float> values;
    for (int i = 0; i < 4096; ++i)
        values.push_back(static_cast<float>(std::pow(10.0, -9 + 13.8 * static_cast<double>(i) / 4095)));
    std::vector<float> coded(values.size()), decoded(values.size());
    rtcore::encodeRadiance(values.data(), values.size(), 1, coded.data());
    rtcore::decodeRadiance(coded.data(), values.size(), 1, decoded.data());
    for (std::size_t i = 0; i < values.size(); ++i) {
        const auto y = static_cast<double>(values[i]);
        EXPECT_NEAR(static_cast<double>(coded[i]), exact(y) / exact(65504), 5e-7) << y;
        EXPECT_NEAR(static_cast<double>(decoded[i]) / y, 1, 20 * kRoundTrip) << y;
    }
}

TEST(Transfer, HasTheSameBitsForEveryInstructionSet) {
    std::vector<float> values, first;
    for (int i = 0; i < 4096; ++i)
        values.push_back(std::ldexp(1.0F + static_cast<float>(i % 97) / 97, i % 40 - 24));
    for (const std::string& name : rtcore::instructionSets()) {
        ASSERT_TRUE(rtcore::useInstructionSet(name));
        std::vector<float> both(2 * values.size());
        rtcore::encodeRadiance(values.data(), values.size(), 0.7F, both.data());
        rtcore::decodeRadiance(both.data(), values.size(), 0.7F, both.data() + values.size());
        if (first.empty()) first = both;
        EXPECT_EQ(both, first) << name;
    }
    rtcore::useInstructionSet("auto");
}

TEST(Transfer, MeasuresTheMeanBrightness) {
    std::vector<float> grey(3 * 100 * 50, 2.0F);
    EXPECT_NEAR(rtcore::exposureForNet({grey.data()}, 100, 50, 1), 0.09F, 1e-6F);
    EXPECT_EQ(rtcore::exposureForNet({grey.data()}, 100, 50, 1),
              rtcore::exposureForNet({grey.data()}, 100, 50, 7));
    std::fill(grey.begin(), grey.begin() + 3 * 100 * 10, std::numeric_limits<float>::quiet_NaN());
    EXPECT_TRUE(std::isfinite(rtcore::exposureForNet({grey.data()}, 100, 50, 2)));
    std::fill(grey.begin(), grey.end(), -1.0F);
    EXPECT_EQ(rtcore::exposureForNet({grey.data()}, 100, 50, 1), 1.0F) << "no light at all";
}

} // namespace
