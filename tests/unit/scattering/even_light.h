/// Surfaces under even light of radiance 1, and whether directions fall by their density.
#pragma once

#include "rtcore/sampling/sample_id.h"
#include "rtcore/scattering/lambert-inl.h"
#include "support/random_numbers.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

namespace test {

using rtcore::Vec3;
using rtcore::Vec3d;
using Square = rtcore::HWY_NAMESPACE::SquarePointOf<float>;
using Scattered = rtcore::HWY_NAMESPACE::Scattering<float>;

inline const Vec3 kTilted = rtcore::normalize(Vec3{0.3F, -0.5F, 0.8F}); ///< a normal along no axis

/// The direction with this cosine to kTilted, at an azimuth along no axis.
inline Vec3 viewerAt(float cosine) {
    const rtcore::Basis basis = rtcore::basisAround(kTilted);
    const Vec3 across = basis.tangent * 0.6F + basis.bitangent * -0.8F;
    return rtcore::normalize(kTilted * cosine + across * std::sqrt(1 - cosine * cosine));
}

/// The fraction of even light that is reflected, by `count` sampled directions: the mean of f cos / density.
template <typename Sample, typename Scatter>
Vec3d sampledAlbedo(std::uint32_t count, Sample sample, Scatter scatter) {
    Vec3d sum;
    for (std::uint32_t i = 0; i < count; ++i) {
        const auto id = rtcore::SampleId{5, 6, i};
        const auto point = pointInSequence(id, 0, rtcore::SampleDimension::Direction, 0);
        const float lobe = pointInSequence(id, 0, rtcore::SampleDimension::Lobe, 0).u;
        const Vec3 direction = sample(lobe, Square{point.u, point.v});
        const Scattered s = scatter(direction);
        const double cosine = dot(kTilted, direction);
        if (!(cosine > 0)) continue;
        const double factor = cosine / s.density;
        sum += Vec3d{s.reflectance.x * factor, s.reflectance.y * factor, s.reflectance.z * factor};
    }
    return sum * (1.0 / count);
}

/// Integral of f(direction) over the hemisphere about kTilted, by the midpoints of 2 side x side cells.
template <typename Function>
double overHemisphere(int side, Function f) {
    const rtcore::Basis basis = rtcore::basisAround(kTilted);
    const double step = std::numbers::pi / 2 / side;
    double sum = 0;
    for (int i = 0; i < side; ++i) {
        const double angle = (i + 0.5) * step, sine = std::sin(angle);
        double ring = 0;
        for (int k = 0; k < 2 * side; ++k) {
            const double azimuth = (k + 0.5) * std::numbers::pi / side;
            const auto x = static_cast<float>(sine * std::cos(azimuth));
            const auto y = static_cast<float>(sine * std::sin(azimuth));
            ring +=
                f(basis.tangent * x + basis.bitangent * y + kTilted * static_cast<float>(std::cos(angle)));
        }
        sum += ring * sine * step * std::numbers::pi / side;
    }
    return sum;
}

/// The excess of chi-square over its mean, in standard deviations.
inline double chiSquareExcess(const std::vector<double>& found, const std::vector<double>& expected) {
    double sum = 0;
    int degrees = -1;
    for (std::size_t i = 0; i < found.size(); ++i) {
        if (expected[i] <= 0) continue;
        sum += (found[i] - expected[i]) * (found[i] - expected[i]) / expected[i];
        ++degrees;
    }
    return (sum - degrees) / std::sqrt(2.0 * degrees);
}

/// chiSquareExcess() of 100000 directions against their density above the surface, in 12 x 24 parts of the
/// hemisphere about kTilted; what falls rarely or below it counts together.
template <typename Sample, typename Density>
double excessOfSamples(Sample sample, Density density) {
    constexpr int kSamples = 100000, kRings = 12, kSectors = 24, kFine = 12;
    constexpr double kFew = 10;
    const rtcore::Basis basis = rtcore::basisAround(kTilted);
    const auto part = [&](Vec3 d) -> std::size_t {
        const double height = dot(d, kTilted);
        if (!(height > 0)) return kRings * kSectors;
        const double angle = std::acos(std::min(height, 1.0));
        const double azimuth = std::atan2(dot(d, basis.bitangent), dot(d, basis.tangent));
        const auto ring = std::min(static_cast<int>(angle / (std::numbers::pi / 2) * kRings), kRings - 1);
        const auto sector = static_cast<int>((azimuth / (2 * std::numbers::pi) + 1) * kSectors) % kSectors;
        return static_cast<std::size_t>(ring * kSectors + sector);
    };
    std::vector<double> expected(kRings * kSectors + 1, 0), found(kRings * kSectors + 1, 0);
    const double cell = std::numbers::pi / 2 / (kRings * kFine),
                 turn = 2 * std::numbers::pi / (kSectors * kFine);
    for (int i = 0; i < kRings * kFine; ++i) {
        const double angle = (i + 0.5) * cell, sine = std::sin(angle);
        for (int k = 0; k < kSectors * kFine; ++k) {
            const double azimuth = (k + 0.5) * turn;
            const Vec3 d = basis.tangent * static_cast<float>(sine * std::cos(azimuth)) +
                           basis.bitangent * static_cast<float>(sine * std::sin(azimuth)) +
                           kTilted * static_cast<float>(std::cos(angle));
            expected[static_cast<std::size_t>(i / kFine * kSectors + k / kFine)] +=
                density(d) * sine * cell * turn * kSamples;
        }
    }
    Random random(3);
    for (int i = 0; i < kSamples; ++i) {
        const float lobe = random.number(0, 0.9999999F), u = random.number(0, 0.9999999F);
        const float v = random.number(0, 0.9999999F);
        found[part(sample(lobe, Square{u, v}))] += 1;
    }
    double certain = 0;
    for (std::size_t i = 0; i + 1 < expected.size(); ++i) {
        if (expected[i] < kFew) {
            found.back() += found[i];
            expected[i] = found[i] = 0;
        }
        certain += expected[i];
    }
    expected.back() = std::max(kSamples - certain, 0.0);
    if (expected.back() < kFew) expected.back() = 0;
    return chiSquareExcess(found, expected);
}

} // namespace test
