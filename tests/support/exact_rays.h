/// Judges the answers of ray kernels by brute force over all triangles in double precision.
///
/// A kernel in single precision may err by a few units in the last place: so a triangle that a ray passes
/// within that error of an edge may be hit or missed, and both answers are right. Everything else is decided.
#pragma once

#include "rtcore/kernels/hit_distance.h"
#include "rtcore/kernels/one_surface.h"
#include "rtcore/kernels/ray_wave.h"
#include "rtcore/kernels/rounding.h"
#include "rtcore/scene/mesh.h"
#include "support/mesh_triangle.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

namespace test {

/// How far apart hits on one surface may be along a ray, in its own units.
inline float reachOfTies(const rtcore::Box3& bounds, const rtcore::Ray& ray) {
    float far = 0, size = 0, length = 0;
    for (int axis = 0; axis < 3; ++axis) {
        const float o = ray.origin[axis];
        far += std::max(std::fabs(bounds.lo[axis] - o), std::fabs(bounds.hi[axis] - o));
        size += std::max(std::fabs(bounds.lo[axis]), std::fabs(bounds.hi[axis]));
        length = std::max(length, std::fabs(ray.direction[axis]));
    }
    return rtcore::kDistanceError * (far + size) / length * rtcore::kTieFraction;
}

inline rtcore::SurfacePlane planeOf(const rtcore::Mesh& mesh, std::uint32_t triangle) {
    return {mesh.position(triangle, 0), mesh.position(triangle, 1), mesh.position(triangle, 2)};
}

/// The hit among all triangles by the kernels' own arithmetic, those of one surface told by the nearest: what
/// a tree must find, bit for bit.
inline bool bruteForce(const rtcore::Mesh& mesh, const rtcore::Ray& ray, rtcore::Hit& hit) {
    const rtcore::RayShear shear(ray.direction);
    std::vector<rtcore::Hit> all;
    rtcore::alongAxis(shear.kz, [&](auto kz) {
        for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) {
            rtcore::Hit one;
            one.t = std::min(ray.tMax, rtcore::kFarthestHit);
            if (testTriangle<kz>(mesh, i, ray, shear, one)) all.push_back(one);
        }
    });
    if (all.empty()) return false;
    const rtcore::Hit nearest = *std::ranges::min_element(all, {}, &rtcore::Hit::t); // of several the first
    const float last = nearest.t + reachOfTies(mesh.bounds(), ray);
    const rtcore::MetSurface surface(planeOf(mesh, nearest.triangle), ray);
    hit = nearest;
    for (const rtcore::Hit& one : all) {
        const bool isLower = one.triangle < hit.triangle && one.t <= last;
        if (isLower && surface.has(planeOf(mesh, one.triangle))) hit = one;
    }
    if (isNear(ray, hit, rtcore::nearLimit(mesh.bounds()))) refineDistance(mesh, ray, hit);
    return true;
}

enum class Contact {
    None,
    Edge, ///< within rounding of an edge
    Hit,
};

/// Where the line of a ray meets a triangle.
struct ExactContact {
    Contact contact = Contact::None;
    bool inside = false;        ///< by exact signs, edges included
    double tLow = 0, tHigh = 0; ///< equal but for triangles seen edge-on
    double tError = 0;          ///< the most that rounding may add to or take from it
};

class ExactRay {
  public:
    explicit ExactRay(const rtcore::Ray& ray) : ray_(ray) {
        const auto size = [&](int axis) { return std::fabs(ray.direction[axis]); };
        z_ = size(0) > size(1) ? (size(0) > size(2) ? 0 : 2) : (size(1) > size(2) ? 1 : 2);
        x_ = (z_ + 1) % 3;
        y_ = (z_ + 2) % 3;
        sx_ = double{ray.direction[x_]} / ray.direction[z_];
        sy_ = double{ray.direction[y_]} / ray.direction[z_];
    }

    ExactContact meet(const rtcore::Mesh& mesh, std::uint32_t triangle) const {
        std::array<Corner, 3> p;
        for (int i = 0; i < 3; ++i) p[static_cast<std::size_t>(i)] = corner(mesh.position(triangle, i));
        std::array<double, 3> edge{}; // opposite of each corner
        std::array<double, 3> error{};
        bool negative = false, positive = false, surelyNegative = false, surelyPositive = false;
        for (std::size_t i = 0; i < 3; ++i) {
            const Corner& a = p[(i + 2) % 3];
            const Corner& b = p[(i + 1) % 3];
            edge[i] = a.x * b.y - a.y * b.x;
            error[i] = kRounding * (a.sizeX * b.sizeY + a.sizeY * b.sizeX);
            negative |= edge[i] < 0;
            positive |= edge[i] > 0;
            surelyNegative |= edge[i] < -error[i];
            surelyPositive |= edge[i] > error[i];
        }
        ExactContact result;
        if (surelyNegative && surelyPositive) return result;
        result.contact = Contact::Hit;
        for (std::size_t i = 0; i < 3; ++i) {
            if (std::fabs(edge[i]) <= error[i]) result.contact = Contact::Edge;
        }
        result.inside = !(negative && positive) && edge[0] + edge[1] + edge[2] != 0;
        findDistance(p, edge, error, result);
        return result;
    }

