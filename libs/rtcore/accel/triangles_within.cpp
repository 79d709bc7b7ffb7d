#include "rtcore/accel/triangles_within.h"

#include "rtcore/platform/task_errors.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>

namespace rtcore {

namespace {

struct RestCorner {
    double x, y, z;
};

RestCorner restBetween(const RestCorner& from, const RestCorner& to, double part) {
    return {from.x + (to.x - from.x) * part, from.y + (to.y - from.y) * part,
            from.z + (to.z - from.z) * part};
}

/// A triangle that half-spaces cut one after the other.
class TriangleRest {
  public:
    TriangleRest(const Mesh& mesh, std::uint32_t triangle) {
        for (int corner = 0; corner < 3; ++corner) {
            const Vec3 p = mesh.position(triangle, corner);
            points_.push_back({p.x, p.y, p.z});
        }
    }

    bool empty() const { return points_.empty(); }

    void cut(const HalfSpace& half, double margin) {
        const auto beyond = [&](const RestCorner& p) {
            return half.normal.x * p.x + half.normal.y * p.y + half.normal.z * p.z - half.offset - margin;
        };
        if (std::ranges::all_of(points_, [&](const RestCorner& p) { return beyond(p) <= 0; })) return;
        std::vector<RestCorner> kept;
        for (std::size_t i = 0; i < points_.size(); ++i) {
            const RestCorner &from = points_[i], &to = points_[(i + 1) % points_.size()];
            const double a = beyond(from), b = beyond(to);
            if (a <= 0) kept.push_back(from);
            if ((a < 0 && b > 0) || (a > 0 && b < 0)) kept.push_back(restBetween(from, to, a / (a - b)));
        }
        points_ = std::move(kept);
    }

  private:
    std::vector<RestCorner> points_;
};

/// All corners lie beyond one plane, or none beyond any: the rest need not be cut.
std::uint8_t isTriangleBeyond(const Mesh& mesh, std::uint32_t triangle, std::span<const HalfSpace> halves,
                              float margin) {
    bool cut = false;
    for (const HalfSpace& half : halves) {
        int beyond = 0;
        for (int corner = 0; corner < 3; ++corner)
            beyond += dot(half.normal, mesh.position(triangle, corner)) > half.offset + margin ? 1 : 0;
        if (beyond == 3) return 1;
        cut = cut || beyond > 0;
    }
    if (!cut || halves.size() == 1) return 0;
    TriangleRest left(mesh, triangle);
    for (const HalfSpace& half : halves) left.cut(half, margin);
    return left.empty() ? 1 : 0;
}

} // namespace

std::vector<std::uint8_t> trianglesBeyond(const Mesh& mesh, std::span<const HalfSpace> halves, float margin) {
    const auto count = static_cast<std::uint32_t>(mesh.triangles.size());
    std::vector<std::uint8_t> beyond(count);
    TaskErrors errors;
#pragma omp parallel for schedule(static)
    for (std::uint32_t i = 0; i < count; ++i)
        errors.guard([&] { beyond[i] = isTriangleBeyond(mesh, i, halves, margin); });
    errors.rethrow();
    return beyond;
}

} // namespace rtcore
