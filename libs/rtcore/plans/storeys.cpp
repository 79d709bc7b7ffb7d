#include "rtcore/plans/storeys.h"

#include "rtcore/scene/part_list.h"
#include "rtcore/sections/cut_plane.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace rtcore {

namespace {

constexpr double kBin = 0.05;      ///< metres
constexpr double kApart = 2;       ///< metres between floors, at least
constexpr double kHeadroom = 1.3;  ///< metres below the top of the model, at least
constexpr double kSmallest = 0.15; ///< of the area of the largest floor
constexpr double kLevel = 0.996;   ///< cosine of what a floor may lean

struct Level {
    double height, area;
};

/// Of the faces that look up.
std::vector<Level> levelsOf(const Scene& scene, double& top) {
    const Mesh& mesh = scene.model.mesh;
    const Vec3d up = exact(scene.up);
    const std::vector<std::uint8_t> hidden = partTriangles(scene.model, scene.hiddenParts);
    std::vector<Level> levels;
    top = -1e300;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        if (!hidden.empty() && hidden[t] != 0) continue;
        Vec3d p[3];
        for (int k = 0; k < 3; ++k) {
            p[k] = exact(mesh.vertices[mesh.triangles[t].v[k]].position());
            top = std::max(top, dot(up, p[k]));
        }
        const Vec3d twice = cross(p[1] - p[0], p[2] - p[0]);
        const double area = length(twice) / 2;
        if (dot(up, twice) > kLevel * 2 * area) levels.push_back({dot(up, p[0] + p[1] + p[2]) / 3, area});
    }
    return levels;
}

} // namespace

std::vector<Storey> storeysOf(const Scene& scene) {
    double top = 0;
    std::vector<Level> levels = levelsOf(scene, top);
    const double metre = 1 / double{scene.metresPerUnit};
    std::erase_if(levels, [&](const Level& level) { return level.height > top - kHeadroom * metre; });
    std::ranges::sort(levels, {}, &Level::height);
    // A window of one bin from each level on: its area, and the mean height in it.
    std::vector<Storey> windows;
    double area = 0, moment = 0;
    for (std::size_t first = 0, end = 0; first < levels.size(); ++first) {
        for (; end < levels.size() && levels[end].height <= levels[first].height + kBin * metre; ++end) {
            area += levels[end].area;
            moment += levels[end].area * levels[end].height;
        }
        if (area > 0) windows.push_back({moment / area, area});
        area -= levels[first].area;
        moment -= levels[first].area * levels[first].height;
    }
    std::ranges::stable_sort(windows, [](const Storey& a, const Storey& b) { return a.area > b.area; });
    std::vector<Storey> storeys;
    for (const Storey& window : windows) {
        if (window.area < kSmallest * windows[0].area) break;
        const bool apart = std::ranges::all_of(storeys, [&](const Storey& storey) {
            return std::fabs(storey.height - window.height) >= kApart * metre;
        });
        if (apart) storeys.push_back(window);
    }
    std::ranges::sort(storeys, {}, &Storey::height);
    return storeys;
}

} // namespace rtcore
