// Rays that meet area lights: as much light as samples of the lights find, with the densities of these.
#include "rtcore/lights/light_direction-inl.h"

#include "estimates.h"

#include <limits>
#include <vector>

namespace rtcore {
namespace light_hit {
namespace {

namespace plain = HWY_NAMESPACE;
using test::Estimate;
using test::expectMean;

constexpr float kMissed = std::numeric_limits<float>::infinity();

/// Irradiance over pi on a floor at the origin, by samples of the light.
template <LightKind kind>
Estimate bySamples(const Light& light, int count) {
    test::Random random(1);
    Estimate e;
    for (int i = 0; i < count; ++i) {
        const auto s =
            plain::sampleLightDirection<kind, float>(light, Vec3{}, random.number(0, 1), random.number(0, 1));
        e.add(static_cast<double>(s.irradiance.x * std::max(s.toLight.y, 0.0F)) / std::numbers::pi);
    }
    return e;
}
/// By rays of the floor that meet it.
template <LightKind kind>
Estimate byHits(const Light& light, int count) {
    test::Random random(2);
    Estimate e;
    for (int i = 0; i < count; ++i) {
        const float t = plain::hitLight<kind, float>(light, Vec3{}, test::cosineDirection(random));
        e.add(t < kMissed ? static_cast<double>(plain::radianceOf<kind>(light).r) : 0);
    }
    return e;
}
/// By one of each, weighted by the balance heuristic.
template <LightKind kind>
Estimate byBoth(const Light& light, int count) {
    test::Random random(3);
    Estimate e;
    const auto floorDensity = [](Vec3 d) { return std::max(d.y, 0.0F) / kPi; };
    for (int i = 0; i < count; ++i) {
        const auto s =
            plain::sampleLightDirection<kind, float>(light, Vec3{}, random.number(0, 1), random.number(0, 1));
        float sum = 0;
        if (s.density > 0)
            sum +=
                s.irradiance.x * floorDensity(s.toLight) * s.density / (s.density + floorDensity(s.toLight));
        const Vec3 d = test::cosineDirection(random);
        const float t = plain::hitLight<kind, float>(light, Vec3{}, d);
        if (t < kMissed) {
            const float density = plain::lightDirectionDensity<kind, float>(light, Vec3{}, d, t);
            sum += plain::radianceOf<kind>(light).r * floorDensity(d) / (density + floorDensity(d));
        }
        e.add(static_cast<double>(sum));
    }
    return e;
}
/// The integral of the density over all directions.
template <LightKind kind, typename Density>
Estimate integralOf(const Light& light, Density density) {
    test::Random random(4);
    Estimate e;
    for (int i = 0; i < 200000; ++i) {
        const Vec3 d = test::uniformDirection(random);
        const float t = plain::hitLight<kind, float>(light, Vec3{}, d);
        e.add(t < kMissed ? static_cast<double>(density(d, t)) * 4 * std::numbers::pi : 0);
    }
    return e;
}

TEST(SphereHits, HaveTheIrradianceOfTheClosedForm) {
    EXPECT_NEAR(test::sphereForm(0.5, 80), 0.054696, 1e-6);
    EXPECT_NEAR(test::sphereForm(0.5, 100), 0.011284, 1e-6);
    EXPECT_NEAR(test::sphereForm(0.9, 100), 0.165025, 1e-6);
    EXPECT_NEAR(test::sphereForm(0.2, 80), 0.006958, 1e-6);
    for (const auto& [sine, tilt] : std::vector<std::pair<double, double>>{{0.5, 0},
                                                                           {0.5, 60},
                                                                           {0.5, 80},
                                                                           {0.5, 90},
                                                                           {0.5, 100},
                                                                           {0.9, 0},
                                                                           {0.9, 80},
                                                                           {0.9, 100},
                                                                           {0.2, 30}}) {
        SCOPED_TRACE(testing::Message() << sine << ", " << tilt << " degrees");
        const Light light = test::sphereLight(sine, tilt);
        const double expected = test::sphereForm(sine, tilt);
        expectMean(bySamples<LightKind::Sphere>(light, 40000), expected);
        expectMean(byHits<LightKind::Sphere>(light, 100000), expected);
        expectMean(byBoth<LightKind::Sphere>(light, 40000), expected);
    }
}

TEST(RectangleHits, HaveTheIrradianceOfTheClosedForm) {
    for (const auto& [height, expected] : std::vector<std::pair<float, double>>{
             {0.1F, 0.968340}, {0.5F, 0.554126}, {1.0F, 0.239456}, {2.0F, 0.073478}}) {
        SCOPED_TRACE(height);
        const Light light = test::rectangleLight({0, height, 0});
        expectMean(bySamples<LightKind::Rectangle>(light, 20000), expected);
        expectMean(byHits<LightKind::Rectangle>(light, 50000), expected);
        expectMean(byBoth<LightKind::Rectangle>(light, 20000), expected);
    }
}

TEST(LightDensities, IntegrateToOneOverAllDirections) {
    for (const auto& [sine, tilt] : {std::pair{0.3, 20.0}, std::pair{0.99, 130.0}}) {
        const Light light = test::sphereLight(sine, tilt);
        expectMean(integralOf<LightKind::Sphere>(light,
                                                 [&](Vec3 d, float t) {
                                                     return plain::sampleDensity<LightKind::Sphere, float>(
                                                         light, Vec3{}, d, t);
                                                 }),
                   1);
    }
    for (const Vec3 middle : {Vec3{0, 1, 0}, Vec3{0, 0.05F, 0}, Vec3{2, 0.7F, 1}, Vec3{-1, 0.2F, 0.3F}}) {
        SCOPED_TRACE(testing::PrintToString(std::array{middle.x, middle.y, middle.z}));
        const Light light = test::rectangleLight(middle, 1, 1.5F);
        const auto byArea = [&](Vec3 d, float t) {
            return plain::sampleDensity<LightKind::Rectangle, float>(light, Vec3{}, d, t);
        };
        const auto bySolidAngle = [&](Vec3 d, float t) {
            return plain::lightDirectionDensity<LightKind::Rectangle, float>(light, Vec3{}, d, t);
        };
        expectMean(integralOf<LightKind::Rectangle>(light, byArea), 1);
        expectMean(integralOf<LightKind::Rectangle>(light, bySolidAngle), 1);
    }
}

TEST(LightDensities, OfASampleAreThoseOfTheRayThatMeetsIt) {
    test::Random random(5);
    const Light sphere = test::sphereLight(0.4, 30);
    const Light rectangle = test::rectangleLight({0.3F, 0.6F, -0.2F}), far = test::rectangleLight({3, 60, 2});
    int missed = 0, met = 0;
    for (int i = 0; i < 5000; ++i) {
        const float u = random.number(0, 1), v = random.number(0, 1);
        const auto onSphere = plain::sampleLightDirection<LightKind::Sphere, float>(sphere, Vec3{}, u, v);
        const float t = plain::hitLight<LightKind::Sphere, float>(sphere, Vec3{}, onSphere.toLight);
        if (t < kMissed) {
            EXPECT_EQ(
                (plain::lightDirectionDensity<LightKind::Sphere, float>(sphere, Vec3{}, onSphere.toLight, t)),
                onSphere.density);
            EXPECT_NEAR(onSphere.free, 0.9999F * t, 2e-3F * t);
        } else {
            ++missed; // at the rim
        }
        for (const Light* const light : {&rectangle, &far}) {
            const auto s = plain::sampleLightDirection<LightKind::Rectangle, float>(*light, Vec3{}, u, v);
            const float d = plain::hitLight<LightKind::Rectangle, float>(*light, Vec3{}, s.toLight);
            if (!(d < kMissed)) continue; // an edge
            const float density =
                plain::lightDirectionDensity<LightKind::Rectangle, float>(*light, Vec3{}, s.toLight, d);
            EXPECT_NEAR(s.free, 0.9999F * d, 1e-5F * d);
            EXPECT_NEAR(density / s.density, 1, light == &rectangle ? 0.0 : 1e-5); // far away by area
            ++met;
        }
    }
    EXPECT_GT(met, 9900);
    EXPECT_LT(missed, 25);
}

TEST(SphereHits, LieWhereTheRayEntersOrLeaves) {
    Light light = test::sphereLight(0.1, 0); // radius 1, 10 above
    const auto hit = [&](Vec3 origin, Vec3 direction) {
        return plain::hitLight<LightKind::Sphere, float>(light, origin, direction);
    };
    EXPECT_FLOAT_EQ(hit({}, {0, 1, 0}), 9);
    EXPECT_FLOAT_EQ(hit({0.6F, 0, 0}, {0, 1, 0}), 9.2F);
    EXPECT_EQ(hit({}, {0, -1, 0}), kMissed) << "behind the origin";
    EXPECT_EQ(hit({1.01F, 0, 0}, {0, 1, 0}), kMissed);
    EXPECT_FLOAT_EQ(hit({0, 9.5F, 0}, {0, 1, 0}), 1.5F) << "from inside";
    EXPECT_FLOAT_EQ(hit({0, 10, 0}, {1, 0, 0}), 1);
    light.position = {1e6F, 0, 0};
    EXPECT_FLOAT_EQ(hit({}, {1, 0, 0}), 999999);
}

TEST(SphereHits, FromInsideAreDenseInTheHalfThatIsSampled) {
    const Light light = test::sphereLight(2, 0); // radius 1, 0.5 above
    const auto density = [&](Vec3 d) {
        return plain::sampleDensity<LightKind::Sphere, float>(light, Vec3{}, d, 1.0F);
    };
    EXPECT_FLOAT_EQ(density({0.6F, 0.8F, 0}), 1 / (2 * kPi));
    EXPECT_EQ(density({0.6F, -0.8F, 0}), 0);
    expectMean(integralOf<LightKind::Sphere>(light, [&](Vec3 d, float) { return density(d); }), 1);
    expectMean(byBoth<LightKind::Sphere>(light, 40000), 1);
}

TEST(RectangleHits, AreOnTheShiningSideBetweenTheEdges) {
    const Light light = test::rectangleLight({0, 2, 0}, 2, 1); // x -1..1, z -0.5..0.5
    const auto hit = [&](Vec3 origin, Vec3 direction) {
        return plain::hitLight<LightKind::Rectangle, float>(light, origin, direction);
    };
    EXPECT_FLOAT_EQ(hit({0.99F, 0, 0.49F}, {0, 1, 0}), 2);
    EXPECT_FLOAT_EQ(hit({}, {0.6F, 0.8F, 0}), kMissed);
    EXPECT_FLOAT_EQ(hit({}, {0.28F, 0.96F, 0}), 2 / 0.96F);
    EXPECT_EQ(hit({1.01F, 0, 0}, {0, 1, 0}), kMissed);
    EXPECT_EQ(hit({0, 0, 0.51F}, {0, 1, 0}), kMissed);
    EXPECT_EQ(hit({0, 3, 0}, {0, -1, 0}), kMissed) << "its back";
    EXPECT_EQ(hit({0, 1, 0}, {0, -1, 0}), kMissed) << "away from it";
    EXPECT_EQ(hit({0, 2, 0}, {1, 0, 0}), kMissed) << "along it";
}

TEST(LightHits, AreOfAreaLightsAlone) {
    Light light;
    light.position = {0, 1, 0};
    const Vec3 up{0, 1, 0};
    EXPECT_EQ((plain::hitLight<LightKind::Point, float>(light, Vec3{}, up)), kMissed);
    EXPECT_EQ((plain::hitLight<LightKind::Directional, float>(light, Vec3{}, up)), kMissed);
    EXPECT_EQ((plain::hitLight<LightKind::Spot, float>(light, Vec3{}, up)), kMissed);
    EXPECT_EQ((plain::sampleLightDirection<LightKind::Point, float>(light, Vec3{}, 0.5F, 0.5F).density), 0);
    EXPECT_EQ((plain::sampleLightDirection<LightKind::Point, float>(light, Vec3{}, 0.5F, 0.5F).irradiance.x),
              1);
}

} // namespace
} // namespace light_hit
} // namespace rtcore
