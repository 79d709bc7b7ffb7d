#include "rtcore/motion/clearance.h"

#include "rtcore/kernels/single_ray.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>

namespace rtcore {

namespace {

constexpr double kDiagonal = 0.577350269189625764509; // a side of a cube, seen along its diagonal
constexpr std::array<Vec3d, 14> kWays{{
    {1, 0, 0},
    {-1, 0, 0},
    {0, 1, 0},
    {0, -1, 0},
    {0, 0, 1},
    {0, 0, -1},
    {kDiagonal, kDiagonal, kDiagonal},
    {-kDiagonal, kDiagonal, kDiagonal},
    {kDiagonal, -kDiagonal, kDiagonal},
    {-kDiagonal, -kDiagonal, kDiagonal},
    {kDiagonal, kDiagonal, -kDiagonal},
    {-kDiagonal, kDiagonal, -kDiagonal},
    {kDiagonal, -kDiagonal, -kDiagonal},
    {-kDiagonal, -kDiagonal, -kDiagonal},
}};

} // namespace

double clearance(const KdTree& tree, const Mesh& mesh, const WorldFrame& frame, Vec3d eye) {
    const Vec3 from = frame.toScene(eye);
    std::array<double, kWays.size()> distances;
    std::transform(kWays.begin(), kWays.end(), distances.begin(), [&](Vec3d way) {
        Hit hit;
        const Ray ray{from, 0, frame.turnBack(way), std::numeric_limits<float>::max()};
        return intersect(tree, mesh, ray, hit) ? double{hit.t} * frame.metresPerUnit()
                                               : std::numeric_limits<double>::infinity();
    });
    const auto middle = distances.begin() + static_cast<std::ptrdiff_t>(distances.size() / 2);
    std::nth_element(distances.begin(), middle, distances.end());
    return *middle;
}

} // namespace rtcore
