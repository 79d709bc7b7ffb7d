// The light of environments on surfaces, against closed forms.
#include "rtcore/math/octahedron-inl.h"
#include "rtcore/scene/environment.h"
#include "rtcore/scene/environment_light.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <numbers>
#include <vector>

namespace rtcore {
namespace {

constexpr double kTruePi = std::numbers::pi;

using Radiance = std::function<Colour(Vec3)>; ///< of a unit direction

Environment sphereOf(const Radiance& radiance, int height) {
    HdrImage image(2 * height, height);
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < 2 * height; ++x) {
            const double azimuth = 2 * kTruePi * ((x + 0.5) / (2 * height) - 0.5),
                         polar = kTruePi * (y + 0.5) / height;
            image.at(x, y) = radiance({static_cast<float>(std::sin(polar) * std::sin(azimuth)),
                                       static_cast<float>(std::cos(polar)),
                                       static_cast<float>(-std::sin(polar) * std::cos(azimuth))});
        }
    }
    return Environment::fromEquirectangular(image, "sphere");
}

Environment cubeOf(const Radiance& radiance, int side) {
    std::array<HdrImage, 6> faces;
    for (int face = 0; face < 6; ++face) {
        HdrImage& image = faces[static_cast<std::size_t>(face)] = HdrImage(side, side);
        for (int y = 0; y < side; ++y) {
            for (int x = 0; x < side; ++x) {
                const float s = (static_cast<float>(x) + 0.5F) / static_cast<float>(side);
                const float t = (static_cast<float>(y) + 0.5F) / static_cast<float>(side);
                image.at(x, y) = radiance(normalize(cubeDirection(face, s, t)));
            }
        }
    }
    return Environment::fromCube(std::move(faces), "cube");
}

/// Evenly spread over the sphere.
std::vector<Vec3> directions(int count) {
    std::vector<Vec3> result;
    for (int i = 0; i < count; ++i) {
        const double y = 1 - 2 * (i + 0.5) / count, ring = std::sqrt(1 - y * y), a = 2.399963229728653 * i;
        result.push_back({static_cast<float>(ring * std::cos(a)), static_cast<float>(y),
                          static_cast<float>(ring * std::sin(a))});
    }
    return result;
}

Colour spreadRadiance(const EnvironmentLight& light, Vec3 direction) {
    const auto i = static_cast<std::size_t>(HWY_NAMESPACE::octahedronTexel<float>(direction, light.side()));
    return {light.radiance(0)[i], light.radiance(1)[i], light.radiance(2)[i]};
}

/// Irradiance over pi by the spread radiance.
Colour spreadOpen(const EnvironmentLight& light, Vec3 normal) {
    constexpr int kCount = 100'000;
    std::array<double, 3> sum{};
    for (const Vec3 d : directions(kCount)) {
        const auto cosine = static_cast<double>(std::max(dot(normal, d), 0.0F));
        const Colour seen = spreadRadiance(light, d);
        sum[0] += cosine * static_cast<double>(seen.r);
        sum[1] += cosine * static_cast<double>(seen.g);
        sum[2] += cosine * static_cast<double>(seen.b);
    }
    const auto mean = [&](double s) { return static_cast<float>(4 * s / kCount); };
    return {mean(sum[0]), mean(sum[1]), mean(sum[2])};
}

