/// Means of random numbers beside what they should be, and lights in closed form.
#pragma once

#include "rtcore/scene/light.h"

#include "support/random_numbers.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace test {

class Estimate {
  public:
    void add(double x) {
        ++count_;
        sum_ += x;
        squares_ += x * x;
    }
    double mean() const { return sum_ / count_; }
    double variance() const { return squares_ / count_ - mean() * mean(); }
    double deviation() const { return std::sqrt(variance() / count_); } ///< of the mean

  private:
    double count_ = 0, sum_ = 0, squares_ = 0;
};

/// Within 5 standard deviations, and what float loses. `max`: of the relative deviation, else the test says
/// nothing.
inline void expectMean(const Estimate& estimate, double expected, double max = 0.05) {
    EXPECT_LT(estimate.deviation(), max * expected);
    EXPECT_NEAR(estimate.mean(), expected, 5 * estimate.deviation() + 2e-5 * expected);
}

/// Uniform over the sphere.
inline rtcore::Vec3 uniformDirection(Random& random) {
    const float y = random.number(-1, 1), turn = random.number(0, 2 * std::numbers::pi_v<float>);
    const float ring = std::sqrt(1 - y * y);
    return {ring * std::cos(turn), y, ring * std::sin(turn)};
}
/// By the cosine with the y axis.
inline rtcore::Vec3 cosineDirection(Random& random) {
    const float square = random.number(0, 1), turn = random.number(0, 2 * std::numbers::pi_v<float>);
    const float ring = std::sqrt(square);
    return {ring * std::cos(turn), std::sqrt(1 - square), ring * std::sin(turn)};
}

/// A sphere light of radiance 1, radius / sine away from the origin, `tilt` degrees off the y axis.
inline rtcore::Light sphereLight(double sine, double tilt) {
    const double angle = tilt * std::numbers::pi / 180;
    rtcore::Light light;
    light.kind = rtcore::LightKind::Sphere;
    light.position = {static_cast<float>(std::sin(angle) / sine), static_cast<float>(std::cos(angle) / sine),
                      0};
    light.radius = 1;
    light.intensity = rtcore::kWhite * std::numbers::pi_v<float>;
    return light;
}
/// A rectangle light of radiance 1, shining down, its middle at `middle`.
inline rtcore::Light rectangleLight(rtcore::Vec3 middle, float width = 1, float height = 1) {
    rtcore::Light light;
    light.kind = rtcore::LightKind::Rectangle;
    light.position = middle;
    light.direction = {0, -1, 0};
    light.right = {1, 0, 0};
    light.width = width;
    light.height = height;
    light.intensity = rtcore::kWhite * (width * height);
    return light;
}

/// Irradiance over pi times the radiance of sphereLight() on a floor (y up), also where it is partly below
/// it.
inline double sphereForm(double s, double tilt) {
    const double b = tilt * std::numbers::pi / 180;
    if (std::cos(b) >= s) return s * s * std::cos(b);
    const double square = 1 / (s * s), x = std::sqrt(square - 1), y = -x / std::tan(b);
    const double w = std::sin(b) * std::sqrt(1 - y * y);
    return ((std::cos(b) * std::acos(y) - x * w) / square + std::atan(w / x)) / std::numbers::pi;
}

} // namespace test
