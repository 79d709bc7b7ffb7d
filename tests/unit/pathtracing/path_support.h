/// Means of paths with their standard errors.
#pragma once

#include "rtcore/pathtracing/path_integrator.h"
#include "rtcore/pathtracing/sampling_strategy.h"
#include "rtcore/pathtracing/visibility_samples.h"

#include "support/small_scene.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace test {

/// Settings of paths, and what finds the light.
struct PathLimits : rtcore::PathSettings {
    rtcore::SamplingStrategy strategy = rtcore::SamplingStrategy::Both;
};

/// The mean of independent samples.
struct PathMean {
    std::array<double, 3> mean{}, error{}; ///< error: of the mean
};

/// A scene whose light is measured by paths.
class PathScene {
  public:
    explicit PathScene(rtcore::Scene scene, rtcore::RenderSettings with = exactSettings(),
                       rtcore::EmitterLight emitters = rtcore::EmitterLight::On)
        : traced(std::move(scene)), settings(with) {
        settings.path.emitters = emitters;
        materials.prepare(traced.scene, settings, rtcore::Colour{});
        lights.prepare(traced.scene, settings, traced.tracer.bounds());
    }

    /// Learns what points see, by `side` x `side` rays from `eye` through a square around the origin.
    void learn(rtcore::Vec3 eye, float half, int side, int threads = 1) {
        rtcore::RayWave rays;
        const auto [across, up] = rtcore::basisAround(rtcore::normalize(eye));
        const auto step = [&](int k) {
            return half * (2 * (static_cast<float>(k) + 0.5F) / static_cast<float>(side) - 1);
        };
        for (int y = 0; y < side; ++y) {
            for (int x = 0; x < side; ++x)
                rays.push({eye, 0, rtcore::normalize(across * step(x) + up * step(y) - eye),
                           std::numeric_limits<float>::max()});
        }
        lights.setVisibility(rtcore::learnVisibility(
            {traced.scene, traced.tracer, settings, materials, lights, threads}, rays));
    }

    /// The radiance of each sample; all along the same rays, or one ray each.
    std::vector<rtcore::Colour> trace(const rtcore::RayWave& rays, std::vector<rtcore::SampleId> samples,
                                      const PathLimits& limits) const {
        rtcore::PathIntegrator integrator;
        rtcore::RenderSettings with = settings;
        with.path = limits;
        integrator.begin({traced.scene, traced.tracer, with, materials, lights, limits.strategy});
        integrator.trace(rays, samples);
        std::vector<rtcore::Colour> radiance;
        for (std::size_t i = 0; i < samples.size(); ++i)
            radiance.push_back(integrator.radiance().colourAt(i));
        return radiance;
    }
    /// Along one ray, by `count` samples in waves of 8192, each of a pixel of its own: so they are
    /// independent.
    PathMean see(rtcore::Vec3 eye, rtcore::Vec3 direction, std::uint32_t count,
                 const PathLimits& limits = {}) const {
        return mean(count, limits, [&](std::uint32_t) { return std::pair(eye, direction); });
    }
    /// `ray(i)`: origin and direction of sample i.
    template <typename MakeRay>
    PathMean mean(std::uint32_t count, const PathLimits& limits, MakeRay&& ray) const {
        std::array<double, 3> sum{}, squares{};
        for (std::uint32_t first = 0; first < count; first += 8192) {
            rtcore::RayWave rays;
            std::vector<rtcore::SampleId> ids;
            for (std::uint32_t i = first; i < std::min(count, first + 8192); ++i) {
                const auto [origin, direction] = ray(i);
                rays.push({origin, 0, rtcore::normalize(direction), std::numeric_limits<float>::max()});
                ids.push_back({static_cast<std::uint16_t>(i), static_cast<std::uint16_t>(i >> 16), 0});
            }
            for (const rtcore::Colour c : trace(rays, ids, limits)) {
                const std::array<double, 3> values{c.r, c.g, c.b};
                for (std::size_t k = 0; k < 3; ++k) {
                    sum[k] += values[k];
                    squares[k] += values[k] * values[k];
                }
            }
        }
        PathMean result;
        for (std::size_t k = 0; k < 3; ++k) {
            result.mean[k] = sum[k] / count;
            const double variance = std::max(squares[k] / count - result.mean[k] * result.mean[k], 0.0);
            result.error[k] = std::sqrt(variance / count);
        }
        return result;
    }

    TracedScene traced;
    rtcore::RenderSettings settings;
    rtcore::MaterialTable materials;
    rtcore::LightSet lights;
};

/// Paths that end by their number of bounces alone.
inline PathLimits bouncesAlone(int bounces) {
    PathLimits limits;
    limits.bounces = bounces;
    limits.rouletteFrom = 1000;
    return limits;
}

/// The irradiance over pi of a convex polygon of radiance 1 at the origin, above whose horizon all of it is
/// (Lambert 1760).
template <std::size_t n>
double lambertSum(const std::array<std::array<double, 3>, n>& corners, std::array<double, 3> normal) {
    using V = std::array<double, 3>;
    const auto dot = [](const V& a, const V& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; };
    const auto cross = [](const V& a, const V& b) {
        return V{a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
    };
    double sum = 0;
    for (std::size_t i = 0; i < n; ++i) {
        const V &a = corners[i], &b = corners[(i + 1) % n];
        const V across = cross(a, b);
        const double size = std::sqrt(dot(across, across));
        sum += std::atan2(size, dot(a, b)) * dot(across, normal) / size;
    }
    return std::abs(sum) / (2 * kPi);
}

/// That lights alone, scattered rays alone and both together see `expected` within 5 standard errors, and
/// `more`.
inline void expectLight(const PathScene& scene, rtcore::Vec3 eye, rtcore::Vec3 direction,
                        std::uint32_t samples, PathLimits limits, double expected, const std::string& what,
                        double more = 0) {
    using rtcore::SamplingStrategy;
    for (const SamplingStrategy strategy :
         {SamplingStrategy::Both, SamplingStrategy::NextEvent, SamplingStrategy::ScatteredRays}) {
        limits.strategy = strategy;
        const PathMean seen = scene.see(eye, direction, samples, limits);
        EXPECT_NEAR(seen.mean[0], expected, 5 * seen.error[0] + 1e-5 + more)
            << what << ", found by " << static_cast<int>(strategy);
    }
}

} // namespace test
