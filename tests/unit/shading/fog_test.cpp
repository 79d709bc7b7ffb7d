// Fog against numbers written down and against numerical integration in double precision.
#include "rtcore/lights/photometry-inl.h"
#include "rtcore/scene/photometry.h"
#include "rtcore/shading/fog/fog.h"
#include "rtcore/shading/fog/fog_light.h"
#include "rtcore/shading/fog/fog_shafts.h"
#include "rtcore/shading/fog/fog_wave.h"

#include "support/random_numbers.h"
#include "support/small_scene.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <utility>
#include <vector>

namespace rtcore {
namespace {

FogMedium mediumOf(FogKind kind, float density, float scaleHeight = 1, float ground = 0,
                   Vec3 up = {0, 0, 1}) {
    Scene scene;
    scene.up = up;
    scene.fog.kind = kind;
    scene.fog.density = density;
    scene.fog.scaleHeight = scaleHeight;
    scene.fog.groundHeight = ground;
    scene.fog.colour = {1, 0.5F, 0.25F};
    return fogMedium(scene, {});
}

/// A ray, its fog, and maybe a light, in double precision.
struct Case {
    FogMedium fog;
    Vec3 origin, direction;
    float distance = 0;
    Light light;

    double density(double t) const {
        if (!fog.exponential) return 1;
        const double z = double{dot(fog.up, origin)} - double{fog.ground} + t * dot(fog.up, direction);
        return std::exp(-z * double{fog.perHeight});
    }
    /// Scale heights per unit of length.
    double slope() const { return double{dot(fog.up, direction)} * double{fog.perHeight}; }
    /// The stretch that holds all but e^-40 of the fog.
    std::pair<double, double> stretch() const {
        const double s = slope(), d = distance;
        if (s > 0) return {0, std::min(d, 40 / s)};
        if (s < 0 && d < 1e30) return {std::max(0.0, d + 40 / s), d};
        return {0, d};
    }
    /// That part of it from which more than e^-40 of the light comes back.
    std::pair<double, double> seenStretch() const {
        auto [from, to] = stretch();
        const double s = slope(), start = fog.density * density(0);
        if (s < 0) {
            to = std::min(to, std::log1p(40 * -s / start) / -s);
            return {std::max(0.0, to + 40 / s), to};
        }
        if (s * to < 1e-3) return {0, std::min(to, 41 / start)};
        if (40 * s / start < 1) to = std::min(to, -std::log1p(-40 * s / start) / s);
        return {0, to};
    }
};

/// 10 nodes of Gauss and Legendre on each piece.
double integrate(const std::vector<double>& edges, const std::function<double(double)>& f) {
    constexpr double x[] = {0.1488743389816312, 0.4333953941292472, 0.6794095682990244, 0.8650633666889845,
                            0.9739065285171717};
    constexpr double w[] = {0.2955242247147529, 0.2692667193099963, 0.2190863625159820, 0.1494513491505806,
                            0.0666713443086881};
    double sum = 0;
    for (std::size_t i = 0; i + 1 < edges.size(); ++i) {
        const double middle = (edges[i] + edges[i + 1]) / 2, half = (edges[i + 1] - edges[i]) / 2;
        for (std::size_t k = 0; k < 5; ++k)
            sum += half * w[k] * (f(middle - half * x[k]) + f(middle + half * x[k]));
    }
    return sum;
}

std::vector<double> evenEdges(double from, double to, int pieces) {
    std::vector<double> edges;
    for (int i = 0; i <= pieces; ++i) edges.push_back(from + (to - from) * i / pieces);
    return edges;
}

double depthByIntegration(const Case& c) {
    const auto [from, to] = c.stretch();
    if (to > 1e30) return std::numeric_limits<double>::infinity(); // level, or falling for ever
    return c.fog.density * integrate(evenEdges(from, to, 20), [&](double t) { return c.density(t); });
}

/// The wave's own light and transmittance of cases with one fog.
class FoggedRays {
  public:
    explicit FoggedRays(const std::vector<Case>& cases) {
        std::vector<std::uint32_t> traits;
        HitWave hits;
        hits.resize(cases.size());
        for (std::size_t i = 0; i < cases.size(); ++i) {
            rays.push({cases[i].origin, 0, cases[i].direction, kEndless});
            hits.t[i] = cases[i].distance;
            traits.push_back(cases[i].distance < kEndless ? 1 : 0);
        }
        fog.begin(cases[0].fog);
        fog.enter(rays, hits, traits.data(), {});
    }
    RayWave rays;
    FogWave fog;
};

Case randomCase(test::Random& random, const FogMedium& fog) {
    Case c;
    c.fog = fog;
    const float height = fog.exponential ? 1 / fog.perHeight : 20;
    c.origin = random.vector(50);
    c.origin.z = random.coin() ? random.number(-2, 6) * height : random.number(0, 100) * height;
    c.direction = random.unitVector();
    if (random.index(5) == 0) c.direction = normalize(Vec3{c.direction.x, c.direction.y, 0});
    if (random.index(5) == 0) c.direction = normalize(c.direction + Vec3{0, 0, -4}); // from high up
    if (random.index(10) == 0) c.direction = normalize(Vec3{c.direction.x, c.direction.y, 1e-6F});
    c.distance = std::pow(10.0F, random.number(-2, 3.5F));
    const bool thin = c.origin.z > 40 * height && c.direction.z == 0; // 1e38 is not infinite there
    if (random.index(4) == 0 && !thin) c.distance = kEndless;
    return c;
}

TEST(Fog, DepthsAreThoseOfTheClosedForm) {
    const FogMedium fog = mediumOf(FogKind::Exponential, 0.1F, 10);
    const auto depth = [&](float z, float dz, float d) {
        return fog.density * fogLength(fog, {0, 0, z}, {std::sqrt(1 - dz * dz), 0, dz}, d);
    };
    EXPECT_NEAR(depth(0, 0, 10), 1, 1e-6);
    EXPECT_NEAR(depth(0, 1, 10), 0.632121, 1e-6);
    EXPECT_NEAR(depth(0, 0.6F, 20), 1.164676, 1e-6);
    EXPECT_NEAR(depth(20, -0.6F, 20), 0.523323, 1e-6);
    EXPECT_NEAR(depth(5, 1e-7F, 10), 0.606531, 1e-6);
    EXPECT_NEAR(depth(0, 1, kEndless), 1, 1e-6);
    EXPECT_NEAR(depth(20, 0.5F, kEndless), 0.270671, 1e-6);
    EXPECT_NEAR(depth(2000, -0.5F, 4000), 2, 1e-4); // the origin's density is 1e-87
    EXPECT_NEAR(fogTransmittance(fog, {}, {0, 0, 1}, kEndless), 0.367879, 1e-6);
    EXPECT_EQ(fogTransmittance(fog, {0, 0, 5}, {1, 0, 0}, kEndless), 0);
    EXPECT_EQ(fogTransmittance(fog, {0, 0, 5}, {0, 0, -1}, kEndless), 0);
    EXPECT_EQ(fogTransmittance(mediumOf(FogKind::Homogeneous, 1e-9F), {}, {0, 0, 1}, kEndless), 0);
}

TEST(Fog, AThinFogKeepsItsDigits) {
    EXPECT_NEAR(FoggedRays({{mediumOf(FogKind::Homogeneous, 1e-7F), {}, {1, 0, 0}, 1, {}}})
                        .fog.rays()
                        .scattered.x[0] /
                    1e-7,
                1, 1e-6);
}

TEST(Fog, EmissionAndColourAddUp) {
    Scene scene;
    scene.fog.kind = FogKind::Homogeneous;
    scene.fog.density = 0.05F;
    scene.fog.colour = {};
    scene.fog.emission = {0.02F, 0.02F, 0.02F};
    const FogMedium fog = fogMedium(scene, {});
    EXPECT_NEAR(FoggedRays({{fog, {}, {1, 0, 0}, 20, {}}}).fog.rays().scattered.x[0], 0.252848, 1e-6);

    scene.fog.colour = {0.1F, 0.2F, 0.3F};
    scene.fog.emission = {};
    scene.fog.albedo = {0.5F, 0.5F, 1};
    scene.fog.surroundings = 2;
    scene.background = {0.3F, 0.4F, 0.5F};
    scene.ambient = {0.1F, 0.1F, 0.1F};
    const Colour source = fogMedium(scene, {}).source;
    EXPECT_NEAR(source.r, 0.1 + 0.4, 1e-6);
    EXPECT_NEAR(source.g, 0.2 + 0.5, 1e-6);
    EXPECT_NEAR(source.b, 0.3 + 1.2, 1e-6);
}

TEST(Fog, IsOffWithoutDensityOrSetting) {
    Scene scene;
    RenderSettings settings;
    EXPECT_FALSE(fogMedium(scene, settings).on);
    scene.fog.kind = FogKind::Exponential;
    EXPECT_FALSE(fogMedium(scene, settings).on);
    scene.fog.density = 1;
    EXPECT_TRUE(fogMedium(scene, settings).on);
    settings.fog.on = false;
    EXPECT_FALSE(fogMedium(scene, settings).on);
}

TEST(Fog, TransmittanceIsTheIntegral) {
    test::Random random(7);
    for (int f = 0; f < 100; ++f) {
        const FogKind kind = f % 4 == 0 ? FogKind::Homogeneous : FogKind::Exponential;
        const FogMedium fog = mediumOf(kind, std::pow(10.0F, random.number(-4, 1)),
                                       std::pow(10.0F, random.number(-1, 2)), random.number(-5, 5));
        std::vector<Case> cases;
        for (int i = 0; i < 100; ++i) cases.push_back(randomCase(random, fog));
        const FoggedRays wave(cases);
        for (std::size_t i = 0; i < cases.size(); ++i) {
            const Case& c = cases[i];
            const double depth = depthByIntegration(c);
            const double expected = std::exp(-depth), opacity = -std::expm1(-depth);
            SCOPED_TRACE(testing::Message() << "depth " << depth << ", slope " << c.slope() << ", distance "
                                            << c.distance << ", z " << c.origin.z);
            ASSERT_NEAR(fogTransmittance(fog, c.origin, c.direction, c.distance), expected, 1e-4);
            ASSERT_NEAR(wave.fog.rays().transmittance[i], expected, 1e-4);
            ASSERT_NEAR(wave.fog.rays().scattered.y[i], 0.5 * opacity, 1e-4);
        }
    }
}

/// The light of a local light: the integral of density e^-tau / r^2, tau both ways.
double lightByIntegration(const Case& c) {
    const auto point = [&](double t, int axis) {
        const float o[] = {c.origin.x, c.origin.y, c.origin.z};
        const float d[] = {c.direction.x, c.direction.y, c.direction.z};
        return o[axis] + t * d[axis];
    };
    const double light[] = {c.light.position.x, c.light.position.y, c.light.position.z};
    const double axis[] = {c.light.direction.x, c.light.direction.y, c.light.direction.z};
    double foot = 0, offset = 0;
    for (int k = 0; k < 3; ++k) foot += (light[k] - point(0, k)) * (point(1, k) - point(0, k));
    for (int k = 0; k < 3; ++k) offset += std::pow(light[k] - point(foot, k), 2);
    offset = std::sqrt(offset);
    const bool flat = isFlatLight(c.light.kind);
    const double perHeight = c.fog.exponential ? double{c.fog.perHeight} : 0;
    const auto length = [&](double a, double b, double distance) { // between two heights
        const double x = std::fabs(a - b) * perHeight;
        return std::exp(-(std::min(a, b) - double{c.fog.ground}) * perHeight) * distance *
               (x < 1e-9 ? 1 : -std::expm1(-x) / x);
    };
    const auto f = [&](double t) {
        double square = 0, along = 0;
        for (int k = 0; k < 3; ++k) square += std::pow(point(t, k) - light[k], 2);
        for (int k = 0; k < 3; ++k) along += (point(t, k) - light[k]) * axis[k];
        const double r = std::sqrt(square), z = point(t, 2);
        const double both = length(point(0, 2), z, t) + length(z, light[2], r);
        double spot = 1;
        if (c.light.kind == LightKind::Spot) {
            const double range = double{c.light.cosInner} - double{c.light.cosOuter};
            const double x = std::clamp((along / r - double{c.light.cosOuter}) / range, 0.0, 1.0);
            spot = x * x * (3 - 2 * x);
        }
        if (flat) spot = std::max(along / r, 0.0);
        if (c.light.kind == LightKind::Ies) {
            const auto cosine = static_cast<float>(along / r);
            const float sine = std::sqrt(std::max(1 - cosine * cosine, 0.0F));
            spot = double{HWY_NAMESPACE::measuredFactor<float>(photometryOf(c.light), cosine, sine, 0.0F)};
        }
        return spot * c.density(t) * std::exp(-c.fog.density * both) / square;
    };
    const auto [from, to] = c.seenStretch();
    std::vector<double> edges = evenEdges(from, to, flat || c.light.kind == LightKind::Point ? 60 : 300);
    const auto add = [&, from = from, to = to](double t) {
        if (t > from && t < to) edges.push_back(t);
    };
    add(foot);
    if (flat) { // where the ray goes through its plane
        double above = 0, rate = 0;
        for (int k = 0; k < 3; ++k) above += (point(0, k) - light[k]) * axis[k];
        for (int k = 0; k < 3; ++k) rate += (point(1, k) - point(0, k)) * axis[k];
        add(-above / rate);
    }
    for (double step = 0.02 * offset; step < 1e6 * offset; step *= 1.5) add(foot - step), add(foot + step);
    std::sort(edges.begin(), edges.end());
    return integrate(edges, f);
}

/// A fog and a light in it, as often as not beside the light.
Case randomLightCase(test::Random& random, const FogMedium& fog, const Light& light) {
    Case c = randomCase(random, fog);
    if (c.origin.z > 6 / std::max(fog.perHeight, 0.01F)) c.origin.z *= 0.2F;
    if (random.coin()) {
        const Vec3 beside = light.position + random.unitVector() * std::pow(10.0F, random.number(-1, 1));
        c.direction = normalize(beside - c.origin);
    }
    c.light = light;
    // Past the light the result hangs on the last digits of the direction.
    const Vec3 offset = light.position - c.origin;
    const bool near = length(cross(offset, c.direction)) < 2e-3F * length(offset);
    return near ? randomLightCase(random, fog, light) : c;
}

/// Error of a light's contribution in units of the larger of it and 1; the light sends 4 pi / albedo.
void expectLightOf(LightKind lightKind, int fogs, double tolerance) {
    test::Random random(11);
    for (int f = 0; f < fogs; ++f) {
        const FogKind kind = f % 2 == 0 ? FogKind::Homogeneous : FogKind::Exponential;
        const FogMedium fog = mediumOf(kind, std::pow(10.0F, random.number(-3, 0)),
                                       std::pow(10.0F, random.number(0, 2)), random.number(-5, 5));
        Light light = test::pointLight(random.vector(30), 4 * static_cast<float>(test::kPi));
        light.kind = lightKind;
        light.direction = random.unitVector();
        light.right = basisAround(light.direction).tangent;
        if (lightKind == LightKind::Ies)
            light.photometry = keepPhotometry({{0, 20, 40, 75}, {0, 360}, {6, 9, 4, 0, 6, 9, 4, 0}});
        light.cosOuter = random.number(0, 0.9F);
        light.cosInner = light.cosOuter + random.number(0.3F, 1) * (1 - light.cosOuter);
        std::vector<Case> cases;
        for (int i = 0; i < 100; ++i) cases.push_back(randomLightCase(random, fog, light));
        FoggedRays wave(cases);
        for (float* const array : {wave.fog.rays().scattered.x}) std::fill_n(array, cases.size(), 0.0F);
        addFogLight(wave.fog, light);
        for (std::size_t i = 0; i < cases.size(); ++i) {
            const Case& c = cases[i];
            const double expected = c.fog.density * lightByIntegration(c);
            const double got = wave.fog.rays().scattered.x[i];
            ASSERT_NEAR(got, expected, tolerance * std::max(1.0, expected))
                << i << " density " << fog.density << ", per height " << fog.perHeight << ", slope "
                << c.slope() << ", distance " << c.distance << ", z " << c.origin.z << ", light "
                << light.position.z;
        }
    }
}

TEST(FogLight, APointLightIsTheIntegral) { expectLightOf(LightKind::Point, 100, 1e-4); }
TEST(FogLight, APanelsLightIsTheIntegral) { expectLightOf(LightKind::Rectangle, 20, 1e-4); }
TEST(FogLight, ASpotsLightIsTheIntegral) { expectLightOf(LightKind::Spot, 10, 3e-3); }
TEST(FogLight, ALuminairesLightIsTheIntegral) { expectLightOf(LightKind::Ies, 10, 1e-2); }

TEST(FogLight, HasTheBrightnessOfTheClosedForm) {
    const auto seen = [](float density, float distance) {
        Case c{mediumOf(FogKind::Homogeneous, density), {}, {1, 0, 0}, distance, {}};
        c.fog.source = {};
        FoggedRays wave({c});
        addFogLight(wave.fog, test::pointLight({5, 2, 0}, 100));
        return wave.fog.rays().scattered.x[0] / 100 * (4 * static_cast<float>(test::kPi)) / density;
    };
    EXPECT_NEAR(seen(0.1F, 10), 0.560279, 2e-6);
    EXPECT_NEAR(seen(0.1F, kEndless), 0.576322, 2e-6);
    EXPECT_NEAR(seen(1e-6F, 10), 1.190290, 3e-5);
}

TEST(FogLight, ASunsLightIsTheIntegral) {
    test::Random random(13);
    for (int f = 0; f < 50; ++f) {
        const FogKind kind = f % 5 == 0 ? FogKind::Homogeneous : FogKind::Exponential;
        const FogMedium fog = mediumOf(kind, std::pow(10.0F, random.number(-3, 0)),
                                       std::pow(10.0F, random.number(0, 2)), random.number(-5, 5));
        Light sun;
        sun.kind = LightKind::Directional;
        sun.direction = random.unitVector();
        sun.direction.z = -std::fabs(sun.direction.z);
        sun.intensity = kWhite * 4 * static_cast<float>(test::kPi);
        std::vector<Case> cases;
        for (int i = 0; i < 100; ++i) cases.push_back(randomCase(random, fog));
        FoggedRays wave(cases);
        std::fill_n(wave.fog.rays().scattered.x, cases.size(), 0.0F);
        addFogLight(wave.fog, sun);
        for (std::size_t i = 0; i < cases.size(); ++i) {
            const Case& c = cases[i];
            const double rise = -double{sun.direction.z} * double{fog.perHeight};
            const double extinction = fog.density, s = c.slope();
            const auto [from, to] = c.seenStretch();
            const double expected = integrate(evenEdges(from, to, 200), [&](double t) {
                const double here = c.density(t);
                const double back = std::fabs(s * t) < 1e-6 ? t * c.density(0) : (c.density(0) - here) / s;
                return extinction * here *
                       std::exp(-extinction * (back + (fog.exponential ? here / rise : 0)));
            });
            ASSERT_NEAR(wave.fog.rays().scattered.x[i], expected, 1e-4)
                << "slope " << s << ", rise " << rise << ", distance " << c.distance << ", z " << c.origin.z;
        }
    }
}

TEST(FogLight, ASunBelowTheHorizonDoesNotReachExponentialFog) {
    const FogMedium fog = mediumOf(FogKind::Exponential, 0.1F, 10);
    Light sun;
    sun.kind = LightKind::Directional;
    sun.direction = {0, 0, 1};
    FoggedRays wave({{fog, {}, {1, 0, 0}, 10, sun}});
    const float before = wave.fog.rays().scattered.x[0];
    addFogLight(wave.fog, sun);
    EXPECT_EQ(wave.fog.rays().scattered.x[0], before);
    EXPECT_EQ(fogLightTransmittance(fog, sun, {0, 0, 5}), 0);
    sun.direction = {0, 0, -1};
    EXPECT_NEAR(fogLightTransmittance(fog, sun, {}), std::exp(-1), 1e-6);
    EXPECT_EQ(fogLightTransmittance(mediumOf(FogKind::Homogeneous, 1), sun, {}), 1);
}

/// With every sample counted.
float shaftsOf(FoggedRays& wave, const Light& light, int samples, float shift) {
    std::fill_n(wave.fog.rays().scattered.x, wave.rays.size(), 0.0F);
    const std::vector<float> shifts(wave.rays.size() + kWaveBlock, shift);
    FogShafts shafts;
    shafts.sample(wave.fog, light, {0, wave.rays.size()}, samples, shifts.data(), true);
    shafts.addAll(wave.fog);
    return wave.fog.rays().scattered.x[0];
}

TEST(FogShafts, AreEquiAngular) {
    Case c{mediumOf(FogKind::Homogeneous, 1e-9F), {}, {1, 0, 0}, 10, test::pointLight({5, 2, 0}, 1)};
    FoggedRays wave({c});
    const std::vector<float> shifts(kWaveBlock, 0.25F);
    FogShafts shafts;
    shafts.sample(wave.fog, c.light, {0, 1}, 1, shifts.data(), true);
    ASSERT_EQ(shafts.rays().size(), 1U);
    EXPECT_NEAR(shafts.rays().ox[0], 3.645934, 1e-5);
    const Vec3 toLight = normalize(Vec3{5 - 3.645934F, 2, 0});
    EXPECT_NEAR(shafts.rays().dx[0], toLight.x, 1e-5);
    EXPECT_NEAR(shafts.rays().dy[0], toLight.y, 1e-5);
}

TEST(FogShafts, THOROUGH_WithoutShadowsComeToTheClosedForm) {
    test::Random random(17);
    for (int f = 0; f < 60; ++f) {
        const FogKind kind = f % 2 == 0 ? FogKind::Homogeneous : FogKind::Exponential;
        const FogMedium fog = mediumOf(kind, std::pow(10.0F, random.number(-2, 0)),
                                       std::pow(10.0F, random.number(0.5F, 2)), random.number(-5, 5));
        Light light = test::pointLight(random.vector(20), 4 * static_cast<float>(test::kPi));
        light.kind = static_cast<LightKind>(f / 2 % 3);
        light.direction = random.unitVector();
        light.direction.z = -std::fabs(light.direction.z);
        light.cosOuter = random.number(0, 0.9F);
        light.cosInner = 1;
        for (int i = 0; i < 10; ++i) {
            Case c = randomLightCase(random, fog, light);
            c.distance = std::min(c.distance, 200.0F);
            c.origin.z = random.number(-20, 20);
            FoggedRays wave({c});
            wave.fog.rays().scattered.x[0] = 0;
            addFogLight(wave.fog, light);
            const float expected = wave.fog.rays().scattered.x[0];
            const float got = shaftsOf(wave, light, 1024, 0.5F);
            ASSERT_NEAR(got, expected, 2e-3 * std::max(1.0F, expected))
                << f << ' ' << i << " distance " << c.distance << ", slope " << c.slope();
        }
    }
}

} // namespace
} // namespace rtcore
