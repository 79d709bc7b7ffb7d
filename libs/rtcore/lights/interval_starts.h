/// Intervals whose lengths are probabilities, for sampleInterval() (environment_sampler-inl.h).
#pragma once

#include "rtcore/lights/environment_sampler.h"

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

namespace rtcore {

/// Appends where intervals begin that share out 2^kBits: one unit for each, the rest by weight; then where
/// the last one ends. The weights' sum is above 0.
inline void addStarts(std::span<const double> weights, std::vector<std::uint32_t>& starts) {
    double all = 0;
    for (const double weight : weights) all += weight;
    const double rest =
        static_cast<double>(1U << EnvironmentRows::kBits) - static_cast<double>(weights.size());
    double before = 0;
    std::uint32_t units = 0;
    for (const double weight : weights) {
        starts.push_back(static_cast<std::uint32_t>(std::min(before / all, 1.0) * rest) + units++);
        before += weight;
    }
    starts.push_back(1U << EnvironmentRows::kBits);
}

} // namespace rtcore
