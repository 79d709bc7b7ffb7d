/// Means of paths with their standard errors.
#pragma once

#include "rtcore/pathtracing/light_finding.h"
#include "rtcore/pathtracing/path_integrator.h"

#include "support/small_scene.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

namespace test {

/// Settings of paths, and what finds the light.
struct PathLimits : rtcore::PathSettings {
    rtcore::LightFinding finding = rtcore::LightFinding::Both;
};

/// Of independent samples.
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

    /// The radiance of each sample; all along the same rays, or one ray each.
    std::vector<rtcore::Colour> trace(const rtcore::RayWave& rays, std::vector<rtcore::SampleId> samples,
                                      const PathLimits& limits) const {
        rtcore::PathIntegrator integrator;
        rtcore::RenderSettings with = settings;
        with.path = limits;
        integrator.begin({traced.scene, traced.tracer, with, materials, lights, limits.finding});
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

} // namespace test
