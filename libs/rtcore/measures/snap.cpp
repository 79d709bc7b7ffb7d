#include "rtcore/measures/snap.h"

#include "rtcore/kernels/section_clip.h"
#include "rtcore/scene/part_list.h"
#include "rtcore/scene/sharp_edges.h"
#include "rtcore/sections/cut_plane.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <span>
#include <utility>
#include <vector>

namespace rtcore {

namespace {

Vec3 inFloat(Vec3d v) { return {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)}; }

/// Surfaces at the pointer and around it.
struct Sight {
    HitWave hits;
    RayWave rays;

    Sight(const RayTracer& shown, const CameraRays& camera, float x, float y, float reach) {
        constexpr int kAround = 8;
        rays.push(camera.at(x, y));
        for (const float radius : {reach / 2, reach}) {
            for (int i = 0; i < kAround; ++i) {
                const float angle = 0.785398163F * static_cast<float>(i);
                rays.push(camera.at(x + radius * std::cos(angle), y + radius * std::sin(angle)));
            }
        }
        shown.intersect(RayKind::Primary, rays, hits);
    }
};

struct SharpEdge {
    std::uint32_t low, high;
};

/// Sharp edges of the triangles that are seen, and of those around their corners.
class EdgesNear {
  public:
    EdgesNear(const Scene& scene, const Sight& sight) : mesh_(scene.model.mesh) {
        std::vector<std::uint8_t> marked(mesh_.vertices.size());
        for (std::size_t i = 0; i < sight.hits.size(); ++i) {
            if (!sight.hits.isHit(i) || sight.hits.triangle[i] >= mesh_.triangles.size()) continue;
            for (const std::uint32_t v : mesh_.triangles[sight.hits.triangle[i]].v) marked[v] = 1;
        }
        const std::vector<std::uint8_t> hidden = partTriangles(scene.model, scene.hiddenParts);
        Indices triangles, corners;
        for (std::uint32_t t = 0; t < mesh_.triangles.size(); ++t) {
            if (!hidden.empty() && hidden[t] != 0) continue;
            const auto& v = mesh_.triangles[t].v;
            if (marked[v[0]] == 0 && marked[v[1]] == 0 && marked[v[2]] == 0) continue;
            triangles.push_back(t);
            corners.insert(corners.end(), std::begin(v), std::end(v));
        }
        std::vector<HalfEdge> edges = halfEdges(corners, false);
        visitEdges(edges, [&](std::span<const HalfEdge> sides) {
            // All triangles at an edge are there if those at one of its ends are.
            const bool known = marked[sides[0].low] != 0 || marked[sides[0].high] != 0;
            if (known && isSharp(mesh_, sides, triangles)) add({sides[0].low, sides[0].high}, marked);
        });
    }

    const std::vector<SharpEdge>& edges() const { return edges_; }
    Vec3d position(std::uint32_t vertex) const { return exact(mesh_.vertices[vertex].position()); }

    /// Ends at which edges meet, or one of them bends or ends.
    Indices corners() const {
        Indices found;
        for (const auto& [vertex, others] : ends_)
            if (others.size() != 2 || !isStraight(vertex, others)) found.push_back(vertex);
        return found;
    }

  private:
    void add(const SharpEdge& edge, const std::vector<std::uint8_t>& marked) {
        edges_.push_back(edge);
        if (marked[edge.low] != 0) ends_[edge.low].push_back(edge.high);
        if (marked[edge.high] != 0) ends_[edge.high].push_back(edge.low);
    }

    bool isStraight(std::uint32_t vertex, const Indices& others) const {
        constexpr double kStraight = -0.9998; // within 1 degree
        const Vec3d a = normalize(position(others[0]) - position(vertex));
        return dot(a, normalize(position(others[1]) - position(vertex))) < kStraight;
    }

    const Mesh& mesh_;
    std::vector<SharpEdge> edges_;
    std::map<std::uint32_t, Indices> ends_; ///< of those whose edges are all known: their other ends
};

/// The point of a line that the image shows nearest to a pixel; nothing where the line is not all before the
/// camera.
std::optional<Vec3d> nearestOn(const CameraRays& camera, Vec3d a, Vec3d b,
                               const std::array<double, 2>& pixel) {
    const auto p = pixelOf(camera, inFloat(a)), q = pixelOf(camera, inFloat(b));
    if (!p || !q) return std::nullopt;
    const double dx = (*q)[0] - (*p)[0], dy = (*q)[1] - (*p)[1], square = dx * dx + dy * dy;
    if (!(square > 0)) return std::nullopt;
    const double part =
        std::clamp(((pixel[0] - (*p)[0]) * dx + (pixel[1] - (*p)[1]) * dy) / square, 0.0, 1.0);
    if (camera.parallel()) return a + (b - a) * part;
    // From a part of what is seen to one of the line (perspective).
    const Vec3d forward = exact(camera.forward()), eye = exact(camera.eye());
    const double nearA = dot(forward, a - eye), nearB = dot(forward, b - eye);
    return a + (b - a) * (part * nearA / (part * nearA + (1 - part) * nearB));
}

class Catcher {
  public:
    Catcher(const Scene& scene, const RayTracer& shown, const CameraRays& camera, float x, float y,
            float reach)
        : scene_(scene), shown_(shown), camera_(camera), pixel_{x, y}, reach_(reach),
          sight_(shown, camera, x, y, reach), near_(scene, sight_) {}

