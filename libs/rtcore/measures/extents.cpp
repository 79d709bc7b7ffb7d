#include "rtcore/measures/extents.h"

#include "rtcore/kernels/section_clip.h"
#include "rtcore/scene/disjoint_sets.h"
#include "rtcore/scene/part_list.h"
#include "rtcore/scene/sharp_edges.h"

#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace rtcore {

namespace {

Vec3d cornerOf(const Mesh& mesh, std::uint32_t triangle, int corner) {
    const Vertex& v = mesh.vertices[mesh.triangles[triangle].v[corner]];
    return {v.x, v.y, v.z};
}

double areaOf(const Mesh& mesh, std::uint32_t triangle) {
    const Vec3d a = cornerOf(mesh, triangle, 0);
    return length(cross(cornerOf(mesh, triangle, 1) - a, cornerOf(mesh, triangle, 2) - a)) / 2;
}

/// Triangles in the plane of one, whichever side they look to.
Indices inPlaneOf(const Scene& scene, std::uint32_t triangle) {
    constexpr double kParallel = 0.99999; // within a quarter of a degree
    const Mesh& mesh = scene.model.mesh;
    const std::vector<std::uint8_t> hidden = partTriangles(scene.model, scene.hiddenParts);
    Box3 bounds;
    for (const Vertex& vertex : mesh.vertices) bounds.extend(vertex.position());
    const double near = 8 * double{roundingOf(bounds)};
    const Vec3d normal = exactNormal(mesh, triangle), at = cornerOf(mesh, triangle, 0);
    Indices found;
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
        if (!hidden.empty() && hidden[t] != 0) continue;
        bool inPlane = true;
        for (int k = 0; k < 3 && inPlane; ++k)
            inPlane = std::fabs(dot(normal, cornerOf(mesh, t, k) - at)) <= near;
        if (inPlane && std::fabs(dot(normal, exactNormal(mesh, t))) > kParallel) found.push_back(t);
    }
    return found;
}

} // namespace

double areaOfFace(const Scene& scene, std::uint32_t triangle) {
    const Mesh& mesh = scene.model.mesh;
    if (triangle >= mesh.triangles.size()) return 0; // of the ground
    const Indices triangles = inPlaneOf(scene, triangle);
    DisjointSets sets(mesh.vertices.size());
    for (const std::uint32_t t : triangles) {
        const auto& v = mesh.triangles[t].v;
        sets.join(v[0], v[1]);
        sets.join(v[0], v[2]);
    }
    const std::uint32_t own = sets.find(mesh.triangles[triangle].v[0]);
    double area = 0;
    for (const std::uint32_t t : triangles)
        if (sets.find(mesh.triangles[t].v[0]) == own) area += areaOf(mesh, t);
    return area;
}

std::optional<double> volumeOf(const Model& model, std::span<const std::uint32_t> parts,
                               ClosedPieces& pieces) {
    double volume = 0;
    for (const std::uint32_t part : parts) {
        const std::uint32_t first = model.parts[part].firstTriangle;
        for (std::size_t r = 0; r < pieces.ranges().size(); ++r) {
            if (pieces.ranges()[r].part != part) continue;
            const std::vector<std::uint8_t>& closed = pieces.of(r);
            double sum = 0;
            const Vec3d zero = closed.empty() ? Vec3d{} : cornerOf(model.mesh, first, 0);
            for (std::uint32_t i = 0; i < closed.size(); ++i) {
                if (closed[i] == 0) return std::nullopt;
                const auto at = [&](int corner) { return cornerOf(model.mesh, first + i, corner) - zero; };
                sum += dot(at(0), cross(at(1), at(2))) / 6;
            }
            volume += std::fabs(sum);
        }
    }
    return volume;
}

std::optional<double> clearanceFrom(const RayTracer& shown, Vec3 point, Vec3 direction) {
    const float clearance = 4 * roundingOf(shown.bounds());
    RayWave rays;
    HitWave hits;
    rays.push({point, clearance, direction, std::numeric_limits<float>::max()});
    shown.intersect(RayKind::Primary, rays, hits);
    return hits.isHit(0) ? std::optional(double{hits.t[0]}) : std::nullopt;
}

} // namespace rtcore
