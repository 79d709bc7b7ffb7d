// Directions sampled from environments: no light is lost, and densities are those of the samples.
#include "rtcore/lights/environment_sampler-inl.h"

#include "estimates.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <memory>
#include <numbers>
#include <utility>
#include <vector>

namespace rtcore {
namespace environment_sampling {
namespace {

using test::Estimate;
using test::expectMean;

constexpr double kPiExact = std::numbers::pi;

template <typename Radiance>
HdrImage imageOf(int width, int height, Radiance radiance) {
    HdrImage image(width, height);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) image.at(x, y) = kWhite * static_cast<float>(radiance(x, y));
    return image;
}

using SampledDirection = HWY_NAMESPACE::EnvironmentSample<float>;

SampledDirection sampleOne(const EnvironmentSampler& sampler, test::Random& random) {
    const auto bits = [&] { return static_cast<std::uint32_t>(random.index(std::size_t{1} << 32U)); };
    const std::uint32_t across = bits();
    return HWY_NAMESPACE::sampleEnvironment<float>(sampler.rows(), across, bits());
}

float densityOf(const EnvironmentSampler& sampler, Vec3 direction) {
    return HWY_NAMESPACE::environmentDensity<float>(sampler.rows(), direction);
}

/// Solid angle of the rectangle between the middle of a cube's face, one unit away, and (x, y).
double solidAngleToCorner(double x, double y) { return std::atan(x * y / std::sqrt(x * x + y * y + 1)); }

/// Solid angle of texel (x, y) of a face of n x n texels.
double solidAngleOfTexel(int n, int x, int y) {
    const double x0 = 2.0 * x / n - 1, x1 = 2.0 * (x + 1) / n - 1;
    const double y0 = 2.0 * y / n - 1, y1 = 2.0 * (y + 1) / n - 1;
    return solidAngleToCorner(x0, y0) - solidAngleToCorner(x0, y1) - solidAngleToCorner(x1, y0) +
           solidAngleToCorner(x1, y1);
}

/// Estimates the integral of f over all the light by sampled directions.
template <typename Weight>
Estimate lightBy(const BackgroundLight& light, Weight weight, int count) {
    EnvironmentSampler sampler;
    sampler.prepare(light);
    EXPECT_FALSE(sampler.empty());
    test::Random random(1);
    Estimate e;
    for (int i = 0; i < count; ++i) {
        const SampledDirection d = sampleOne(sampler, random);
        EXPECT_GT(d.density, 0);
        e.add(static_cast<double>(light.radiance(d.direction).g) * static_cast<double>(weight(d.direction)) /
              static_cast<double>(d.density));
    }
    return e;
}

/// The integral of the radiance of an equirectangular image or a cube, by `parts` x `parts` points of each
/// texel.
double integralOf(const Environment& e, int parts) {
    double sum = 0;
    const int n = (e.images().front().width - 2) * parts;
    const auto number = [](double v) { return static_cast<float>(v); };
    const auto add = [&](Vec3 ofImage, double solidAngle) {
        sum += static_cast<double>(e.radiance(e.turned(ofImage), TexelFilter::Bilinear).g) * solidAngle;
    };
    if (e.isCube()) {
        for (int face = 0; face < 6; ++face)
            for (int y = 0; y < n; ++y)
                for (int x = 0; x < n; ++x)
                    add(cubeDirection(face, number((x + 0.5) / n), number((y + 0.5) / n)),
                        solidAngleOfTexel(n, x, y));
        return sum;
    }
    const double step = 2 * kPiExact / n;
    for (int y = 0; y < n / 2; ++y) {
        const double polar = (y + 0.5) * step, area = 2 * std::sin(polar) * std::sin(step / 2) * step;
        for (int x = 0; x < n; ++x) {
            const double azimuth = (x + 0.5) * step - kPiExact;
            add({number(std::sin(polar) * std::sin(azimuth)), number(std::cos(polar)),
                 number(-std::sin(polar) * std::cos(azimuth))},
                area);
        }
    }
    return sum;
}

TEST(EnvironmentSampler, LightsAFloorAsTheClosedForm) {
    for (const int power : {0, 1, 8, 50}) {
        const HdrImage image = imageOf(512, 256, [&](int, int y) {
            const double cosine = std::cos((y + 0.5) / 256 * kPiExact);
            return std::pow(std::max(cosine, 0.0), power);
        });
        const Environment environment = Environment::fromEquirectangular(image, "");
        const Estimate e = lightBy(
            {&environment, {}, TexelFilter::Bilinear}, [](Vec3 d) { return std::max(d.y, 0.0F); }, 100000);
        const double expected = 2 * kPiExact / (power + 2);
        EXPECT_LT(e.deviation(), 0.005 * expected);
        EXPECT_NEAR(e.mean(), expected, 5 * e.deviation() + 1e-3 * expected)
            << power; // the image is filtered
    }
}

TEST(EnvironmentSampler, LosesNoLightOfALoneBrightTexel) {
    constexpr int kWidth = 64, kHeight = 32;
    for (const auto& [column, row] :
         std::vector<std::pair<int, int>>{{20, 10}, {0, 16}, {63, 15}, {31, 0}, {5, 31}, {48, 16}}) {
        for (const float turn : {0.0F, 33.0F}) {
            SCOPED_TRACE(testing::Message() << column << ", " << row << ", " << turn << " degrees");
            const HdrImage image =
                imageOf(kWidth, kHeight, [&](int x, int y) { return x == column && y == row ? 1e4 : 0; });
            Environment environment = Environment::fromEquirectangular(image, "");
            environment.turn(turn, {0, 1, 0});
            const Estimate e = lightBy(
                {&environment, {}, TexelFilter::Bilinear}, [](Vec3) { return 1; }, 40000);
            expectMean(e, integralOf(environment, 8), 0.02);
        }
    }
}

TEST(EnvironmentSampler, LosesNoLightAtEdgesAndCornersOfACube) {
    for (const auto& [column, row] : std::vector<std::pair<int, int>>{{4, 9}, {0, 7}, {15, 15}, {0, 0}}) {
        for (const std::size_t bright : {0U, 2U, 5U}) {
            std::array<HdrImage, 6> faces;
            for (HdrImage& face : faces) face = HdrImage(16, 16);
            faces[bright].at(column, row) = kWhite * 1000.0F;
            Environment environment = Environment::fromCube(faces, "");
            environment.intensity = 3;
            environment.turn(-70, {0, 0, 1});
            const Estimate e = lightBy(
                {&environment, {}, TexelFilter::Bilinear}, [](Vec3) { return 1; }, 40000);
            expectMean(e, integralOf(environment, 8), 0.02);
        }
    }
}

TEST(EnvironmentSampler, LosesNoLightOfUnfilteredImages) {
    const HdrImage image = imageOf(64, 32, [](int x, int y) { return x == 40 && y == 12 ? 100 : 0.1; });
    const Environment environment = Environment::fromEquirectangular(image, "");
    const Estimate e = lightBy(
        {&environment, {}, TexelFilter::Nearest}, [](Vec3) { return 1; }, 40000);
    expectMean(e, static_cast<double>(environment.meanRadiance().g) * 4 * kPiExact + 1e-9, 0.02);
}

/// An image whose texels are brighter and darker without order, by up to 10^4.
HdrImage motleyImage(int width, int height) {
    test::Random random(static_cast<unsigned>(width * 100 + height));
    return imageOf(width, height, [&](int, int) { return std::pow(10.0F, random.number(-3, 1)); });
}
Environment motleyCube(int side) {
    std::array<HdrImage, 6> faces;
    for (int face = 0; face < 6; ++face) faces[static_cast<std::size_t>(face)] = motleyImage(side, side);
    faces[3].at(0, 0) = kWhite * 300.0F;
    return Environment::fromCube(faces, "");
}

/// The integral of a function of the direction over the sphere, by the middles of parts of equal solid angle.
template <typename Function>
double overSphere(int rings, Function f) {
    double sum = 0;
    for (int i = 0; i < rings; ++i) {
        const double y = 1 - (2 * i + 1.0) / rings, ring = std::sqrt(1 - y * y);
        for (int k = 0; k < 2 * rings; ++k) {
            const double turn = (k + 0.5) * kPiExact / rings;
            sum += f(Vec3{static_cast<float>(ring * std::cos(turn)), static_cast<float>(y),
                          static_cast<float>(ring * std::sin(turn))});
        }
    }
    return sum * 2 * kPiExact / (rings * static_cast<double>(rings));
}

TEST(EnvironmentSampler, HasADensityThatIntegratesToOne) {
    std::vector<Environment> environments;
    for (const auto& [width, height] :
         std::vector<std::pair<int, int>>{{1, 1}, {2, 1}, {1, 2}, {3, 2}, {7, 5}, {24, 12}, {13, 9}})
        environments.push_back(Environment::fromEquirectangular(motleyImage(width, height), ""));
    for (const int side : {1, 2, 7}) environments.push_back(motleyCube(side));
    for (Environment& environment : environments) {
        for (const float turn : {0.0F, 50.0F}) {
            SCOPED_TRACE(testing::Message() << (environment.isCube() ? "cube " : "sphere ")
                                            << environment.images().front().width << ", " << turn);
            environment.turn(turn, normalize(Vec3{1, 2, 3}));
            EnvironmentSampler sampler;
            sampler.prepare({&environment, {}, TexelFilter::Bilinear});
            float min = 1;
            const double all = overSphere(300, [&](Vec3 d) {
                const float density = densityOf(sampler, d);
                min = std::min(min, density);
                return static_cast<double>(density);
            });
            EXPECT_NEAR(all, 1, 1e-3);
            EXPECT_GT(min, 0);
        }
    }
}

/// The weights of sampled directions, over their mean; the largest in `max`.
Estimate weightsOf(const Environment& environment, TexelFilter filter, float& max) {
    const BackgroundLight light{&environment, {}, filter};
    EnvironmentSampler sampler;
    sampler.prepare(light);
    test::Random random(5);
    Estimate weights;
    max = 0;
    for (int i = 0; i < 20000; ++i) {
        const SampledDirection d = sampleOne(sampler, random);
        const float weight = luminance(light.radiance(d.direction)) / d.density /
                             static_cast<float>(sampler.scalarIrradiance());
        weights.add(static_cast<double>(weight));
        max = std::max(max, weight);
    }
    return weights;
}

// A density that follows the image gives bright texels the same weight: there is nothing to average. Texels
// dimmer than the mean are sampled more rarely, but not without end.
TEST(EnvironmentSampler, BrightLightHasTheSameWeight) {
    float max = 0;
    for (const auto& [column, row] : std::vector<std::pair<int, int>>{{77, 40}, {0, 64}, {255, 90}}) {
        const HdrImage sun =
            imageOf(256, 128, [&](int x, int y) { return x == column && y == row ? 1e5 : 0; });
        const Environment environment = Environment::fromEquirectangular(sun, "");
        EXPECT_LT(weightsOf(environment, TexelFilter::Bilinear, max).variance(), 3e-3);
        EXPECT_LT(max, 1.2F);
        weightsOf(environment, TexelFilter::Nearest, max);
        EXPECT_LT(max, 4.5F);
    }
    std::array<HdrImage, 6> faces;
    for (HdrImage& face : faces) face = HdrImage(64, 64);
    faces[2].at(0, 20) = kWhite * 1e5F;
    const Environment cube = Environment::fromCube(faces, "");
    EXPECT_LT(weightsOf(cube, TexelFilter::Bilinear, max).variance(), 3e-3);
}

TEST(EnvironmentSampler, NoWeightIsLarge) {
    float max = 0;
    for (const auto& [width, height] :
         std::vector<std::pair<int, int>>{{1, 1}, {2, 1}, {1, 2}, {3, 2}, {7, 5}, {200, 99}}) {
        const Environment environment = Environment::fromEquirectangular(motleyImage(width, height), "");
        weightsOf(environment, TexelFilter::Bilinear, max);
        EXPECT_LT(max, 4.2F) << width << " x " << height;
        weightsOf(environment, TexelFilter::Nearest, max);
        EXPECT_LT(max, 16) << width << " x " << height;
    }
    for (const int side : {1, 2, 40}) {
        weightsOf(motleyCube(side), TexelFilter::Bilinear, max);
        EXPECT_LT(max, 6) << side;
    }
}

/// The standard deviation of the irradiance on a floor by 64 directions, over its mean.
double noiseOfFloor(const Environment& environment) {
    const BackgroundLight light{&environment, {}, TexelFilter::Bilinear};
    EnvironmentSampler sampler;
    sampler.prepare(light);
    test::Random random(6);
    Estimate pixels;
    for (int pixel = 0; pixel < 1000; ++pixel) {
        double sum = 0;
        for (int i = 0; i < 64; ++i) {
            const SampledDirection d = sampleOne(sampler, random);
            sum += static_cast<double>(luminance(light.radiance(d.direction)) *
                                       std::max(d.direction.y, 0.0F) / d.density);
        }
        pixels.add(sum / 64);
    }
    return std::sqrt(pixels.variance()) / pixels.mean();
}

TEST(EnvironmentSampler, SunsInImagesAreNoNoise) {
    const auto sky = [](double bright, double x, double y) {
        return [=](int column, int row) {
            const double across = (column + 0.5 - x) * std::sin(y / 512 * kPiExact), down = row + 0.5 - y;
            return across * across + down * down < 2.5 ? bright : 0.02;
        };
    };
    EXPECT_LT(noiseOfFloor(Environment::fromEquirectangular(imageOf(1024, 512, sky(4e4, 300, 150)), "")),
              0.04);
    EXPECT_LT(noiseOfFloor(Environment::fromEquirectangular(
                  imageOf(1024, 512, [](int x, int y) { return x == 20 && y == 100 ? 1e5 : 0; }), "")),
              0.02);
}

TEST(EnvironmentSampler, SamplesDirectionsWithTheDensityThatItReturns) {
    const Environment environment = Environment::fromEquirectangular(motleyImage(128, 64), "");
    EnvironmentSampler sampler;
    sampler.prepare({&environment, {}, TexelFilter::Bilinear});
    test::Random random(3);
    Estimate one;
    std::array<Estimate, 8> octants;
    for (int i = 0; i < 200000; ++i) {
        const SampledDirection d = sampleOne(sampler, random);
        ASSERT_EQ(d.density, densityOf(sampler, d.direction));
        ASSERT_NEAR(length(d.direction), 1, 1e-6F);
        const double inverse = 1 / static_cast<double>(d.density);
        const auto octant = static_cast<std::size_t>(
            (d.direction.x > 0 ? 1 : 0) + (d.direction.y > 0 ? 2 : 0) + (d.direction.z > 0 ? 4 : 0));
        for (std::size_t k = 0; k < 8; ++k) octants[k].add(k == octant ? inverse : 0);
    }
    for (const Estimate& octant : octants) expectMean(octant, kPiExact / 2);
}

TEST(EnvironmentSampler, TellsTheNumbersThatADirectionIsMadeOf) {
    HdrImage face(16, 16);
    for (int y = 0; y < 16; ++y)
        for (int x = 0; x < 16; ++x) face.at(x, y) = kWhite * static_cast<float>(1 + x * y % 7);
    const std::array<HdrImage, 6> faces{face, face, face, face, face, face};
    const std::array<Environment, 2> environments{Environment::fromEquirectangular(motleyImage(128, 64), ""),
                                                  Environment::fromCube(faces, "")};
    for (const Environment& environment : environments) {
        EnvironmentSampler sampler;
        sampler.prepare({&environment, {}, TexelFilter::Bilinear});
        test::Random random(3);
        constexpr double kAll = 1U << EnvironmentRows::kBits;
        int apart = 0;
        for (int i = 0; i < 20000; ++i) {
            const std::uint32_t across = random.index(std::size_t{1} << 32U),
                                down = random.index(std::size_t{1} << 32U);
            const auto point = HWY_NAMESPACE::environmentPoint<float>(
                sampler.rows(), HWY_NAMESPACE::environmentDirection<float>(sampler.rows(), across, down));
            const double x = point.across / kAll - across / 0x1p32, y = point.down / kAll - down / 0x1p32;
            // At an edge of a cell the direction may be that of a neighbour, whose numbers may be others.
            apart += std::abs(x) > 1e-3 || std::abs(y) > 1e-3 ? 1 : 0;
        }
        EXPECT_LT(apart, 20);
    }
}

TEST(EnvironmentSampler, OfAnEvenBackgroundIsEven) {
    const BackgroundLight light{nullptr, {0.5F, 2, 0.25F}, TexelFilter::Bilinear};
    const Estimate e = lightBy(
        light, [](Vec3) { return 1; }, 10000);
    expectMean(e, 2 * 4 * kPiExact, 1e-3);
    EnvironmentSampler sampler;
    sampler.prepare(light);
    EXPECT_NEAR(sampler.scalarIrradiance(), 4 * kPiExact * static_cast<double>(luminance(light.even)), 1e-5);
    test::Random random(4);
    for (int i = 0; i < 1000; ++i)
        EXPECT_NEAR(densityOf(sampler, random.unitVector()) * 4 * std::numbers::pi_v<float>, 1, 1e-5);
}

TEST(EnvironmentSampler, IsEmptyWhereNothingShines) {
    const Environment black = Environment::fromEquirectangular(HdrImage(8, 4), "");
    Environment off = Environment::fromEquirectangular(motleyImage(8, 4), "");
    off.intensity = 0;
    for (const BackgroundLight& light :
         {BackgroundLight{&black, {}, TexelFilter::Bilinear}, BackgroundLight{},
          BackgroundLight{&off, {}, TexelFilter::Bilinear}}) {
        EnvironmentSampler sampler;
        sampler.prepare(light);
        EXPECT_TRUE(sampler.empty());
        EXPECT_EQ(sampler.scalarIrradiance(), 0);
    }
}

TEST(EnvironmentSampler, TakesImagesOfOneTexelAndNegativeLight) {
    const Environment one = Environment::fromEquirectangular(HdrImage(1, 1, {1, 2, 3}), "");
    expectMean(lightBy(
                   {&one, {}, TexelFilter::Bilinear}, [](Vec3) { return 1; }, 10000),
               8 * kPiExact, 1e-3);

    HdrImage image(16, 8, {1, 1, 1});
    image.at(3, 3) = {-5, -5, -5};
    const Environment negative = Environment::fromEquirectangular(image, "");
    expectMean(lightBy(
                   {&negative, {}, TexelFilter::Bilinear}, [](Vec3) { return 1; }, 40000),
               integralOf(negative, 16), 0.01);
}

TEST(BackgroundLight, IsTheEnvironmentElseTheBackgroundElseWhatIsGiven) {
    Scene scene;
    const Colour ambient{0.1F, 0.2F, 0.3F};
    const auto seen = [&](Colour instead) {
        return backgroundLight(scene, TexelFilter::Bilinear, instead).radiance({0, 1, 0});
    };
    EXPECT_EQ(seen({}), Colour{});
    EXPECT_EQ(seen(ambient), ambient);
    scene.background = {1, 0, 0};
    EXPECT_EQ(seen(ambient), scene.background);
    scene.environments.push_back(
        std::make_shared<const Environment>(Environment::fromEquirectangular(HdrImage(4, 2, {0, 7, 0}), "")));
    EXPECT_EQ(seen(ambient), (Colour{0, 7, 0}));
    scene.activeEnvironment = kNoEnvironment;
    EXPECT_EQ(seen(ambient), scene.background);
}

} // namespace
} // namespace environment_sampling
} // namespace rtcore
