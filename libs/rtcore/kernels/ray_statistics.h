/// How many rays of each kind were traced.
#pragma once

#include "rtcore/kernels/ray_wave.h"

#include <array>
#include <cstdint>

namespace rtcore {

struct RayStatistics {
    std::array<std::uint64_t, kRayKinds> rays{}; ///< by RayKind

    void count(RayKind kind, std::size_t number) { rays[static_cast<std::size_t>(kind)] += number; }
    std::uint64_t total() const {
        std::uint64_t sum = 0;
        for (const std::uint64_t n : rays) sum += n;
        return sum;
    }
    void add(const RayStatistics& other) {
        for (std::size_t i = 0; i < rays.size(); ++i) rays[i] += other.rays[i];
    }
};

} // namespace rtcore