    std::optional<Snap> snap() const {
        for (const SnapKind kind : {SnapKind::Corner, SnapKind::Middle, SnapKind::Edge})
            if (const auto caught = nearest(kind)) return caught;
        if (!sight_.hits.isHit(0)) return std::nullopt;
        const Ray ray = sight_.rays.ray(0);
        return at(SnapKind::Face, ray.origin + ray.direction * sight_.hits.t[0], 0);
    }

  private:
    Snap at(SnapKind kind, Vec3 point, std::size_t hit) const {
        const std::uint32_t triangle = sight_.hits.triangle[hit];
        const Vec3 normal = normalize(scene_.mesh().geometricNormal(triangle));
        const bool faces = dot(normal, sight_.rays.ray(hit).direction) < 0;
        return {kind, point, faces ? normal : -normal, triangle};
    }

    std::vector<Vec3d> candidates(SnapKind kind) const {
        std::vector<Vec3d> points;
        if (kind == SnapKind::Corner)
            for (const std::uint32_t corner : near_.corners()) points.push_back(near_.position(corner));
        for (const SharpEdge& edge : near_.edges()) {
            const Vec3d a = near_.position(edge.low), b = near_.position(edge.high);
            if (kind == SnapKind::Middle) points.push_back((a + b) * 0.5);
            if (kind != SnapKind::Edge) continue;
            if (const auto point = nearestOn(camera_, a, b, pixel_)) points.push_back(*point);
        }
        return points;
    }

    std::optional<Snap> nearest(SnapKind kind) const {
        std::optional<Snap> caught;
        double limit = reach_;
        for (const Vec3d& candidate : candidates(kind)) {
            const Vec3 point = inFloat(candidate);
            const auto pixel = pixelOf(camera_, point);
            if (!pixel) continue;
            const double away = std::hypot((*pixel)[0] - pixel_[0], (*pixel)[1] - pixel_[1]);
            if (away > limit) continue;
            const auto hit = surfaceAt(point);
            if (!hit || !isSeen(point, sight_.hits.triangle[*hit])) continue;
            limit = away;
            caught = at(kind, point, *hit);
        }
        return caught;
    }

    /// The hit on a triangle that the point is a part of: of several the first.
    std::optional<std::size_t> surfaceAt(Vec3 point) const {
        const float rounding = 16 * roundingOf(shown_.bounds());
        for (std::size_t i = 0; i < sight_.hits.size(); ++i) {
            if (!sight_.hits.isHit(i)) continue;
            const Vec3 normal = normalize(scene_.mesh().geometricNormal(sight_.hits.triangle[i]));
            const Ray ray = sight_.rays.ray(i);
            const Vec3 hit = ray.origin + ray.direction * sight_.hits.t[i];
            if (std::fabs(dot(normal, point - hit)) <= rounding + 1e-5F * sight_.hits.t[i]) return i;
        }
        return std::nullopt;
    }

    bool isSeen(Vec3 point, std::uint32_t triangle) const {
        constexpr float kClose = 0.999F;
        const auto pixel = *pixelOf(camera_, point);
        Ray ray = camera_.at(static_cast<float>(pixel[0]), static_cast<float>(pixel[1]));
        ray.tMax = kClose * dot(point - ray.origin, ray.direction);
        RayWave rays;
        rays.push(ray);
        std::vector<std::uint8_t> occluded;
        shown_.occluded(RayKind::Primary, rays, occluded);
        return occluded[0] == 0 && (!clip().removes(point) || isUncut(triangle));
    }
    bool isUncut(std::uint32_t triangle) const {
        return scene_.uncutParts != nullptr && triangle < scene_.model.mesh.triangles.size() &&
               partTriangles(scene_.model, scene_.uncutParts)[triangle] != 0;
    }
    SectionClip clip() const { return SectionClip(scene_.sections, shown_.bounds()); }

    const Scene& scene_;
    const RayTracer& shown_;
    const CameraRays& camera_;
    std::array<double, 2> pixel_;
    float reach_;
    Sight sight_;
    EdgesNear near_;
};

} // namespace

std::optional<std::array<double, 2>> pixelOf(const CameraRays& camera, Vec3 point) {
    const auto [corner, right, down] = camera.plane();
    Vec3d seen = exact(point) - exact(camera.eye());
    if (!camera.parallel()) {
        const double ahead = dot(exact(camera.forward()), seen);
        if (!(ahead > 0)) return std::nullopt;
        seen = seen * (1 / ahead);
    }
    const Vec3d from = seen - exact(corner), across = exact(right), along = exact(down);
    return std::array{dot(from, across) / dot(across, across), dot(from, along) / dot(along, along)};
}

std::optional<Snap> snapAt(const Scene& scene, const RayTracer& shown, const CameraRays& camera, float x,
                           float y, float reach) {
    return Catcher(scene, shown, camera, x, y, reach).snap();
}

} // namespace rtcore
