/// Rays that wait to be traced, and what each is for.
#pragma once

#include "rtcore/kernels/ray_wave.h"
#include "rtcore/math/colour.h"

#include <algorithm>
#include <cstdint>
#include <vector>

namespace rtcore {

struct Path {
    std::uint32_t sample = 0; ///< index of the primary ray it began with
    Colour weight{1, 1, 1};   ///< share of its radiance that reaches the sample
    Colour extinction;        ///< of the solid that it is inside of, per scene unit
    std::uint16_t depth = 0;  ///< mirrored or refracted so often
    std::uint16_t passes = 0; ///< went straight through thin walls and holes so often
};

struct PathQueue {
    RayWave rays;
    std::vector<Path> paths; ///< one per ray

    std::size_t size() const { return paths.size(); }
    bool empty() const { return paths.empty(); }
    void clear() {
        rays.clear();
        paths.clear();
    }
    void push(const Ray& ray, const Path& path) {
        rays.push(ray);
        paths.push_back(path);
    }
    /// Moves the last `count` (or all, when there are fewer) into `taken`, whose content is replaced.
    void takeLast(std::size_t count, PathQueue& taken) {
        taken.clear();
        const std::size_t keep = size() - std::min(count, size());
        for (std::size_t i = keep; i < size(); ++i) taken.push(rays.ray(i), paths[i]);
        rays.resize(keep);
        paths.resize(keep);
    }
};

} // namespace rtcore
