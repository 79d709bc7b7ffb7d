#include "rtcore/post/bloom.h"

#include "rtcore/post/develop.h"
#include "support/one_frame.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <random>
#include <vector>

namespace rtcore {
namespace {

HdrImage pointOfLight(int width, int height, int x, int y, Colour c = kWhite) {
    HdrImage image(width, height);
    image.at(x, y) = c;
    return image;
}

HdrImage randomImage(int width, int height) {
    HdrImage image(width, height);
    std::mt19937 random(7);
    for (Colour& c : image.pixels) {
        const auto number = [&] {
            const float u = static_cast<float>(random() >> 8U) / 16777216.0F;
            return u * u * u * 100;
        };
        c = {number(), number(), number()};
    }
    return image;
}

struct Sums {
    double r = 0, g = 0, b = 0;
};
Sums sumOf(const HdrImage& image) {
    Sums sum;
    for (const Colour c : image.pixels) {
        sum.r += static_cast<double>(c.r);
        sum.g += static_cast<double>(c.g);
        sum.b += static_cast<double>(c.b);
    }
    return sum;
}

RenderSettings bloomOf(const HdrImage& image, int sigma, BloomKernel kernel, float fraction = 1) {
    RenderSettings settings;
    settings.width = image.width;
    settings.height = image.height;
    settings.bloom.radius = sigma;
    settings.bloom.kernel = kernel;
    settings.bloom.share = fraction;
    return settings;
}

HdrImage withBloom(const HdrImage& image, int sigma, BloomKernel kernel, float fraction = 1) {
    return Bloom().apply(image, {}, {.settings = bloomOf(image, sigma, kernel, fraction), .threads = 1});
}

constexpr std::array kKernels{BloomKernel::Gaussian, BloomKernel::Airy};

bool sameBits(const HdrImage& a, const HdrImage& b) {
    return a.pixels.size() == b.pixels.size() &&
           std::memcmp(a.pixels.data(), b.pixels.data(), a.pixels.size() * sizeof(Colour)) == 0;
}

TEST(Bloom, OffIsThePictureItself) {
    const HdrImage image = randomImage(20, 10);
    Bloom bloom;
    EXPECT_EQ(&bloom.apply(image, {}, {bloomOf(image, 0, BloomKernel::Gaussian)}), &image);
    EXPECT_EQ(&bloom.apply(image, {}, {bloomOf(image, 9, BloomKernel::Gaussian, 0)}), &image);
}

// (thesis: the image's light is spread, none comes or goes)
TEST(Bloom, KeepsTheSumOfLightAtBordersToo) {
    for (const BloomKernel kernel : kKernels) {
        for (const auto& [width, height] : {std::pair{120, 90}, {97, 61}, {1, 1}, {2, 300}, {151, 1}}) {
            const HdrImage image = randomImage(width, height);
            const Sums before = sumOf(image);
            for (const int sigma : {1, 2, 7, 20, 100, 1000, 4096}) {
                const Sums after = sumOf(withBloom(image, sigma, kernel, 0.7F));
                // A float's steps add up over the reach of the filter.
                EXPECT_NEAR(after.r / before.r, 1, 2e-4) << width << " " << sigma;
                EXPECT_NEAR(after.g / before.g, 1, 2e-4) << width << " " << sigma;
                EXPECT_NEAR(after.b / before.b, 1, 2e-4) << width << " " << sigma;
            }
        }
    }
}

TEST(Bloom, LeavesAnEvenPictureAlone) {
    const HdrImage image(77, 50, Colour{0.5F, 2, 300});
    for (const BloomKernel kernel : kKernels) {
        for (const int sigma : {1, 5, 40, 4096}) {
            for (const Colour c : withBloom(image, sigma, kernel).pixels) {
                ASSERT_NEAR(c.r, 0.5F, 0.5F * 2e-4F);
                ASSERT_NEAR(c.g, 2, 2 * 2e-4F);
                ASSERT_NEAR(c.b, 300, 300 * 2e-4F);
            }
        }
    }
}

TEST(Bloom, GaussianIsTheSampledOne) {
    for (const int sigma : {1, 2, 5, 20}) {
        const int middle = 7 * sigma, size = 2 * middle + 1;
        const HdrImage bloom =
            withBloom(pointOfLight(size, size, middle, middle), sigma, BloomKernel::Gaussian);
        double norm = 0;
        const auto bell = [&](int i) { return std::exp(-0.5 * i * i / (1.0 * sigma * sigma)); };
        for (int i = -middle; i <= middle; ++i) norm += bell(i);
        double largest = 0, apart = 0;
        for (int y = 0; y < size; ++y) {
            for (int x = 0; x < size; ++x) {
                const double expected = bell(x - middle) * bell(y - middle) / (norm * norm);
                const double error = std::fabs(static_cast<double>(bloom.at(x, y).g) - expected);
                largest = std::max(largest, error * norm * norm);
                apart += error;
                ASSERT_GE(bloom.at(x, y).g, 0);
            }
        }
        EXPECT_LT(largest, 0.0012) << sigma; // of the peak
        EXPECT_LT(apart, 0.0025) << sigma;   // of the light
    }
}

TEST(Bloom, GaussianIsMirroredAtBorders) {
    const int sigma = 9, size = 40;
    const HdrImage bloom = withBloom(pointOfLight(size, 1, 3, 0), sigma, BloomKernel::Gaussian);
    double norm = 0;
    const auto bell = [&](int i) { return std::exp(-0.5 * i * i / (1.0 * sigma * sigma)); };
    for (int i = -200; i <= 200; ++i) norm += bell(i);
    for (int x = 0; x < size; ++x) {
        double expected = 0;
        for (int turn = -4; turn <= 4; ++turn) {
            expected += (bell(x - 3 + 2 * size * turn) + bell(x + 4 + 2 * size * turn)) / norm;
        }
        EXPECT_NEAR(bloom.at(x, 0).g, expected, 0.0015 / norm) << x;
    }
}

/// Where the row through the light first gets darker and then brighter again.
double firstMinimum(const HdrImage& bloom, int middle, float Colour::*channel) {
    int x = middle + 1;
    while (bloom.at(x + 1, middle).*channel < bloom.at(x, middle).*channel) ++x;
    // The vertex of the parabola through three points.
    const auto at = [&](int i) { return static_cast<double>(bloom.at(i, middle).*channel); };
    const double slope = (at(x + 1) - at(x - 1)) / 2, bend = at(x + 1) - 2 * at(x) + at(x - 1);
    return x - slope / bend - middle;
}

TEST(Bloom, AiryHasItsDarkRingsByColour) {
    const int sigma = 12, middle = 300, size = 601;
    const HdrImage bloom = withBloom(pointOfLight(size, size, middle, middle), sigma, BloomKernel::Airy);
    // lambda N of green is pi sigma / sqrt(2) pixels.
    const double green = 3.14159265358979 * sigma / std::sqrt(2.0);
    EXPECT_NEAR(firstMinimum(bloom, middle, &Colour::g), 1.219670 * green, 0.15);
    EXPECT_NEAR(firstMinimum(bloom, middle, &Colour::r), 1.219670 * green * 650 / 532, 0.15);
    EXPECT_NEAR(firstMinimum(bloom, middle, &Colour::b), 1.219670 * green * 450 / 532, 0.15);
    // In the first dark ring of green, red is still bright; in that of red, green is in its first bright one.
    const Colour ring = bloom.at(middle + static_cast<int>(1.21967 * green + 0.5), middle);
    EXPECT_GT(ring.r, 20 * ring.g);
    const Colour outer = bloom.at(middle + static_cast<int>(1.21967 * green * 650 / 532 + 0.5), middle);
    EXPECT_GT(outer.g, 10 * outer.r);
}

TEST(Bloom, AiryIsThePatternOfDiffraction) {
    const int sigma = 12, middle = 300, size = 601;
    const HdrImage bloom = withBloom(pointOfLight(size, size, middle, middle), sigma, BloomKernel::Airy);
    const double cutoff = std::sqrt(2.0) / (3.14159265358979 * sigma);
    const double peak = 3.14159265358979 / 4 * cutoff * cutoff; // 1 / the pattern's volume
    double inside[3] = {};
    const double radii[3] = {1.219670, 2.233131, 3.238315};
    for (int y = 0; y < size; ++y) {
        for (int x = 0; x < size; ++x) {
            const double r = std::hypot(x - middle, y - middle);
            const double value = static_cast<double>(bloom.at(x, y).g);
            for (int i = 0; i < 3; ++i) {
                if (r * cutoff < radii[i]) inside[i] += value;
            }
            if (r * cutoff > 4) continue;
            const double z = 3.14159265358979 * r * cutoff;
            const double wave = r > 0 ? 2 * std::cyl_bessel_j(1.0, z) / z : 1.0;
            ASSERT_NEAR(value / peak, wave * wave, 0.003) << x << " " << y; // pixels are averages
        }
    }
    EXPECT_NEAR(inside[0], 0.837785, 0.002);
    EXPECT_NEAR(inside[1], 0.909931, 0.002);
    EXPECT_NEAR(inside[2], 0.937647, 0.002);
}

TEST(Bloom, AiryOfAFewPixelsHasNoNegativeLight) {
    const int middle = 40;
    for (const int sigma : {1, 2}) {
        const HdrImage bloom =
            withBloom(pointOfLight(81, 81, middle, middle, {1000, 1000, 1000}), sigma, BloomKernel::Airy);
        const Sums sum = sumOf(bloom); // light cut off below zero would be missing
        EXPECT_NEAR(sum.g, 1000, 0.2) << sigma;
        EXPECT_NEAR(sum.b, 1000, 0.2) << sigma;
    }
}

TEST(Bloom, AiryResponseFoldsBackWhatPixelsCannotHold) {
    // By the definition: a pattern far below a pixel leaves the pixel's own square, whose sampled spectrum
    // is 1.
    EXPECT_NEAR(airyResponse(0.3F, 0.2F, 40), 1, 0.02);
    EXPECT_EQ(airyResponse(0, 0, 0.3F), 1);
    EXPECT_EQ(airyResponse(0.25F, 0.25F, 0.3F), 0);
}

// Any length: with large prime factors, one, less than the reach.
TEST(Bloom, AiryOfAwkwardSizesIsSymmetric) {
    for (const int size : {1, 2, 3, 17, 61, 127, 169, 211}) {
        const int middle = size / 2;
        const HdrImage bloom = withBloom(pointOfLight(size, size, middle, middle), 3, BloomKernel::Airy);
        for (int y = 0; y < size; ++y) {
            for (int x = 0; x < size; ++x) ASSERT_NEAR(bloom.at(x, y).g, bloom.at(y, x).g, 3e-7) << size;
        }
        if (size % 2 == 1) {
            ASSERT_NEAR(bloom.at(0, middle).r, bloom.at(size - 1, middle).r, 3e-7) << size;
        }
    }
}

TEST(Bloom, NothingIsSpreadFromWhatIsNoNumber) {
    constexpr float inf = std::numeric_limits<float>::infinity();
    constexpr float nan = std::numeric_limits<float>::quiet_NaN();
    HdrImage image(60, 40, kWhite);
    image.at(10, 10) = {nan, -5, 1};
    for (const BloomKernel kernel : kKernels) {
        const HdrImage seen = withBloom(image, 2, kernel, 0.5F);
        for (int x = 20; x < 60; ++x) ASSERT_NEAR(seen.at(x, 30).r, 1, 0.01);
        EXPECT_GE(seen.at(9, 10).g, 0);
    }
    image.at(10, 10) = {inf, inf, inf};
    for (const BloomKernel kernel : kKernels) {
        for (const Colour c : withBloom(image, 2, kernel, 0.5F).pixels) ASSERT_FALSE(std::isnan(c.r));
    }
}

TEST(Bloom, HasTheSameBitsForAnyThreads) {
    const HdrImage image = randomImage(203, 117);
    for (const BloomKernel kernel : kKernels) {
        const RenderSettings settings = bloomOf(image, 6, kernel, 0.3F);
        const HdrImage one = Bloom().apply(image, {}, {.settings = settings, .threads = 1});
        for (const int threads : {2, 3, 5})
            EXPECT_TRUE(sameBits(Bloom().apply(image, {}, {.settings = settings, .threads = threads}), one));
    }
}

TEST(Bloom, GrowsWithThePicture) {
    RenderSettings settings;
    settings.width = 640;
    settings.bloom.radius = 20;
    EXPECT_EQ(bloomSigma(settings, 640), 20);
    EXPECT_EQ(bloomSigma(settings, 80), 2.5F);
    EXPECT_EQ(bloomSigma(settings, 2), 0);
}

// While tiles come in, their bloom is that of a coarser image: at its own size it is the same.
TEST(Bloom, PartsGetTheBloomOfAWholePass) {
    Frame frame;
    frame.radiance = randomImage(150, 70);
    frame.covered.assign(frame.radiance.pixels.size(), 255);
    const RenderSettings settings = bloomOf(frame.radiance, 5, BloomKernel::Gaussian, 0.4F);
    EffectChain effects;
    effects.beginRows(EffectStage::Radiance, frame.radiance, 1, {.settings = settings, .threads = 1});
    LdrImage parts(150, 70);
    for (int x = 0; x < 150; x += 32) {
        developPart(frame.radiance, developmentOf(settings, 3), effects, {x, 0, std::min(32, 150 - x), 70},
                    parts);
    }
    EXPECT_EQ(parts.pixels, test::develop(frame, settings, 3).pixels);
}

TEST(Bloom, CoarseBloomIsInterpolated) {
    HdrImage bloom(5, 3);
    for (int y = 0; y < 3; ++y) {
        for (int x = 0; x < 5; ++x) bloom.at(x, y) = Colour{static_cast<float>(x), static_cast<float>(y), 1};
    }
    for (int y = 4; y < 20; ++y) {
        for (int x = 4; x < 36; ++x) {
            const Colour c = spreadAt(bloom, 8, x, y);
            EXPECT_NEAR(c.r, (static_cast<float>(x) + 0.5F) / 8 - 0.5F, 1e-5F);
            EXPECT_NEAR(c.g, (static_cast<float>(y) + 0.5F) / 8 - 0.5F, 1e-5F);
        }
    }
    EXPECT_EQ(spreadAt(bloom, 8, 0, 0), (Colour{0, 0, 1}));
    EXPECT_EQ(spreadAt(bloom, 8, 39, 23), (Colour{4, 2, 1}));
}

TEST(Bloom, ExposureIsThatOfTheImageWithoutBloom) {
    Frame frame;
    frame.radiance = randomImage(64, 64);
    frame.radiance.at(5, 5) = {1e6F, 1e6F, 1e6F};
    frame.covered.assign(frame.radiance.pixels.size(), 255);
    RenderSettings plain = bloomOf(frame.radiance, 0, BloomKernel::Gaussian);
    RenderSettings blooming = bloomOf(frame.radiance, 10, BloomKernel::Gaussian, 0.5F);
    PictureDeveloper developer;
    const float exposure = developer.exposure(frame, plain.exposure, 0);
    EXPECT_EQ(developer.exposure(frame, blooming.exposure, 0), exposure);
    EXPECT_NE(test::develop(frame, blooming, exposure).pixels, test::develop(frame, plain, exposure).pixels);
    EXPECT_EQ(&developer.finish(frame, plain, 0), &frame.radiance);
}

} // namespace
} // namespace rtcore