constexpr double kHalfAngle = 0.03; ///< of the sun, radians
const Vec3 kToSun = normalize(Vec3{0.6F, 0.8F, -0.4F});
/// A dim sky with a sun that gives nine tenths of its light.
Colour sunnySky(Vec3 d) {
    const bool sun = dot(d, kToSun) > static_cast<float>(std::cos(kHalfAngle));
    return sun ? Colour{40'000, 36'000, 30'000} : Colour{1, 2, 4};
}

TEST(EnvironmentLight, OfAnEvenSkyIsThatSky) {
    const EnvironmentLight even;
    EXPECT_EQ(spreadRadiance(even, {0.3F, -0.2F, 0.5F}), kWhite);
    EXPECT_EQ(even.open({0, 1, 0}) * even.correction({0, 1, 0}), kWhite);
    const Environment white = sphereOf([](Vec3) { return Colour{2, 2, 2}; }, 4);
    for (const Vec3 d : directions(1000)) {
        EXPECT_NEAR(spreadRadiance(white.light(), d).g, 2, 1e-5);
        EXPECT_NEAR(white.light().open(d).g, 2, 4e-3);
        EXPECT_NEAR(white.light().correction(d).g, 1, 2e-3);
    }
}

// The irradiance of a + b cos(angle to up) is pi (a + 2/3 b cos(angle of the normal to up)).
TEST(EnvironmentLight, OfAGradientHasItsIrradiance) {
    const auto gradient = [](Vec3 d) { return Colour{1 + d.y, 2 - d.y, 3 + 2 * d.y}; };
    for (const Environment& environment :
         {sphereOf(gradient, 16), sphereOf(gradient, 700), cubeOf(gradient, 9), cubeOf(gradient, 300)}) {
        const EnvironmentLight& light = environment.light();
        SCOPED_TRACE(environment.images().front().width);
        for (const Vec3 n : directions(50)) {
            const float up = 2 * n.y / 3;
            EXPECT_NEAR(light.open(n).r, 1 + up, 0.02);
            EXPECT_NEAR(light.open(n).g, 2 - up, 0.02);
            EXPECT_NEAR(light.open(n).b, 3 + 2 * up, 0.04);
            EXPECT_NEAR(light.correction(n).r, 1, 0.02);
        }
    }
}

TEST(EnvironmentLight, OfASmallSunHasItsIrradiance) {
    const double solidAngle = 2 * kTruePi * (1 - std::cos(kHalfAngle));
    for (const Environment& environment : {sphereOf(sunnySky, 1024), cubeOf(sunnySky, 512)}) {
        const EnvironmentLight& light = environment.light();
        for (const Vec3 n : {kToSun, Vec3{0, 1, 0}, Vec3{1, 0, 0}, normalize(Vec3{-0.2F, 0.4F, -1})}) {
            const double sun = 40'000 * solidAngle * static_cast<double>(dot(n, kToSun)) / kTruePi;
            EXPECT_NEAR(light.open(n).r, sun + 1, 0.02 * sun);
        }
        const Vec3 away = normalize(Vec3{-0.6F, -0.8F, 0.4F});
        EXPECT_NEAR(light.open(away).r, 1, 0.01);
    }
}

TEST(EnvironmentLight, SpreadsWhatIsBrightAndLosesNothing) {
    const Environment environment = sphereOf(sunnySky, 1024);
    const EnvironmentLight& light = environment.light();
    const Colour mean = environment.meanRadiance();
    double sum = 0;
    float max = 0;
    const std::vector<Vec3> all = directions(100'000);
    for (const Vec3 d : all) {
        const Colour seen = spreadRadiance(light, d);
        sum += static_cast<double>(luminance(seen)) / static_cast<double>(all.size());
        max = std::max(max, luminance(seen));
    }
    EXPECT_NEAR(sum, static_cast<double>(luminance(mean)), 0.01 * sum); // as the texels' edges cut the sun
    EXPECT_LT(max, 6 * luminance(mean)) << "or few rays would make noise";
    for (const Vec3 n : {kToSun, Vec3{0, 1, 0}, Vec3{1, 0, 0}, Vec3{0, 0, 1}, Vec3{0, -1, 0}}) {
        const Colour spread = spreadOpen(light, n) * light.correction(n), own = light.open(n);
        EXPECT_NEAR(spread.r, own.r, 0.02 * static_cast<double>(own.r));
        EXPECT_NEAR(spread.b, own.b, 0.02 * static_cast<double>(own.b));
    }
}

TEST(EnvironmentLight, LeavesOrdinarySkiesAsTheyAre) {
    const auto sky = [](Vec3 d) { return d.y > 0 ? Colour{1, 2, 3 + d.x} : Colour{0.1F, 0.1F, 0.05F}; };
    const Environment environment = sphereOf(sky, 512);
    for (const Vec3 d : directions(2000)) {
        if (std::fabs(d.y) < 0.08F) continue; // texels are that large
        EXPECT_NEAR(spreadRadiance(environment.light(), d).b, sky(d).b, 0.06);
    }
    EXPECT_NEAR(environment.light().correction({0, 1, 0}).b, 1, 0.01);
}

TEST(EnvironmentLight, OfBlackIsBlack) {
    const Environment black = sphereOf([](Vec3) { return Colour{}; }, 8);
    for (const Vec3 d : directions(100)) {
        EXPECT_EQ(spreadRadiance(black.light(), d), Colour{});
        EXPECT_EQ(black.light().open(d), Colour{});
        EXPECT_EQ(black.light().correction(d), Colour{});
    }
}

TEST(EnvironmentLight, IsSharedByCopiesAndKnowsNoIntensity) {
    const Environment environment = sphereOf([](Vec3) { return Colour{2, 2, 2}; }, 8);
    Environment bright = environment;
    bright.intensity = 7;
    EXPECT_EQ(&bright.light(), &environment.light());
    EXPECT_NEAR(bright.light().open({0, 1, 0}).r, 2, 0.01);
}

TEST(EnvironmentCells, AreAllDirections) {
    const auto gradient = [](Vec3 d) { return Colour{1 + d.x, 1 + d.y, 1 + d.z}; };
    for (const Environment& environment : {sphereOf(gradient, 3), sphereOf(gradient, 800),
                                           cubeOf(gradient, 2), cubeOf(gradient, 7), cubeOf(gradient, 300)}) {
        double angle = 0, r = 0;
        for (const EnvironmentCell& cell : environment.cells()) {
            angle += static_cast<double>(cell.solidAngle);
            r += static_cast<double>(cell.solidAngle) * static_cast<double>(cell.radiance.r);
            ASSERT_NEAR(length(cell.direction), 1, 1e-5);
        }
        EXPECT_NEAR(angle, 4 * kTruePi, 1e-3);
        EXPECT_NEAR(r / angle, static_cast<double>(environment.meanRadiance().r), 5e-3);
    }
}

} // namespace
} // namespace rtcore
