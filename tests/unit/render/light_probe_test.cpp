// Measured light: closed forms, an estimate that shares nothing with it, and standard errors that are true.
#include "rtcore/render/light_probe.h"

#include "support/small_scene.h"

#include <gtest/gtest.h>

#include <array>
#include <atomic>
#include <bit>
#include <cmath>
#include <limits>
#include <memory>
#include <random>
#include <utility>
#include <vector>

namespace rtcore {
namespace {

constexpr WhitePoint kOnGround{{0, 1e-4F, 0}, {0, 1, 0}};

MeasuredLight measureIn(const test::TracedScene& traced, const WhitePoint& point, const ProbeEffort& effort,
                        int seed = 0, int threads = 1) {
    RenderSettings settings;
    settings.path.seed = seed;
    const ProbedLight whole{&traced.scene};
    LightProbe probe;
    probe.begin({&whole, 1}, traced.tracer, settings);
    RenderControl control;
    control.threads = threads;
    std::vector<MeasuredLight> measured;
    EXPECT_TRUE(probe.irradiance({&point, 1}, effort, control, measured));
    return measured.at(0);
}

Scene ground(float albedo = 0.5F) {
    test::SceneBuilder b;
    b.square({0, 0, 0}, {0, 1, 0}, 50, b.material(test::matte(albedo)));
    return b.finish();
}

std::shared_ptr<const Environment> evenSky(float radiance) {
    return std::make_shared<const Environment>(
        Environment::fromEquirectangular(HdrImage(8, 4, {radiance, radiance, radiance}), "even"));
}

/// A room of 6 x 5 x 3 with a window of 1.5 x 1.2 in the wall x = 0, under an even sky of radiance 3.
constexpr float kWall = 0.6F, kSky = 3;
constexpr WhitePoint kOnDesk{{2, 0.85F, 2.2F}, {0, 1, 0}};

Scene roomWithWindow(float albedo = kWall) {
    test::SceneBuilder b;
    const std::uint32_t wall = b.material(test::matte(albedo));
    constexpr float kY0 = 0.9F, kY1 = 2.1F, kZ0 = 1.5F, kZ1 = 3;
    b.quad({0, 0, 0}, {0, 0, 5}, {6, 0, 5}, {6, 0, 0}, wall);
    b.quad({0, 3, 0}, {6, 3, 0}, {6, 3, 5}, {0, 3, 5}, wall);
    b.quad({6, 0, 0}, {6, 0, 5}, {6, 3, 5}, {6, 3, 0}, wall);
    b.quad({0, 0, 0}, {6, 0, 0}, {6, 3, 0}, {0, 3, 0}, wall);
    b.quad({0, 0, 5}, {0, 3, 5}, {6, 3, 5}, {6, 0, 5}, wall);
    b.quad({0, 0, 0}, {0, 3, 0}, {0, 3, kZ0}, {0, 0, kZ0}, wall);
    b.quad({0, 0, kZ1}, {0, 3, kZ1}, {0, 3, 5}, {0, 0, 5}, wall);
    b.quad({0, 0, kZ0}, {0, kY0, kZ0}, {0, kY0, kZ1}, {0, 0, kZ1}, wall);
    b.quad({0, kY1, kZ0}, {0, 3, kZ0}, {0, 3, kZ1}, {0, kY1, kZ1}, wall);
    b.scene.environments = {evenSky(kSky)};
    return b.finish();
}

TEST(LightProbe, APointLightOverAPlaneIsItsIntensityOverTheSquare) {
    Scene scene = ground();
    scene.lights = {test::pointLight({1, 2, 0}, 30)};
    const test::TracedScene traced(std::move(scene));
    const MeasuredLight light = measureIn(traced, kOnGround, {});
    EXPECT_NEAR(light.luminance, 30 * 2 / std::pow(5, 1.5), 1e-3);
    EXPECT_LT(light.error, 1e-4) << "nothing else is there";
    EXPECT_NEAR(light.colour[2], light.luminance, 1e-3);
    EXPECT_EQ(light.paths, 8192U) << "it is known at once";
    WhitePoint below = kOnGround;
    below.position.y = -1e-4F;
    below.normal = {0, -1, 0};
    EXPECT_EQ(measureIn(traced, below, {}).luminance, 0);
}

/// The irradiance over pi L of an element below the middle of a rectangle of 2a x 2b, one unit above it.
double formFactor(double a, double b) {
    const double p = std::sqrt(1 + a * a), q = std::sqrt(1 + b * b);
    return 4 / (2 * test::kPi) * (a / p * std::atan(b / p) + b / q * std::atan(a / q));
}

TEST(LightProbe, ARectangleHasItsFormFactor) {
    constexpr float kRadiance = 4;
    const double expected = test::kPi * static_cast<double>(kRadiance) * formFactor(0.7, 0.4);
    constexpr WhitePoint kBelow{{0, 0, 0}, {0, 1, 0}};
    const auto lowGround = [] {
        test::SceneBuilder b;
        b.square({0, -0.01F, 0}, {0, 1, 0}, 50, b.material(test::matte(0)));
        return b;
    };
    test::SceneBuilder b = lowGround();
    b.quad({-0.7F, 1, -0.4F}, {0.7F, 1, -0.4F}, {0.7F, 1, 0.4F}, {-0.7F, 1, 0.4F},
           b.material(test::emitter({kRadiance, kRadiance, kRadiance})));
    const MeasuredLight emitted = measureIn(test::TracedScene(b.finish()), kBelow, {.relativeError = 1e-3});
    EXPECT_NEAR(emitted.luminance, expected, 3 * emitted.error);
    EXPECT_LT(emitted.error, 2e-3 * expected);

    Scene scene = lowGround().finish();
    Light light;
    light.kind = LightKind::Rectangle;
    light.position = {0, 1, 0};
    light.direction = {0, -1, 0};
    light.right = {1, 0, 0};
    light.width = 1.4F;
    light.height = 0.8F;
    light.intensity = kWhite * (kRadiance * light.width * light.height);
    scene.lights = {light};
    const MeasuredLight lit = measureIn(test::TracedScene(std::move(scene)), kBelow, {.relativeError = 1e-3});
    EXPECT_NEAR(lit.luminance, expected, 3 * lit.error);
}

TEST(LightProbe, UnderAnEvenSkyItIsPiTimesItsRadiance) {
    Scene scene = ground();
    scene.environments = {evenSky(2)};
    const MeasuredLight light = measureIn(test::TracedScene(std::move(scene)), kOnGround, {});
    EXPECT_NEAR(light.luminance, 2 * test::kPi, 3 * light.error + 1e-4);
    Scene grey = ground();
    grey.ambient = {2, 2, 2};
    const MeasuredLight ambient = measureIn(test::TracedScene(std::move(grey)), kOnGround, {});
    EXPECT_NEAR(ambient.luminance, 2 * test::kPi, 3 * ambient.error + 1e-4);
}

/// By random walks alone, which end in the sky: its mean and its standard error.
std::pair<double, double> walkedIrradiance(const test::TracedScene& traced, const WhitePoint& point,
                                           std::size_t walks) {
    std::mt19937_64 random(7);
    std::uniform_real_distribution<double> uniform(0, 1);
    const auto before = [&](Vec3 normal) {
        const double u = uniform(random), angle = 2 * test::kPi * uniform(random), r = std::sqrt(u);
        const auto [t, b] = basisAround(normal);
        return normalize(t * static_cast<float>(r * std::cos(angle)) +
                         b * static_cast<float>(r * std::sin(angle)) +
                         normal * static_cast<float>(std::sqrt(1 - u)));
    };
    constexpr float kFar = std::numeric_limits<float>::max();
    RayWave rays, next;
    HitWave hits;
    for (std::size_t i = 0; i < walks; ++i) rays.push({point.position, 0, before(point.normal), kFar});
    double weight = static_cast<double>(kSky), sum = 0, squares = 0;
    for (int bounce = 0; bounce < 60 && !rays.empty(); ++bounce) {
        traced.tracer.intersect(RayKind::Scattered, rays, hits);
        next.clear();
        for (std::size_t i = 0; i < rays.size(); ++i) {
            const Ray ray = rays.ray(i);
            if (!hits.isHit(i)) {
                sum += weight;
                squares += weight * weight;
                continue;
            }
            Vec3 normal = normalize(traced.scene.mesh().geometricNormal(hits.triangle[i]));
            if (dot(normal, ray.direction) > 0) normal = -normal;
            next.push({ray.origin + ray.direction * hits.t[i] + normal * 1e-4F, 0, before(normal), kFar});
        }
        weight *= static_cast<double>(kWall);
        std::swap(rays, next);
    }
    const auto n = static_cast<double>(walks);
    const double mean = sum / n;
    return {test::kPi * mean, test::kPi * std::sqrt((squares / n - mean * mean) / n)};
}

TEST(LightProbe, ARoomWithAWindowIsAsRandomWalksFindIt) {
    const test::TracedScene traced(roomWithWindow());
    const auto [walked, error] = walkedIrradiance(traced, kOnDesk, 100'000);
    const MeasuredLight light = measureIn(traced, kOnDesk, {.relativeError = 0.004});
    EXPECT_NEAR(light.luminance, walked, 3 * std::hypot(error, light.error));
    EXPECT_LE(light.error, 0.004 * light.luminance);
    EXPECT_LT(error, 0.02 * walked) << "else it says little";
}

/// The spread of 100 seeds over the stated variance: as chi-square of 99 degrees of freedom.
double spreadOverStated(const test::TracedScene& traced, const ProbeEffort& effort) {
    constexpr int kSeeds = 100;
    double sum = 0, squares = 0, stated = 0;
    for (int seed = 0; seed < kSeeds; ++seed) {
        const MeasuredLight light = measureIn(traced, kOnDesk, effort, seed);
        sum += light.luminance;
        squares += light.luminance * light.luminance;
        stated += light.error * light.error / kSeeds;
    }
    return (squares - sum * sum / kSeeds) / stated;
}

TEST(LightProbe, ItsStandardErrorIsTheSpreadOfSeeds) {
    const test::TracedScene traced(roomWithWindow(0.2F));
    for (const ProbeEffort& effort : {ProbeEffort{.relativeError = 1}, ProbeEffort{0, 512}}) {
        const double spread = spreadOverStated(traced, effort);
        // A thousandth is below, and another above.
        EXPECT_GT(spread, 61.1) << effort.paths;
        EXPECT_LT(spread, 148.2) << effort.paths;
    }
}

TEST(LightProbe, GlancesByFewPaths) {
    const test::TracedScene traced(roomWithWindow());
    const MeasuredLight exact = measureIn(traced, kOnDesk, {.relativeError = 0.004});
    for (const std::uint32_t paths : {1U, 512U, 513U, 4096U}) {
        const MeasuredLight light = measureIn(traced, kOnDesk, {0, paths});
        EXPECT_EQ(light.paths, std::max(512U, std::bit_ceil(paths)));
        EXPECT_NEAR(light.luminance, exact.luminance, 4 * std::hypot(light.error, exact.error)) << paths;
        EXPECT_GT(light.error, exact.error);
    }
}

TEST(LightProbe, HasTheSameBitsForAnyNumberOfThreads) {
    const test::TracedScene traced(roomWithWindow());
    const std::vector<WhitePoint> points{kOnDesk, {{4, 0.85F, 4}, {0, 1, 0}}, {{5, 1.5F, 1}, {-1, 0, 0}}};
    const ProbedLight whole{&traced.scene};
    std::vector<std::vector<MeasuredLight>> all;
    for (const int threads : {1, 2, 7}) {
        LightProbe probe;
        probe.begin({&whole, 1}, traced.tracer, {});
        RenderControl control;
        control.threads = threads;
        ASSERT_TRUE(probe.irradiance(points, {.relativeError = 0.01}, control, all.emplace_back()));
        EXPECT_EQ(control.tilesDone, 3U);
        EXPECT_EQ(control.tiles, 3U);
    }
    for (std::size_t i = 0; i < points.size(); ++i) {
        for (std::size_t k = 1; k < all.size(); ++k) {
            EXPECT_EQ(all[k][i].colour, all[0][i].colour);
            EXPECT_EQ(all[k][i].error, all[0][i].error);
            EXPECT_EQ(all[k][i].paths, all[0][i].paths);
        }
        EXPECT_LE(all[0][i].error, 0.01 * all[0][i].luminance);
    }
}

/// Cancels after so many waves.
class CancellingTracer final : public RayTracer {
  public:
    CancellingTracer(const RayTracer& of, int waves, RenderControl& control)
        : of_(of), left_(waves), control_(control) {}
    void intersect(RayKind kind, const RayWave& rays, HitWave& hits) const override {
        of_.intersect(kind, rays, hits);
        if (--left_ == 0) control_.cancel = true;
    }
    void occluded(RayKind kind, const RayWave& rays, std::vector<std::uint8_t>& occluded) const override {
        of_.occluded(kind, rays, occluded);
    }
    Box3 bounds() const override { return of_.bounds(); }
    int left() const { return left_; }

  private:
    const RayTracer& of_;
    mutable std::atomic<int> left_;
    RenderControl& control_;
};

TEST(LightProbe, IsCancelled) {
    const test::TracedScene traced(roomWithWindow());
    for (const int waves : {1, 30, 300}) {
        RenderControl control;
        control.threads = 1;
        const CancellingTracer tracer(traced.tracer, waves, control);
        const ProbedLight whole{&traced.scene};
        LightProbe probe;
        probe.begin({&whole, 1}, tracer, {});
        std::vector<MeasuredLight> measured;
        EXPECT_FALSE(probe.irradiance({&kOnDesk, 1}, {.relativeError = 0}, control, measured)) << waves;
        EXPECT_GT(tracer.left(), -100) << "it ends soon";
    }
}

TEST(LightProbe, ThereIsNoLightInSolidsAndNothingOfNoPoints) {
    test::SceneBuilder b;
    b.box({-1, -1, -1}, {1, 1, 1}, b.material(test::matte(0.8F)));
    b.scene.environments = {evenSky(2)};
    b.scene.lights = {test::pointLight({0, 5, 0}, 30)};
    const test::TracedScene traced(b.finish());
    const MeasuredLight inside = measureIn(traced, {{0, 0, 0}, {0, 1, 0}}, {});
    EXPECT_EQ(inside.luminance, 0);
    EXPECT_EQ(inside.error, 0);
    EXPECT_EQ(inside.paths, 8192U) << "there is no use in going on";
    const ProbedLight whole{&traced.scene};
    LightProbe probe;
    probe.begin({&whole, 1}, traced.tracer, {});
    RenderControl control;
    std::vector<MeasuredLight> measured{inside};
    EXPECT_TRUE(probe.irradiance({}, {}, control, measured));
    EXPECT_TRUE(measured.empty());
}

TEST(LightProbe, PartsAddUpInUnitsOfTheirOwn) {
    Scene sky = ground(), bulb = ground();
    sky.environments = {evenSky(1)};
    bulb.lights = {test::pointLight({0, 2, 0}, 8)};
    const test::TracedScene traced(std::move(sky));
    const std::array<ProbedLight, 2> parts{{{&traced.scene, 20}, {&bulb, 600}}};
    LightProbe probe;
    probe.begin(parts, traced.tracer, {});
    RenderControl control;
    std::vector<MeasuredLight> measured;
    ASSERT_TRUE(probe.irradiance({&kOnGround, 1}, {}, control, measured));
    ASSERT_EQ(measured[0].parts.size(), 2U);
    EXPECT_NEAR(measured[0].parts[0], 20 * test::kPi, 3 * measured[0].error);
    EXPECT_NEAR(measured[0].parts[1], 600 * 2, 0.5);
    EXPECT_DOUBLE_EQ(measured[0].luminance, measured[0].parts[0] + measured[0].parts[1]);
}

TEST(LightProbe, RadianceIsThatOfTheCamerasRay) {
    Scene scene = ground(0.4F);
    scene.environments = {evenSky(2)};
    const test::TracedScene traced(std::move(scene));
    const ProbedLight whole{&traced.scene, 100};
    LightProbe probe;
    probe.begin({&whole, 1}, traced.tracer, {});
    constexpr float kFar = std::numeric_limits<float>::max();
    const std::vector<Ray> rays{{{0, 1, 0}, 0, normalize(Vec3{1, -1, 0}), kFar},
                                {{0, 1, 0}, 0, normalize(Vec3{1, 1, 0}), kFar}};
    RenderControl control;
    std::vector<MeasuredLight> measured;
    ASSERT_TRUE(probe.radiance(rays, {.relativeError = 0.002}, control, measured));
    EXPECT_NEAR(measured[0].luminance, 100 * 0.4 * 2, 3 * measured[0].error + 1e-3);
    EXPECT_NEAR(measured[1].luminance, 200, 1e-3);
    EXPECT_EQ(measured[1].error, 0);
}

TEST(SideSeen, IsOffTheSurfaceThatTheRayMeets) {
    const test::TracedScene traced(ground());
    constexpr float kFar = std::numeric_limits<float>::max();
    const auto above = sideSeen(traced.scene, traced.tracer, {{1, 3, 2}, 0, {0, -1, 0}, kFar});
    ASSERT_TRUE(above);
    EXPECT_EQ(above->normal, (Vec3{0, 1, 0}));
    EXPECT_GT(above->position.y, 0);
    EXPECT_LT(above->position.y, 0.01F);
    const auto below = sideSeen(traced.scene, traced.tracer, {{1, -3, 2}, 0, {0, 1, 0}, kFar});
    ASSERT_TRUE(below);
    EXPECT_EQ(below->normal.y, -1);
    EXPECT_LT(below->position.y, 0);
    EXPECT_FALSE(sideSeen(traced.scene, traced.tracer, {{1, 3, 2}, 0, {0, 1, 0}, kFar}));
}

} // namespace
} // namespace rtcore