  private:
    static constexpr double kRounding = 0x1p-21; ///< 4 roundings of 2^-24 each side, doubled

    struct Corner {
        double x, y, t;
        double sizeX, sizeY; ///< of the terms that x and y are the differences of
    };

    static void findDistance(const std::array<Corner, 3>& p, const std::array<double, 3>& edge,
                             const std::array<double, 3>& error, ExactContact& result) {
        const double low = std::min({p[0].t, p[1].t, p[2].t});
        const double high = std::max({p[0].t, p[1].t, p[2].t});
        const double sum = edge[0] + edge[1] + edge[2];
        result.tLow = low;
        result.tHigh = high;
        result.tError = kRounding * std::max(std::fabs(low), std::fabs(high));
        if (std::fabs(sum) < 4 * (error[0] + error[1] + error[2])) return;
        const double t =
            std::clamp((edge[0] * p[0].t + edge[1] * p[1].t + edge[2] * p[2].t) / sum, low, high);
        result.tLow = result.tHigh = t;
        for (std::size_t i = 0; i < 3; ++i) result.tError += 2 * error[i] * std::fabs((p[i].t - t) / sum);
    }

    Corner corner(rtcore::Vec3 position) const {
        const double ax = double{position[x_]} - ray_.origin[x_];
        const double ay = double{position[y_]} - ray_.origin[y_];
        const double az = double{position[z_]} - ray_.origin[z_];
        return {ax - sx_ * az, ay - sy_ * az, az / ray_.direction[z_], std::fabs(ax) + std::fabs(sx_ * az),
                std::fabs(ay) + std::fabs(sy_ * az)};
    }

    rtcore::Ray ray_;
    int x_ = 0, y_ = 0, z_ = 0;
    double sx_ = 0, sy_ = 0;
};

/// All that brute force knows of one ray.
struct ExactAnswer {
    static constexpr double kNone = std::numeric_limits<double>::infinity();

    double nearestSure = kNone;   ///< a hit inside [tMin, tMax] that none may miss; at most this far
    double nearestInside = kNone; ///< by exact signs, edges included
    bool anyPossible = false;     ///< some triangle may count as hit in [tMin, tMax]
};

inline ExactAnswer exactAnswer(const rtcore::Mesh& mesh, const rtcore::Ray& ray) {
    const ExactRay exact(ray);
    ExactAnswer answer;
    for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) {
        const ExactContact c = exact.meet(mesh, i);
        if (c.contact == Contact::None) continue;
        if (c.contact == Contact::Hit && c.tLow - c.tError >= ray.tMin && c.tHigh + c.tError <= ray.tMax) {
            answer.nearestSure = std::min(answer.nearestSure, c.tHigh + c.tError);
        }
        if (c.inside && c.tLow >= ray.tMin && c.tLow <= ray.tMax) {
            answer.nearestInside = std::min(answer.nearestInside, c.tLow);
        }
        answer.anyPossible |= c.tHigh + c.tError >= ray.tMin && c.tLow - c.tError <= ray.tMax;
    }
    return answer;
}

/// The fault of an answer to a closest-hit query; empty when there is none. `answer` belongs to the ray.
inline std::string faultOfClosest(const ExactAnswer& answer, const rtcore::Mesh& mesh, const rtcore::Ray& ray,
                                  bool found, const rtcore::Hit& hit) {
    const double nearest = answer.nearestSure;
    if (!found) return std::isinf(nearest) ? "" : "misses a hit at " + std::to_string(nearest);
    const ExactContact own = ExactRay(ray).meet(mesh, hit.triangle);
    if (own.contact == Contact::None) return "hits a triangle beside the ray";
    if (hit.t < own.tLow - own.tError || hit.t > own.tHigh + own.tError) {
        return "distance " + std::to_string(hit.t) + " instead of " + std::to_string(own.tLow);
    }
    if (nearest < hit.t) {
        return "hit at " + std::to_string(hit.t) + " behind one at " + std::to_string(nearest);
    }
    return "";
}

/// The fault of an answer to an any-hit query; empty when there is none. `answer` belongs to the ray.
inline std::string faultOfAny(const ExactAnswer& answer, bool occluded) {
    if (occluded) return answer.anyPossible ? "" : "occluded by nothing";
    return std::isinf(answer.nearestSure) ? "" : "misses a hit at " + std::to_string(answer.nearestSure);
}

} // namespace test
