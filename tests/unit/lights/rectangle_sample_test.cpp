// Rectangle lights by solid angle: the map, its density, and how much less noise there is.
#include "rtcore/lights/light_direction-inl.h"

#include "estimates.h"

#include <cmath>
#include <utility>
#include <vector>

namespace rtcore {
namespace rectangle_sample {
namespace {

namespace plain = HWY_NAMESPACE;
using test::Estimate;

/// A rectangle in the plane z = h, seen from the origin, in double.
struct ExactRectangle {
    double x0, x1, y0, y1, h;

    static double corner(double x, double y, double h) {
        return std::atan(x * y / (h * std::sqrt(x * x + y * y + h * h)));
    }
    double until(double x) const {
        return corner(x, y1, h) - corner(x, y0, h) - corner(x0, y1, h) + corner(x0, y0, h);
    }
    double solidAngle() const { return until(x1); }
    /// The part of a column's solid angle below y.
    double partOfColumn(double x, double y) const {
        const auto sine = [&](double v) { return v / std::sqrt(x * x + h * h + v * v); };
        return (sine(y) - sine(y0)) / (sine(y1) - sine(y0));
    }
};

struct Setting {
    Light light;
    Vec3 position;
    ExactRectangle exact;
};
/// Somewhere before a rectangle, which lies anyhow.
Setting randomSetting(test::Random& random) {
    Setting s;
    s.light = test::rectangleLight(random.vector(2), random.number(0.1F, 3), random.number(0.1F, 3));
    s.light.direction = random.unitVector();
    s.light.right = basisAround(s.light.direction).tangent;
    const float x = random.number(-3, 3), y = random.number(-3, 3);
    const float height = std::pow(10.0F, random.number(-2, 1));
    const Vec3 up = cross(s.light.direction, s.light.right);
    s.position = s.light.position + s.light.right * x + up * y + s.light.direction * height;
    const auto number = [](float v) { return static_cast<double>(v); };
    const double w = number(s.light.width) / 2, h = number(s.light.height) / 2;
    // As the numbers in float lie.
    const Vec3 offset = s.light.position - s.position;
    const double cx = number(dot(offset, s.light.right)), cy = number(dot(offset, up));
    s.exact = {cx - w, cx + w, cy - h, cy + h, -number(dot(offset, s.light.direction))};
    return s;
}

TEST(RectangleBySolidAngle, KnowsTheSolidAngle) {
    test::Random random(1);
    int seen = 0;
    for (int i = 0; i < 20000; ++i) {
        const Setting s = randomSetting(random);
        const double expected = s.exact.solidAngle();
        const float got = plain::seenRectangle<float>(s.light, s.position).solidAngle;
        ASSERT_NEAR(static_cast<double>(got), expected, 1e-6)
            << s.exact.x0 << ' ' << s.exact.x1 << ' ' << s.exact.y0 << ' ' << s.exact.y1 << ' ' << s.exact.h;
        if (expected > 1e-3) ++seen;
    }
    EXPECT_GT(seen, 10000);
}

// Urena, Fajardo and King's map, inverted: the point at u, v has the part u of the solid angle on its left,
// and the part v of its column below.
TEST(RectangleBySolidAngle, DividesTheSolidAngleEvenly) {
    test::Random random(2);
    Estimate columns, rows;
    int count = 0;
    for (int i = 0; i < 20000; ++i) {
        const Setting s = randomSetting(random);
        const float u = random.number(0, 1), v = random.number(0, 1);
        const auto sample = plain::sampleRectangleBySolidAngle<float>(s.light, s.position, u, v);
        if (s.exact.solidAngle() < 2.2e-3) continue;
        ++count;
        const Vec3 up = cross(s.light.direction, s.light.right);
        const double front = -static_cast<double>(dot(sample.toLight, s.light.direction));
        const double x = static_cast<double>(dot(sample.toLight, s.light.right)) / front * s.exact.h;
        const double y = static_cast<double>(dot(sample.toLight, up)) / front * s.exact.h;
        const double column = std::fabs(s.exact.until(x) / s.exact.solidAngle() - static_cast<double>(u));
        const double row = std::fabs(s.exact.partOfColumn(x, y) - static_cast<double>(v));
        columns.add(column);
        rows.add(row);
        ASSERT_LT(column, 0.015) << s.exact.solidAngle() << " sr"; // grazing
        ASSERT_LT(row, 1e-4);
    }
    EXPECT_GT(count, 10000);
    EXPECT_LT(columns.mean(), 2e-4);
    EXPECT_LT(rows.mean(), 1e-6);
}

// The variance of one sample where nothing hides, unit square at a height over a floor: by area that of the
// cosines of both ends and of the distance, by solid angle that of one cosine alone.
TEST(RectangleBySolidAngle, HasFarLessNoiseThanByArea) {
    for (const auto& [height, factor] : std::vector<std::pair<float, double>>{{0.05F, 150}, {0.5F, 15}}) {
        const Light light = test::rectangleLight({0, height, 0});
        test::Random random(3);
        Estimate byArea, bySolidAngle;
        for (int i = 0; i < 200000; ++i) {
            const float u = random.number(0, 1), v = random.number(0, 1);
            const auto area = plain::sampleLight<LightKind::Rectangle, float>(
                light, Vec3{}, plain::Stratum<float>{u, v, 1, 0});
            byArea.add(static_cast<double>(area.irradiance.x * area.toLight.y));
            const auto angle = plain::sampleLightDirection<LightKind::Rectangle, float>(light, Vec3{}, u, v);
            bySolidAngle.add(static_cast<double>(angle.irradiance.x * angle.toLight.y));
        }
        EXPECT_GT(byArea.variance() / bySolidAngle.variance(), factor) << height;
        EXPECT_NEAR(byArea.mean(), bySolidAngle.mean(), 5 * byArea.deviation());
    }
}

TEST(RectangleBySolidAngle, GivesNothingBehindIt) {
    const Light light = test::rectangleLight({0, 1, 0});
    for (const float y : {1.0F, 1.5F, 100.0F}) {
        const auto s =
            plain::sampleLightDirection<LightKind::Rectangle, float>(light, Vec3{0.1F, y, 0}, 0.3F, 0.6F);
        EXPECT_EQ(s.irradiance.x, 0);
        EXPECT_EQ(s.density, 0);
    }
}

TEST(RectangleBySolidAngle, IsFiniteNearTheLightAndFarAway) {
    const Light light = test::rectangleLight({0, 1, 0});
    test::Random random(4);
    for (int i = 0; i < 20000; ++i) {
        const float height = std::pow(10.0F, random.number(-6, 6));
        const Vec3 position{random.number(-2, 2), 1 - height, random.coin() ? 0.5F : random.number(-2, 2)};
        const auto s = plain::sampleLightDirection<LightKind::Rectangle, float>(
            light, position, random.number(0, 1), random.number(0, 1));
        ASSERT_TRUE(isFinite(s.toLight) && isFinite(s.irradiance) && s.irradiance.x >= 0) << height;
        ASSERT_LT(s.irradiance.x, 6.2832F);
        ASSERT_NEAR(length(s.toLight), 1, 1e-5F);
        ASSERT_EQ(s.density > 0, position.y < 1);
    }
}

} // namespace
} // namespace rectangle_sample
} // namespace rtcore
